// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>

#include <string>

namespace arcspan::tools {

/// How far the stored animation of a model is from that of its file.
struct AnimationError {
  double position = 0;        ///< the largest of any vertex, in object units
  double normal_degrees = 0;  ///< the largest of any vertex
  std::string clip{};         ///< where `position` was found; empty for the pose at rest
  double seconds = 0;
};

/// The largest error over the keys of all clips, the file's and the stored ones, and at times between; of
/// large models over fewer times. The stored numbers are computed with in doubles, and positions limited to
/// 16 bits as on a device; how it rounds comes on top of it. `model` must have a rig and its animation.
[[nodiscard]] AnimationError animation_error(const FixedModel& model);

}  // namespace arcspan::tools
