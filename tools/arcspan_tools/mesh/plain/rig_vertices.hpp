// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/rig.hpp>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace arcspan::tools {

/// The vertices of a rig, each once.
class RigVertices {
 public:
  explicit RigVertices(std::vector<RigVertex>& vertices) : vertices_(vertices) {}

  /// The number of this vertex, which is added unless an equal one is there.
  [[nodiscard]] std::uint32_t add(const RigVertex& vertex);

 private:
  std::vector<RigVertex>& vertices_;
  std::unordered_multimap<std::uint64_t, std::uint32_t> known_;  ///< by hash
};

/// Gives the corners of a triangle the normal of its plane, and each morph target the change of that normal,
/// in the space of the mesh, where they are counter-clockwise from the front. A target that leaves no area
/// changes nothing, and without an area the base has the normal of the first target that gives it one.
void add_flat_normals(std::array<RigVertex, 3>& triangle);

/// The joints that a file lets a vertex follow.
class JointWeights {
 public:
  /// Adds to the weight of a joint, which must not be negative.
  void add(std::size_t joint, double weight);
  /// Joints whose weights are not 0.
  [[nodiscard]] std::size_t count() const { return found_.size(); }
  /// Gives a vertex its joints, the largest weight first and the sum 1; of more than kMostWeights the first.
  void bind(RigVertex& out) const;

 private:
  struct Influence {
    std::size_t joint = 0;
    double weight = 0;
  };
  std::vector<Influence> found_;
};

}  // namespace arcspan::tools
