// SPDX-License-Identifier: MIT
#include <arcspan/mesh/make_face_planes.hpp>
#include <arcspan/mesh/packed_normal.hpp>

#include <arcspan_tools/fixed_point/curve_room.hpp>
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/fixed_point/rounding.hpp>
#include <arcspan_tools/mesh/plain/subset.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {
namespace {

Box box_of(const MeshData& mesh) {
  Box box{mesh.positions[0], mesh.positions[0]};
  for (const Vec3& p : mesh.positions) box = joined(box, {p, p});
  return box;
}

std::int16_t to_unit(double length, double unit) { return static_cast<std::int16_t>(rounded(length / unit)); }

PackedNormal packed(Vec3 normal) {
  const auto component = [](double c) {
    return static_cast<std::int32_t>(rounded(std::ldexp(c, 30) * 0.9999));
  };
  return pack_normal(component(normal.x), component(normal.y), component(normal.z));
}

/// The point near the middle of all from which a texture looks as it does from 0.
Uv origin_of(const std::vector<Uv>& points, const TextureSampler& sampler) {
  Uv low = points[0];
  Uv high = points[0];
  for (const Uv& p : points) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  const auto origin = [](TextureWrap wrap, double middle) {
    if (wrap == TextureWrap::kClamp) return 0.0;
    return wrap == TextureWrap::kMirror ? 2 * std::floor(middle / 2) : std::floor(middle);
  };
  return {origin(sampler.u, (low.u + high.u) / 2), origin(sampler.v, (low.v + high.v) / 2)};
}

void set_texture_points(const std::vector<Uv>& points, const TextureSampler& sampler, FixedMesh& fixed) {
  if (points.empty()) return;
  const Uv origin = origin_of(points, sampler);
  double farthest = 0;
  for (const Uv& p : points) {
    farthest = std::max({farthest, std::abs(p.u - origin.u), std::abs(p.v - origin.v)});
  }
  constexpr double kMost = 32767;
  int bits = TextureScale::kMostBits;
  while (bits > TextureScale::kLeastBits && std::ldexp(farthest, bits) > kMost) --bits;
  fixed.texture_scale.fraction_bits = static_cast<std::uint8_t>(bits);
  for (const Uv& p : points) {
    fixed.texture_points.push_back({static_cast<std::int16_t>(rounded(std::ldexp(p.u - origin.u, bits))),
                                    static_cast<std::int16_t>(rounded(std::ldexp(p.v - origin.v, bits)))});
  }
}

FixedMesh fixed_within(const Box& box, const MeshData& mesh, const TextureSampler& sampler = {}) {
  constexpr double kSteps = 65534;  // -32767...32767
  const Vec3 extent = box.high - box.low;
  FixedMesh fixed;
  fixed.centre = (box.low + box.high) * 0.5;
  const double largest = std::max({extent.x, extent.y, extent.z});
  fixed.unit = (largest > 0 ? largest : 1) / kSteps;  // a pose may leave a single point
  for (const Vec3& p : mesh.positions) {
    const Vec3 from_centre = p - fixed.centre;
    fixed.positions.push_back({to_unit(from_centre.x, fixed.unit), to_unit(from_centre.y, fixed.unit),
                               to_unit(from_centre.z, fixed.unit)});
  }
  for (const Vec3& n : mesh.normals) fixed.normals.push_back(packed(n));
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) fixed.indices.push_back(static_cast<std::uint16_t>(index));
  }
  set_texture_points(mesh.texture_points, sampler, fixed);
  fixed.colours = mesh.colours;
  fixed.sources = mesh.sources;
  return fixed;
}

}  // namespace

std::size_t FixedModel::vertex_count() const {
  std::size_t count = 0;
  for (const FixedMesh& mesh : meshes) count += mesh.positions.size();
  return count;
}

std::size_t FixedModel::triangle_count() const {
  std::size_t count = 0;
  for (const FixedMesh& mesh : meshes) count += mesh.indices.size() / 3;
  return count;
}

std::size_t FixedModel::bytes() const {
  std::size_t sum = 0;
  for (const FixedMesh& mesh : meshes) sum += mesh.bytes();
  return sum;
}

Box joined(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

Box box_of(const Model& model) {
  Box box = box_of(model.parts[0].mesh);
  for (const ModelPart& part : model.parts) box = joined(box, box_of(part.mesh));
  return box;
}

FixedMesh to_fixed(const MeshData& mesh) { return fixed_within(box_of(mesh), mesh); }

FixedModel to_fixed(const Model& model) {
  const Box box = model.reach.value_or(box_of(model));
  return to_fixed(model, model.has_curves ? with_curves(box, model) : box);
}

FixedModel to_fixed(const Model& model, const Box& box) {
  FixedModel fixed;
  fixed.rig = model.rig;
  for (const ModelPart& part : model.parts) {
    for (const MeshData& piece : in_pieces(part.mesh, kMaxVertices)) {
      fixed.meshes.push_back(fixed_within(box, piece, part.look.material.sampler));
      fixed.looks.push_back(part.look);
    }
  }
  return fixed;
}

MeshView FixedMesh::view(const std::string& subject) const {
  MeshView view;
  Status status = MeshView::make(positions, normals, std::span(indices), view);
  if (ok(status) && !planes.empty()) status = view.attach(planes, plane_scale);
  if (ok(status) && !texture_points.empty()) status = view.attach(texture_points, texture_scale);
  if (ok(status) && !colours.empty()) status = view.attach(colours);
  if (!ok(status))
    throw Failure(subject, std::string("not a mesh for the pipeline (") + to_string(status) + ")");
  return view;
}

FixedMesh with_planes(FixedMesh mesh, const std::string& subject) {
  mesh.planes.clear();
  const MeshView plain = mesh.view(subject);
  mesh.planes.resize(plain.triangle_count());
  static_cast<void>(make_face_planes(plain, mesh.planes, mesh.plane_scale));  // there is memory for all
  return mesh;
}

}  // namespace arcspan::tools
