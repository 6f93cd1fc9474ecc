// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/gltf_skin.hpp>

#include <cmath>
#include <optional>

namespace arcspan::tools {

RigSkin read_gltf_skin(GltfFile& file, const JsonView& id, const GltfNodes& nodes) {
  const JsonView json = file.element("skins", id);
  const JsonView joints = json.at("joints");
  const std::optional<JsonView> bind = json.find("inverseBindMatrices");
  std::optional<AccessorData> matrices;
  if (bind) matrices = read_accessor(file, *bind, 16, 16);
  if (matrices && matrices->count() < joints.size()) bind->fail("has fewer elements than there are joints");
  if (joints.size() == 0) joints.fail("is empty");
  RigSkin skin;
  skin.name = json.text_or("name", "");
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto node = nodes.places.find(file.element("nodes", joints.element(i)).place());
    if (node == nodes.places.end()) joints.element(i).fail("is a node that is not in the scene");
    skin.joints.push_back(node->second);
    skin.inverse_bind.push_back(matrices ? affine_of(matrices->element(i)) : Affine{});
    const Affine& m = skin.inverse_bind.back();
    if (!(finite(m.x) && finite(m.y) && finite(m.z) && finite(m.translation)))
      bind->fail("matrix " + std::to_string(i) + " has a number that is not finite");
  }
  return skin;
}

GltfWeights::GltfWeights(GltfFile& file, const JsonView& attributes, std::size_t vertices, std::size_t joints)
    : joint_count_(joints) {
  for (int set = 0;; ++set) {
    const std::optional<JsonView> joint_id = attributes.find("JOINTS_" + std::to_string(set));
    const std::optional<JsonView> weight_id = attributes.find("WEIGHTS_" + std::to_string(set));
    if (!joint_id || !weight_id) break;
    const Set& read =
        sets_.emplace_back(Set{read_accessor(file, *joint_id, 4, 4), read_accessor(file, *weight_id, 4, 4)});
    if (read.joints.count() < vertices) joint_id->fail("has fewer elements than there are positions");
    if (read.weights.count() < vertices) weight_id->fail("has fewer elements than there are positions");
    for (std::size_t i = 0; i < 4 * vertices; ++i) {
      const double joint = read.joints.values[i];
      const double weight = read.weights.values[i];
      if (!(weight >= 0 && std::isfinite(weight)))
        weight_id->fail("vertex " + std::to_string(i / 4) + " has a weight that is negative or not finite");
      if (weight != 0 && !(joint >= 0 && joint < static_cast<double>(joints)))
        joint_id->fail("a joint is out of range");
    }
  }
  if (sets_.empty()) attributes.fail("has no JOINTS_0 and WEIGHTS_0 for the skin of its node");
  for (std::size_t i = 0; i < vertices; ++i) {
    const std::size_t count = weights(i).count();
    if (count > kMostWeights) ++with_many_;
    if (count == 0) ++without_;
  }
}

JointWeights GltfWeights::weights(std::size_t vertex) const {
  JointWeights found;
  for (const Set& set : sets_) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double weight = set.weights.element(vertex)[i];
      if (weight != 0) found.add(static_cast<std::size_t>(set.joints.element(vertex)[i]), weight);
    }
  }
  return found;
}

void GltfWeights::bind(std::size_t vertex, RigVertex& out) const {
  JointWeights found = weights(vertex);
  if (found.count() == 0) {
    const double first = sets_[0].joints.element(vertex)[0];
    const bool is_joint = first >= 0 && first < static_cast<double>(joint_count_);
    found.add(is_joint ? static_cast<std::size_t>(first) : 0, 1);
  }
  found.bind(out);
}

}  // namespace arcspan::tools
