// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/accessor.hpp>
#include <arcspan_tools/mesh/gltf/gltf_skin.hpp>

#include <optional>

namespace arcspan::tools {
namespace {

constexpr Affine kZero{{}, {}, {}, {}};

void add(Affine& sum, const Affine& a, double weight) {
  sum.x = sum.x + a.x * weight;
  sum.y = sum.y + a.y * weight;
  sum.z = sum.z + a.z * weight;
  sum.translation = sum.translation + a.translation * weight;
}

Affine affine_of(const double* m) {
  return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

}  // namespace

std::vector<Affine> read_joints(GltfFile& file, const JsonView& id, const NodeTransforms& nodes) {
  const JsonView skin = file.element("skins", id);
  const JsonView joints = skin.at("joints");
  const std::optional<JsonView> bind = skin.find("inverseBindMatrices");
  std::optional<AccessorData> matrices;
  if (bind) matrices = read_accessor(file, *bind, 16, 16);
  if (matrices && matrices->count() < joints.size()) bind->fail("has fewer elements than there are joints");
  std::vector<Affine> all;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto node = nodes.find(file.element("nodes", joints.element(i)).place());
    if (node == nodes.end()) joints.element(i).fail("is a node that is not in the scene");
    all.push_back(matrices ? node->second * affine_of(matrices->element(i)) : node->second);
  }
  return all;
}

std::vector<Affine> blended_joints(GltfFile& file, const JsonView& attributes,
                                   const std::vector<Affine>& joints, std::size_t vertices) {
  std::vector<Affine> sums;
  std::vector<double> weights(vertices);
  for (int set = 0;; ++set) {
    const std::optional<JsonView> joint_id = attributes.find("JOINTS_" + std::to_string(set));
    const std::optional<JsonView> weight_id = attributes.find("WEIGHTS_" + std::to_string(set));
    if (!joint_id || !weight_id) break;
    sums.resize(vertices, kZero);
    const AccessorData of = read_accessor(file, *joint_id, 4, 4);
    const AccessorData by = read_accessor(file, *weight_id, 4, 4);
    if (of.count() < vertices) joint_id->fail("has fewer elements than there are positions");
    if (by.count() < vertices) weight_id->fail("has fewer elements than there are positions");
    for (std::size_t i = 0; i < 4 * vertices; ++i) {
      const double joint = of.values[i];
      const double weight = by.values[i];
      if (weight == 0) continue;
      if (!(joint >= 0 && joint < static_cast<double>(joints.size())))
        joint_id->fail("a joint is out of range");
      add(sums[i / 4], joints[static_cast<std::size_t>(joint)], weight);
      weights[i / 4] += weight;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Affine sum = sums[i];
    sums[i] = kZero;
    add(sums[i], weights[i] == 0 ? Affine{} : sum, weights[i] == 0 ? 1 : 1 / weights[i]);
  }
  return sums;
}

}  // namespace arcspan::tools
