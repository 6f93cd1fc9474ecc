// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/gltf/gltf_skin.hpp>
#include <arcspan_tools/mesh/plain/rig.hpp>

#include <array>
#include <map>
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

  /// The numbers that the vertices of a triangle, given by their indices, have in the rig. Of a file without
  /// normals a triangle with morph targets has vertices of its own, because each target turns its flat normal
  /// (glTF 2.0, 3.7.2.2).
  [[nodiscard]] std::array<std::uint32_t, 3> add_triangle(const std::array<std::size_t, 3>& indices,
                                                          std::size_t instance, RigVertices& rig);
  [[nodiscard]] std::size_t morph_targets() const { return targets_.size(); }
  /// Joints and weights; nothing without a skin.
  [[nodiscard]] const std::optional<GltfWeights>& weights() const { return weights_; }

 private:
  struct Target {
    std::optional<AccessorData> positions;
    std::optional<AccessorData> normals;
  };
  [[nodiscard]] RigVertex vertex(std::size_t index, std::size_t instance) const;

  const AccessorData& positions_;
  const std::optional<AccessorData>& normals_;
  std::optional<GltfWeights> weights_;
  std::vector<Target> targets_;
  std::map<std::size_t, std::uint32_t> known_;  ///< vertices of the rig, by index
};

}  // namespace arcspan::tools
