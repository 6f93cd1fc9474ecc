// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/gltf/gltf_skin.hpp>
#include <arcspan_tools/mesh/plain/rig.hpp>

#include <optional>
#include <vector>

namespace arcspan::tools {

/// What moves the vertices of a primitive.
class GltfVertices {
 public:
  /// Reads weights, if `joints` of a skin are not 0, and morph targets of `primitive`. Throws a Failure that
  /// names the place.
  GltfVertices(GltfFile& file, const JsonView& primitive, const AccessorData& positions,
               const std::optional<AccessorData>& normals, std::size_t joints);

  /// The vertex with this index, of an instance of the rig.
  [[nodiscard]] RigVertex vertex(std::size_t index, std::size_t instance) const;
  [[nodiscard]] std::size_t morph_targets() const { return targets_.size(); }
  /// Joints and weights; nothing without a skin.
  [[nodiscard]] const std::optional<GltfWeights>& weights() const { return weights_; }

 private:
  struct Target {
    std::optional<AccessorData> positions;
    std::optional<AccessorData> normals;
  };
  const AccessorData& positions_;
  const std::optional<AccessorData>& normals_;
  std::optional<GltfWeights> weights_;
  std::vector<Target> targets_;
};

}  // namespace arcspan::tools
