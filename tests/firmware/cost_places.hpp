// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/vertex/clip_transform.hpp>

namespace arcspan {

/// A textured mesh before a camera, for a picture of 320x240 pixels.
struct CostPlace {
  MeshView mesh;
  ClipTransform transform;
};

/// A room: a floor to the far wall, three walls and four crates, 452 triangles, whose texture repeats every
/// 2,000 units. The eye stands in the door.
[[nodiscard]] bool make_room(CostPlace& place);

/// A dashboard: a panel with three round dials, their needles and six lamps, 144 triangles, seen a little
/// from above.
[[nodiscard]] bool make_dashboard(CostPlace& place);

/// A square of 200x200 pixels that is turned about the vertical axis: its left and right side are nearer and
/// farther by `depth`, the distance of its middle being 24000. The texture lies on it once.
[[nodiscard]] bool make_square(std::int32_t depth, CostPlace& place);

}  // namespace arcspan
