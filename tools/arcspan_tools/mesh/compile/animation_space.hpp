// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_animation.hpp>
#include <arcspan_tools/mesh/plain/rig.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// The nodes of a rig that move its vertices, in object units. Above those whose parent never moves is a root
/// that stands for this parent, from the space of the file to that of the object: one node, or a chain of
/// them if one would be flat or sheared. Constant scales are taken out of the nodes: the space of a node is
/// scales_ times as large as in the file.
class AnimationSpace {
 public:
  /// `unit` and `centre` are those of the model's meshes. Throws a Failure about `subject` for a node that
  /// the formats cannot hold.
  AnimationSpace(const Rig& rig, double unit, Vec3 centre, const std::string& subject);

  [[nodiscard]] const std::vector<FixedNode>& nodes() const { return nodes_; }
  /// The number of a node of the rig among nodes(); nothing for one that moves no vertex.
  [[nodiscard]] std::optional<std::size_t> number(std::size_t node) const { return numbers_[node]; }

  /// A joint that does `map` and then what the node does. Without a node, the file's space stands still.
  [[nodiscard]] FixedJoint joint(std::optional<std::size_t> node, const Affine& map);
  /// Raw numbers of a node's translation and scale in the file.
  [[nodiscard]] std::array<std::int32_t, 3> translation(std::size_t node, Vec3 t) const;
  [[nodiscard]] std::array<std::int32_t, 3> scale(std::size_t node, Vec3 s) const;
  /// The length in the model of a unit of the file, by constant scales: at the parent of a node of nodes(),
  /// and within it.
  [[nodiscard]] double scale_of_parent(std::size_t node) const;
  [[nodiscard]] double scale_of(std::size_t node) const { return scales_[*numbers_[node]]; }

 private:
  void choose_nodes();
  void leave_out_far_nodes();
  void add(std::size_t node);
  /// The root of nodes whose parent is `still`, or nothing.
  std::size_t root(std::optional<std::size_t> still);
  [[noreturn]] void fail(std::size_t node, const char* what) const;
  [[nodiscard]] std::int32_t raw(double value, int fraction_bits, std::int32_t most, const char* what,
                                 const std::string& name) const;

  const Rig& rig_;
  double unit_;
  Vec3 centre_;
  std::string subject_;
  std::vector<bool> needed_;
  std::vector<bool> moves_;  ///< by clips or by a program: joints, moved nodes, and all below them
  std::vector<Affine> rest_;
  std::vector<FixedNode> nodes_;
  std::vector<double> scales_;  ///< of the space of each of nodes_
  std::vector<std::optional<std::size_t>> numbers_;
  std::map<std::optional<std::size_t>, std::size_t> roots_;
};

/// Raw numbers of a rotation: 32767ths.
[[nodiscard]] std::array<std::int16_t, 4> fixed_rotation(Quaternion q);

}  // namespace arcspan::tools
