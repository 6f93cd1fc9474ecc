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

std::array<std::uint32_t, 3> GltfVertices::add_triangle(const std::array<std::size_t, 3>& indices,
                                                        std::size_t instance, RigVertices& rig) {
  std::array<std::uint32_t, 3> numbers{};
  if (!normals_ && !targets_.empty()) {
    std::array<RigVertex, 3> corners{vertex(indices[0], instance), vertex(indices[1], instance),
                                     vertex(indices[2], instance)};
    add_flat_normals(corners);
    for (std::size_t i = 0; i < 3; ++i) numbers[i] = rig.add(corners[i]);
    return numbers;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [found, is_new] = known_.try_emplace(indices[i]);
    if (is_new) found->second = rig.add(vertex(indices[i], instance));
    numbers[i] = found->second;
  }
  return numbers;
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
