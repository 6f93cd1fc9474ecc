// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>
#include <arcspan_tools/mesh/plain/rig.hpp>

#include <vector>

namespace arcspan::tools {

/// Where the nodes of a rig are at a moment.
struct RigPose {
  std::vector<Affine> nodes{};                       ///< within their parents
  std::vector<std::vector<double>> morph_weights{};  ///< of each instance
};

/// The pose of the file's nodes, without a clip.
[[nodiscard]] RigPose rest_pose(const Rig& rig);

/// The pose of a clip at `time`, in seconds; what the clip does not move is at rest.
[[nodiscard]] RigPose pose_at(const Rig& rig, const RigClip& clip, double time);

/// A clip at a time, in seconds; rest without a clip.
struct RigMoment {
  const RigClip* clip = nullptr;
  double time = 0;
};

/// The pose in a fade between two moments, of which the second has `weight`, 0...1.
[[nodiscard]] RigPose faded_pose(const Rig& rig, const RigMoment& from, const RigMoment& to, double weight);

/// Poses vertices: morph targets first, then the joints of the skin; the mesh's own node counts only without
/// a skin. The rig must outlive this.
class RigPoser {
 public:
  RigPoser(const Rig& rig, const RigPose& pose);

  /// Transform from the mesh to the model's space for this vertex: Σ weight · node · inverse bind, or its
  /// node.
  [[nodiscard]] Affine place(const RigVertex& vertex) const;
  /// The same transform for vertices that follow only this joint of the instance's skin. Without a skin it is
  /// that of the instance's node.
  [[nodiscard]] Affine place(std::size_t instance, std::size_t joint) const;
  /// In the space of the mesh, with its morph targets.
  [[nodiscard]] Vec3 shaped_position(const RigVertex& vertex) const;
  [[nodiscard]] Vec3 shaped_normal(const RigVertex& vertex) const;

  [[nodiscard]] Vec3 position(const RigVertex& vertex) const {
    return place(vertex).point(shaped_position(vertex));
  }
  /// Transforms of all nodes to the model's space.
  [[nodiscard]] const std::vector<Affine>& nodes() const { return nodes_; }

 private:
  const Rig& rig_;
  std::vector<Affine> nodes_;
  std::vector<std::vector<Affine>> joints_;  ///< of each skin: node · inverse bind
  std::vector<std::vector<double>> morph_weights_;
};

/// The pipeline moves normals like directions, which is wrong where A stretches: the linear part of place()
/// of the vertex's first, heaviest joint at rest. So n' = A^-1 A^-T n is stored: at rest A n' is right.
[[nodiscard]] Vec3 carried_normal(const RigPoser& rest, const RigVertex& vertex, Vec3 normal);

/// The normal of a vertex in a pose, in the model's space, not normalised: with a skin, carried_normal() by
/// the linear part of place(), else the normal by the node.
[[nodiscard]] Vec3 posed_normal(const RigPoser& rest, const RigPoser& poser, const RigVertex& vertex);

/// For each vertex of a rig, whether just one of the pose and the pose at rest mirrors it: the corners of
/// triangles of such vertices need the other order.
[[nodiscard]] std::vector<bool> mirrored_vertices(const Rig& rig, const RigPose& pose);

/// The normal of a vertex of a rigged mesh in the space where the rig stores it: the file's, or one that was
/// made in the rest pose, taken back from there.
[[nodiscard]] Vec3 stored_normal(const RigVertex& vertex, Vec3 at_rest, const RigPoser& rest);

/// `model` in a pose of its rig, as a model without one. Throws a Failure about `subject` if a position is
/// too large for a model.
[[nodiscard]] Model posed(const Model& model, const RigPose& pose, const std::string& subject);

}  // namespace arcspan::tools
