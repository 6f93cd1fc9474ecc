// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/gltf_vertices.hpp>

namespace arcspan::tools {
namespace {

/// Numbers that are not finite are 0, as the normals of faces are.
Vec3 finite_or_zero(const std::optional<AccessorData>& data, std::size_t i) {
  const Vec3 v = data ? data->vec3(i) : Vec3{};
  return finite(v) ? v : Vec3{};
}

}  // namespace

GltfVertices::GltfVertices(GltfFile& file, const JsonView& primitive, const AccessorData& positions,
                           const std::optional<AccessorData>& normals, std::size_t joints)
    : positions_(positions), normals_(normals) {
  const std::size_t vertices = positions.count();
  if (joints > 0) weights_.emplace(file, primitive.at("attributes"), vertices, joints);
  const std::optional<JsonView> targets = primitive.find("targets");
  const std::size_t count = targets ? targets->size() : 0;
  if (count > kMostMorphTargets)
    targets->fail("has more than " + std::to_string(kMostMorphTargets) + " morph targets");
  for (std::size_t i = 0; i < count; ++i) {
    const JsonView json = targets->element(i);
    const auto deltas = [&](const char* name) -> std::optional<AccessorData> {
      const std::optional<JsonView> id = json.find(name);
      if (!id) return std::nullopt;
      AccessorData data = read_accessor(file, *id, 3, 3);
      if (data.count() < vertices) id->fail("has fewer elements than there are positions");
      return data;
    };
    targets_.push_back({deltas("POSITION"), deltas("NORMAL")});
  }
}

RigVertex GltfVertices::vertex(std::size_t index, std::size_t instance) const {
  RigVertex vertex;
  vertex.instance = instance;
  vertex.position = positions_.vec3(index);
  vertex.normal = finite_or_zero(normals_, index);
  if (weights_) weights_->bind(index, vertex);
  for (const Target& target : targets_)
    vertex.deltas.push_back({finite_or_zero(target.positions, index), finite_or_zero(target.normals, index)});
  return vertex;
}

}  // namespace arcspan::tools
