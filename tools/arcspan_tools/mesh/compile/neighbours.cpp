// SPDX-License-Identifier: MIT
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/mesh/packed_normal.hpp>

#include <arcspan_tools/mesh/compile/neighbours.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

namespace arcspan::tools {
namespace {

constexpr std::size_t kCorners = 3;

/// A corner of the mesh that begins an edge: triangle 3 i / 3, edge i % 3.
using Corner = std::size_t;

/// The number of the first vertex at the same position, for every vertex.
std::vector<std::size_t> first_at_position(const FixedMesh& mesh) {
  std::map<std::array<std::int16_t, 3>, std::size_t> found;
  std::vector<std::size_t> first;
  for (const ObjectPosition& p : mesh.positions)
    first.push_back(found.try_emplace({p.x, p.y, p.z}, first.size()).first->second);
  return first;
}

Corner next_corner(Corner corner) { return corner % kCorners == 2 ? corner - 2 : corner + 1; }

/// Pairs of corners whose edges are the same.
class Pairs {
 public:
  explicit Pairs(const FixedMesh& mesh) : other_(mesh.indices.size()) {
    const std::vector<std::size_t> first = first_at_position(mesh);
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Corner>> open;  // without a partner so far
    for (Corner corner = 0; corner < mesh.indices.size(); ++corner) {
      const std::size_t from = first[mesh.indices[corner]];
      const std::size_t to = first[mesh.indices[next_corner(corner)]];
      if (from == to) continue;
      std::vector<Corner>& candidates = open[{to, from}];
      // The latest one, which is most likely of the same surface, and near in the array.
      if (candidates.empty() || candidates.back() / kCorners == corner / kCorners) {
        open[{from, to}].push_back(corner);
        continue;
      }
      other_[corner] = candidates.back();
      other_[candidates.back()] = corner;
      candidates.pop_back();
    }
  }

  [[nodiscard]] const std::optional<Corner>& other(Corner corner) const { return other_[corner]; }

 private:
  std::vector<std::optional<Corner>> other_;
};

double cosine(const PackedNormal& a, const PackedNormal& b) {
  const Direction u = unpack_normal(a);
  const Direction v = unpack_normal(b);
  const auto product = [](auto p, auto q) { return double(p.raw()) * double(q.raw()); };
  const auto dot = [&](const Direction& p, const Direction& q) {
    return product(p.x, q.x) + product(p.y, q.y) + product(p.z, q.z);
  };
  return dot(u, v) / std::sqrt(dot(u, u) * dot(v, v));
}

/// Whether light or colour breaks between two vertices at one position.
bool breaks(const FixedMesh& mesh, std::size_t a, std::size_t b, double least_cosine) {
  if (a == b) return false;
  if (!mesh.colours.empty() && !(mesh.colours[a] == mesh.colours[b])) return true;
  return cosine(mesh.normals[a], mesh.normals[b]) < least_cosine;
}

bool is_crease(const FixedMesh& mesh, Corner one, Corner other, double least_cosine) {
  return breaks(mesh, mesh.indices[one], mesh.indices[next_corner(other)], least_cosine) ||
         breaks(mesh, mesh.indices[next_corner(one)], mesh.indices[other], least_cosine);
}

void put_distance(std::vector<std::uint8_t>& out, std::size_t distance) {
  for (--distance; distance >= 128; distance >>= 7) out.push_back(static_cast<std::uint8_t>(distance | 128u));
  out.push_back(static_cast<std::uint8_t>(distance));
}

/// Sets bits 6 and 7 of a triangle's byte, which is followed by its distances.
void mark_short_distances(std::vector<std::uint8_t>& out, std::size_t kinds_at) {
  const unsigned kinds = out[kinds_at];
  std::size_t distances = 0;
  for (unsigned edge = 0; edge < kCorners; ++edge)
    distances += static_cast<std::size_t>(detail::has_distance(detail::edge_kind(kinds, edge)));
  if (detail::has_ordinary_edges(kinds) && out.size() == kinds_at + 1 + distances)
    out[kinds_at] = static_cast<std::uint8_t>(kinds | (distances << 6));
}

}  // namespace

std::vector<std::uint8_t> neighbours_of(const FixedMesh& mesh, double degrees) {
  const Pairs pairs(mesh);
  const double least_cosine = std::cos(degrees * std::numbers::pi / 180);
  std::vector<std::uint8_t> out;
  for (Corner first = 0; first < mesh.indices.size(); first += kCorners) {
    const std::size_t kinds_at = out.size();
    out.push_back(0);
    for (std::size_t edge = 0; edge < kCorners; ++edge) {
      const std::optional<Corner>& other = pairs.other(first + edge);
      EdgeKind kind = EdgeKind::kBorder;
      if (other && *other < first) {
        kind = EdgeKind::kEarlier;
      } else if (other) {
        kind = is_crease(mesh, first + edge, *other, least_cosine) ? EdgeKind::kCrease : EdgeKind::kLater;
        put_distance(out, (*other - first) / kCorners);
      }
      out[kinds_at] = static_cast<std::uint8_t>(out[kinds_at] | (static_cast<unsigned>(kind) << (2 * edge)));
    }
    mark_short_distances(out, kinds_at);
  }
  return out;
}

FixedMesh with_neighbours(FixedMesh mesh, const std::string& subject) {
  mesh.neighbours = neighbours_of(mesh);
  MeshNeighbours checked;
  const Status status = MeshNeighbours::make(mesh.view(subject), mesh.neighbours, checked);
  if (!ok(status))
    throw Failure(subject, std::string("the neighbours of triangles are wrong (") + to_string(status) + ")");
  return mesh;
}

FixedModel with_neighbours(FixedModel model, const std::string& subject) {
  for (FixedMesh& mesh : model.meshes) mesh = with_neighbours(std::move(mesh), subject);
  return model;
}

}  // namespace arcspan::tools
