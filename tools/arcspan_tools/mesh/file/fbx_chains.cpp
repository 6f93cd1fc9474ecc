// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/fbx_chains.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {
namespace {

/// What the name of a node of the chain of `node` says after the node's own name; else empty.
std::string_view part_of_chain(const aiNode& part, const aiNode& node) {
  const std::string start = std::string(node.mName.C_Str()) + "_$AssimpFbx$_";
  const std::string_view name = part.mName.C_Str();
  return name.starts_with(start) ? name.substr(start.size()) : std::string_view{};
}

/// The chain above a node, from the node on.
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

bool has_pivot(std::string_view part) {
  constexpr std::array<std::string_view, 5> kPlain = {"Translation", "PreRotation", "Rotation",
                                                      "PostRotation", "Scaling"};
  return std::find(kPlain.begin(), kPlain.end(), part) == kPlain.end();
}

}  // namespace

std::map<const aiNode*, JoinedChain> joined_chains(const aiScene& scene) {
  std::map<const aiNode*, JoinedChain> joined;
  const std::set<std::string> moved = moved_names(scene);
  for (const std::string& name : moved) {
    const aiNode* node = scene.mRootNode->FindNode(name.c_str());
    if (node == nullptr) continue;
    const std::vector<const aiNode*> chain = chain_above(*node);
    const bool is_whole = std::none_of(chain.begin(), chain.end(), [&](const aiNode* part) {
      return has_pivot(part_of_chain(*part, *node)) || moved.count(part->mName.C_Str()) != 0;
    });
    if (!is_whole) continue;
    JoinedChain last{node->mTransformation, {}};
    for (const aiNode* part : chain) {
      const aiMatrix4x4& own = part->mTransformation;
      last.place = own * last.place;
      // The library's keys hold the rotation after a node's own where its inverse belongs, which is `own`.
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
