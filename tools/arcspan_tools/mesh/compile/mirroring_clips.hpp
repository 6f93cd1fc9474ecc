// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/rig.hpp>

#include <cstddef>
#include <optional>

namespace arcspan::tools {

/// The first node that moves vertices and that a clip mirrors though it is not mirrored at rest, or the
/// reverse, at a key or in the middle of two; nothing if the clip mirrors none.
[[nodiscard]] std::optional<std::size_t> mirrored_node(const Rig& rig, const RigClip& clip);

}  // namespace arcspan::tools
