// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/mesh/plain/affine.hpp>

#include <vector>

namespace arcspan::tools {

/// Poses a model by the numbers of its stored animation, computing in doubles as docs/animation-binary.md
/// says, with positions limited to 16 bits as in the pipeline. The model must outlive this.
class StoredPose {
 public:
  struct Vertex {
    Vec3 position;  ///< object units
    Vec3 normal;    ///< of any length
  };

  /// At rest.
  explicit StoredPose(const FixedModel& model);
  /// At a time of a clip, in seconds, which is rounded to microseconds.
  StoredPose(const FixedModel& model, const FixedClip& clip, double seconds);

  [[nodiscard]] Vertex vertex(std::size_t part, std::size_t i) const;

 private:
  void place_nodes(const std::vector<std::vector<double>>& translations,
                   const std::vector<std::vector<double>>& rotations,
                   const std::vector<std::vector<double>>& scales);
  [[nodiscard]] Vertex shaped(std::size_t part, std::size_t i) const;

  const FixedModel& model_;
  std::vector<std::vector<Affine>> joints_;         ///< of each skin
  std::vector<std::vector<double>> morph_weights_;  ///< of each part
};

}  // namespace arcspan::tools
