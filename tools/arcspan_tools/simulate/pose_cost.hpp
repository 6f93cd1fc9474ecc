// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/support/vec3.hpp>

#include <array>
#include <cstddef>
#include <string_view>

namespace arcspan::tools {

/// What of a model is posed for a picture.
struct PoseAmounts {
  /// Vertices of parts with morph targets, and the sum of the targets of each.
  struct Morphs {
    double vertices = 0;
    double targets = 0;

    /// Adds a vertex.
    void add(std::size_t its_targets) { *this += {1, static_cast<double>(its_targets)}; }
    Morphs& operator+=(const Morphs& more) {
      vertices += more.vertices;
      targets += more.targets;
      return *this;
    }
    friend Morphs operator*(double share, const Morphs& all) {
      return {share * all.vertices, share * all.targets};
    }
  };

  double nodes = 0;
  double joints = 0;
  std::array<double, 4> positions{};  ///< of vertices with 1, 2, 3 and 4 weights
  std::array<double, 4> normals{};
  Morphs morphed_positions{};
  Morphs morphed_normals{};  ///< only of vertices that a target moves
};

/// The amounts for a picture of `posed`, which is `model` in a pose, from `eye`, by a method: positions of
/// all vertices, and normals of those of front faces. `shaded` is how many normals were shaded: more
/// where backs are drawn, which shade each corner anew. With flat shading it counts faces: they take no
/// normals of vertices, but the positions of their corners once more, and are fewer than front faces where
/// small ones have no pixel. `model` has its animation.
[[nodiscard]] PoseAmounts pose_amounts(const FixedModel& model, const FixedModel& posed, Vec3 eye,
                                       std::string_view shading, double shaded);

/// Instructions of posing on a core, which has weights in docs/estimates.json.
[[nodiscard]] double pose_instructions(std::string_view core, const PoseAmounts& amounts);

}  // namespace arcspan::tools
