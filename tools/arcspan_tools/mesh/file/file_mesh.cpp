// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/file_mesh.hpp>
#include <arcspan_tools/mesh/plain/triangulate.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace arcspan::tools {
namespace {

/// Display values 0...1. Those of OBJ and of PLY with floats are 0...1 already, or 0...255 in the files of
/// some programs: if any channel is above 1, all are divided by 255. An empty list if there is no colour at
/// all.
std::vector<std::optional<Vec3>> scaled(std::vector<std::optional<Vec3>> colours) {
  bool any = false;
  double scale = 1;
  for (const std::optional<Vec3>& c : colours) {
    any = any || c.has_value();
    if (c && std::max({c->x, c->y, c->z}) > 1) scale = 1.0 / 255;
  }
  if (!any) return {};
  const auto channel = [scale](double v) { return std::clamp(v * scale, 0.0, 1.0); };
  for (std::optional<Vec3>& c : colours) {
    if (c) c = Vec3{channel(c->x), channel(c->y), channel(c->z)};
  }
  return colours;
}

}  // namespace

void TriangleCount::add_face(std::size_t corners) {
  triangles_ += corners - 2;
  if (triangles_ <= kMaxTriangles) return;
  throw Failure(subject_, "too many triangles (more than " + std::to_string(kMaxTriangles) + ", the limit)");
}

void FileMesh::add_face(std::span<const Corner> corners, const FaceLook& look) {
  if (corners.size() < 3) return left_out.add("faces with fewer than three corners");
  count_.add_face(corners.size());
  faces_.push_back({corners_.size(), corners.size(), look});
  corners_.insert(corners_.end(), corners.begin(), corners.end());
}

Vec3 FileMesh::as_floats(const Vec3& v) {
  const auto rounded = [](double value) { return double{static_cast<float>(value)}; };
  return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

bool FileMesh::fits_floats() const {
  constexpr double kMostExtents = 64;  // there a step of floats is 1/4 of a step of 16 bits
  Vec3 low = position(corners_[0].position);
  Vec3 high = low;
  double farthest = 0;
  for (const Corner& corner : corners_) {
    const Vec3& p = position(corner.position);
    for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      low.*axis = std::min(low.*axis, p.*axis);
      high.*axis = std::max(high.*axis, p.*axis);
      farthest = std::max(farthest, std::fabs(p.*axis));
    }
  }
  const Vec3 extent = high - low;
  return farthest <= kMostExtents * std::max({extent.x, extent.y, extent.z});
}

const Vec3& FileMesh::position(std::uint32_t index) const {
  if (const auto wrong = wrong_.find(index); wrong != wrong_.end()) throw Failure(wrong->second);
  return positions_[index];
}

RawMesh::Corner FileMesh::raw(const Corner& corner) const {
  RawMesh::Corner raw{positions_[corner.position], {}};
  if (corner.normal != kNone && normals[corner.normal]) raw.normal = as_floats(*normals[corner.normal]);
  if (corner.texture_point != kNone) raw.texture_point = texture_points[corner.texture_point];
  return raw;
}

TriangleColour FileMesh::colour_of(const Face& face, const std::array<std::uint32_t, 3>& corners) {
  if (face.look.colour) return {true, {*face.look.colour, *face.look.colour, *face.look.colour}};
  if (colours.empty()) return {};
  TriangleColour colour;
  std::size_t known = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<Vec3>& own = colours[corners_[face.first + corners[i]].position];
    if (own) colour.corners[i] = *own;
    known += own.has_value();
  }
  colour.known = known == 3;
  if (known > 0 && known < 3) left_out.add("vertex colours on some corners of a triangle only");
  return colour;
}

void FileMesh::scale_colours() {
  colours = scaled(std::move(colours));
  std::vector<std::optional<Vec3>> of_faces;
  for (const Face& face : faces_) of_faces.push_back(face.look.colour);
  of_faces = scaled(std::move(of_faces));
  for (std::size_t i = 0; i < of_faces.size(); ++i) faces_[i].look.colour = of_faces[i];
}

RawModel FileMesh::model(std::vector<PartLook> looks, std::vector<std::string> warnings) {
  if (faces_.empty()) throw Failure(subject_, "no faces");
  scale_colours();
  if (fits_floats()) std::ranges::transform(positions_, positions_.begin(), as_floats);
  RawModel model;
  std::vector<Vec3> polygon;
  for (const Face& face : faces_) {
    polygon.clear();
    for (std::size_t i = 0; i < face.size; ++i)
      polygon.push_back(position(corners_[face.first + i].position));
    for (const std::array<std::uint32_t, 3>& t : triangulated(polygon)) {
      const auto corner = [&](std::size_t i) { return raw(corners_[face.first + t[i]]); };
      model.mesh.triangles.push_back({corner(0), corner(1), corner(2)});
      model.mesh.smoothing.push_back(face.look.smoothing);
      model.look_of.push_back(face.look.look);
      model.colours.push_back(colour_of(face, t));
    }
  }
  left_out.add("positions that are not finite numbers, which no face uses", wrong_.size());
  model.looks = std::move(looks);
  model.warnings = std::move(warnings);
  left_out.warn(model.warnings);
  return model;
}

}  // namespace arcspan::tools
