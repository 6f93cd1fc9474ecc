// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_animation.hpp>
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/mesh/compile/animation_space.hpp>
#include <arcspan_tools/mesh/compile/stored_rig.hpp>
#include <arcspan_tools/mesh/plain/rig.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace arcspan::tools {

/// Makes the skins of a model, and what moves the vertices of each of its parts.
class PartMotions {
 public:
  PartMotions(const Rig& rig, AnimationSpace& space, const std::string& subject);

  /// What moves the vertices of a mesh whose sources are vertices of the rig, stored by as_stored(). Throws a
  /// Failure if a skin has too many joints.
  [[nodiscard]] FixedPartMotion motion(const FixedMesh& mesh);
  [[nodiscard]] const std::vector<FixedSkin>& skins() const { return skins_; }

 private:
  /// What a vertex may follow: a joint of an instance, whose node is none if nothing moves it.
  using JointKey = std::pair<std::size_t, std::size_t>;
  /// Whether a node that moves takes the vertex along.
  [[nodiscard]] bool follows(std::uint32_t source) const;
  [[nodiscard]] FixedJoint joint_of(const JointKey& key);
  /// Weights with joints as numbers of `keys`, to which new ones are added.
  [[nodiscard]] FixedWeights weights_of(std::uint32_t source, std::map<JointKey, std::size_t>& keys,
                                        FixedSkin& skin);
  [[nodiscard]] std::vector<std::int16_t> rest_weights(std::size_t instance) const;
  [[nodiscard]] std::optional<FixedMorph> morph_of(const FixedMesh& mesh) const;
  [[nodiscard]] std::vector<FixedBound> bounds_of(const FixedMesh& mesh, const FixedPartMotion& motion) const;

  const Rig& rig_;
  AnimationSpace& space_;
  std::string subject_;
  RigPoser rest_;
  std::vector<Affine> back_;  ///< of each instance, from storage to the space of its mesh
  std::vector<Affine> places_;
  std::vector<std::vector<WeightRange>> ranges_;  ///< of the morph targets of each instance
  std::vector<FixedSkin> skins_;
};

/// The weights of a vertex in 1024ths: the largest remainders go up, and the sum is 1024. Weights below half
/// of one are left out.
[[nodiscard]] std::vector<std::uint16_t> fixed_weights(std::vector<double> weights);

}  // namespace arcspan::tools
