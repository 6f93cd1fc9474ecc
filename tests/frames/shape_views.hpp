// SPDX-License-Identifier: MIT
#pragma once

#include <tests/frames/integer_shapes.hpp>

/// Meshes in flash, as headers that `arcspan mesh` writes have them.
namespace arcspan::scenes {

inline constexpr auto kTorusShape = make_torus<24, 12>();
inline constexpr auto kCubeShape = make_cube();
inline constexpr MeshView kTorus =
    MeshView::of(kTorusShape.positions, kTorusShape.normals, kTorusShape.indices);
inline constexpr MeshView kCube = MeshView::of(kCubeShape.positions, kCubeShape.normals, kCubeShape.indices);

}  // namespace arcspan::scenes
