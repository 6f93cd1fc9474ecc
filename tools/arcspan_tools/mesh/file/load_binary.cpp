// SPDX-License-Identifier: MIT
#include <arcspan/mesh/mesh_binary.hpp>

#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <cmath>
#include <cstring>

namespace arcspan::tools {
namespace {

Vec3 to_vec3(const ObjectPosition& p) { return {double(p.x), double(p.y), double(p.z)}; }

Vec3 to_vec3(const Direction& d) {
  const auto component = [](DirectionComponent c) {
    return std::ldexp(c.raw(), -DirectionComponent::kFraction);
  };
  return normalised(Vec3{component(d.x), component(d.y), component(d.z)});
}

}  // namespace

MeshData mesh_from_binary(std::string_view bytes, const std::string& subject) {
  if (bytes.empty()) throw Failure(subject, "empty file");
  // Words, for the alignment that a string need not have.
  std::vector<std::uint16_t> words((bytes.size() + 1) / 2);
  if (!bytes.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
  MeshView view;
  const Status status =
      view_mesh_binary({reinterpret_cast<const std::uint8_t*>(words.data()), bytes.size()}, view);
  if (status == Status::kUnsupported) throw Failure(subject, "not a mesh binary of version 1 or 2");
  if (!ok(status))
    throw Failure(subject, std::string("the mesh binary is damaged (") + to_string(status) + ")");
  if (view.triangle_count() > kMaxTriangles) {
    throw Failure(subject, "too many triangles (more than " + std::to_string(kMaxTriangles) + ", the limit)");
  }
  if (view.triangle_count() == 0) throw Failure(subject, "no faces");
  MeshData mesh;
  for (std::size_t i = 0; i < view.vertex_count(); ++i) {
    mesh.positions.push_back(to_vec3(view.position(i)));
    mesh.normals.push_back(to_vec3(unpack_normal(view.normal(i))));
  }
  for (std::size_t i = 0; i < view.triangle_count(); ++i) {
    const TriangleIndices t = view.triangle(i);
    mesh.triangles.push_back({t.a, t.b, t.c});
  }
  return mesh;
}

}  // namespace arcspan::tools
