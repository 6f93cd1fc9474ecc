// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_animation.hpp>
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/mesh/compile/thin_keys.hpp>

#include <map>
#include <string>

namespace arcspan::tools {

/// What is left out of the keys of clips: nothing by default.
struct ClipOptions {
  double degrees = 0;
  double share =
      0;  ///< of translations, in parts of the model's extent; of scales and morph weights as it is
};

/// The stored names of the clips of a rig by their own: shortened() to 31 bytes.
[[nodiscard]] std::map<std::string, std::string> stored_clip_names(const Rig& rig);

/// The animation of a compiled model that has a rig, in the formats of docs/animation-binary.md. Throws a
/// Failure about `subject` for what they cannot hold.
[[nodiscard]] FixedAnimation make_animation(const FixedModel& model, const ClipOptions& options,
                                            const std::string& subject);

}  // namespace arcspan::tools
