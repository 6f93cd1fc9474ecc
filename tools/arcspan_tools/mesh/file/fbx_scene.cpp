// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/fbx_scene.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {
namespace {

/// "PreRotation" for a node "X_$AssimpFbx$_PreRotation" that the library split from a node "X"; empty if
/// `part` was not split from `node`.
std::string_view part_of_chain(const aiNode& part, const aiNode& node) {
  const std::string start = std::string(node.mName.C_Str()) + "_$AssimpFbx$_";
  const std::string_view name = part.mName.C_Str();
  return name.starts_with(start) ? name.substr(start.size()) : std::string_view{};
}

/// The nodes above a node that were split from it, the nearest first.
std::vector<const aiNode*> chain_above(const aiNode& node) {
  std::vector<const aiNode*> chain;
  for (const aiNode* at = node.mParent; at != nullptr && !part_of_chain(*at, node).empty(); at = at->mParent)
    chain.push_back(at);
  return chain;
}

/// The names of all nodes that have keys.
std::set<std::string> moved_names(const aiScene& scene) {
  std::set<std::string> names;
  for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
    const aiAnimation& clip = *scene.mAnimations[i];
    for (unsigned k = 0; k < clip.mNumChannels; ++k) names.insert(clip.mChannels[k]->mNodeName.C_Str());
  }
  return names;
}

/// Whether a part of a chain is neither about a pivot nor geometric.
bool is_plain(std::string_view part) {
  constexpr std::array<std::string_view, 5> kPlain = {"Translation", "PreRotation", "Rotation",
                                                      "PostRotation", "Scaling"};
  return std::find(kPlain.begin(), kPlain.end(), part) != kPlain.end();
}

}  // namespace

aiMatrix4x4 fbx_space(const aiScene& scene) {
  aiMatrix4x4 space;
  if (scene.mMetaData == nullptr) return space;
  float centimetres = 1;
  if (!scene.mMetaData->Get("UnitScaleFactor", centimetres) || !(centimetres > 0)) centimetres = 1;
  aiMatrix3x3 axes(0, 0, 0, 0, 0, 0, 0, 0, 0);
  const std::array<const char*, 3> names = {"CoordAxis", "UpAxis", "FrontAxis"};
  for (unsigned row = 0; row < names.size(); ++row) {
    std::int32_t axis = -1;
    std::int32_t sign = 1;
    (void)scene.mMetaData->Get(names[row], axis);
    (void)scene.mMetaData->Get(std::string(names[row]) + "Sign", sign);
    if (axis >= 0 && axis < 3) axes[row][axis] = sign < 0 ? -1 : 1;
  }
  if (axes.Determinant() > 0.5) space = aiMatrix4x4(axes);  // else the stated axes are ignored as wrong
  const auto metres = static_cast<ai_real>(centimetres / 100);
  aiMatrix4x4 scale;
  return aiMatrix4x4::Scaling({metres, metres, metres}, scale) * space;
}

std::map<const aiNode*, JoinedNode> joined_fbx_nodes(const aiScene& scene) {
  std::map<const aiNode*, JoinedNode> joined;
  const std::set<std::string> moved = moved_names(scene);
  for (const std::string& name : moved) {
    const aiNode* node = scene.mRootNode->FindNode(name.c_str());
    if (node == nullptr) continue;
    const std::vector<const aiNode*> chain = chain_above(*node);
    const bool is_whole = std::none_of(chain.begin(), chain.end(), [&](const aiNode* part) {
      return !is_plain(part_of_chain(*part, *node)) || moved.count(part->mName.C_Str()) != 0;
    });
    if (!is_whole) continue;
    JoinedNode last{node->mTransformation, {}};
    for (const aiNode* part : chain) {
      const aiMatrix4x4& own = part->mTransformation;
      last.transform = own * last.transform;
      // The library's keys hold the PostRotation where its inverse belongs; `own` is that inverse.
      if (part_of_chain(*part, *node) == "PostRotation") last.after = aiQuaternion(aiMatrix3x3(own * own));
      joined[part] = {};
    }
    joined[node] = last;
  }
  return joined;
}

aiMatrix4x4 geometric_transform(const aiNode& node) {
  aiMatrix4x4 transform;
  for (const aiNode* part : chain_above(node)) {
    const std::string_view kind = part_of_chain(*part, node);
    if (kind.starts_with("Geometric") && !kind.ends_with("Inverse"))
      transform = part->mTransformation * transform;
  }
  return transform;
}

}  // namespace arcspan::tools
