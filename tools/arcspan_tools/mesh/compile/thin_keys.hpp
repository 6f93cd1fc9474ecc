// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/clip.hpp>

namespace arcspan::tools {

/// How far a channel may be from that of the file.
struct ClipTolerance {
  double degrees = 0;  ///< of rotations
  double length = 0;   ///< of translations, in the file's units; of scales and morph weights `share`
  double share = 0;
};

/// `channel` with as few of its keys as the tolerance allows, at the file's own times. A channel whose keys
/// are all alike has one. Cubic channels, whose tangents belong to the keys, keep them all.
[[nodiscard]] RigChannel thinned(const RigChannel& channel, const ClipTolerance& tolerance);

/// `channel` with its keys at whole microseconds. Of two keys in the same one (a jump), the later moves to
/// the next microsecond, or is left out if another key is there.
[[nodiscard]] RigChannel in_microseconds(const RigChannel& channel);

/// A linear channel of rotations with keys added where interpolation of components is off the spherical one
/// by more than 0.002 degrees. Other channels, and those that would exceed kMostKeys, are unchanged.
[[nodiscard]] RigChannel with_close_rotations(const RigChannel& channel);

}  // namespace arcspan::tools
