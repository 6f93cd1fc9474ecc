// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/gltf/accessor.hpp>
#include <arcspan_tools/mesh/gltf/gltf_nodes.hpp>
#include <arcspan_tools/mesh/plain/rig_vertices.hpp>

#include <vector>

namespace arcspan::tools {

/// Reads the skin that `id` refers to. Throws a Failure that names the place.
[[nodiscard]] RigSkin read_gltf_skin(GltfFile& file, const JsonView& id, const GltfNodes& nodes);

/// Joints and weights of a primitive's vertices.
class GltfWeights {
 public:
  /// Reads JOINTS_0, WEIGHTS_0 and further sets; a primitive with a skin must have one. Throws a Failure that
  /// names the place.
  GltfWeights(GltfFile& file, const JsonView& attributes, std::size_t vertices, std::size_t joints);

  /// Gives a vertex its joints, the largest weight first and the sum 1. A vertex whose weights are all zero
  /// follows its first joint.
  void bind(std::size_t vertex, RigVertex& out) const;
  /// Vertices that have more weights than are kept, or none.
  [[nodiscard]] std::size_t with_many_weights() const { return with_many_; }
  [[nodiscard]] std::size_t without_weights() const { return without_; }

 private:
  [[nodiscard]] JointWeights weights(std::size_t vertex) const;

  struct Set {
    AccessorData joints;
    AccessorData weights;
  };
  std::vector<Set> sets_;
  std::size_t joint_count_;
  std::size_t with_many_ = 0;
  std::size_t without_ = 0;
};

}  // namespace arcspan::tools
