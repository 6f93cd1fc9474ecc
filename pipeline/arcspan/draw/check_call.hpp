// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/checked.hpp>

namespace arcspan::detail {

/// Reports a lighting that has a texture which was not given, or that was never made, and a depth buffer that
/// was never cleared (ARCSPAN_CHECKED).
template <class Lighting, class Depth>
constexpr void check_call([[maybe_unused]] const Lighting& lighting, [[maybe_unused]] const Depth& depth) {
  if constexpr (kIsChecked) {
    if constexpr (requires { lighting.texture.is_made(); })
      ARCSPAN_CHECK(lighting.texture.is_made(), "draw: the texture of a textured method was not given");
    if constexpr (requires { lighting.is_made(); })
      ARCSPAN_CHECK(lighting.is_made(), "draw: the light of an object was never made");
    if constexpr (Depth::kTests) depth.check_cleared();
  }
}

/// Reports also a mesh or a transform that cannot show anything, and a texture whose borders the method does
/// not show. (Billboards end at them.)
template <class Stage, class Depth>
constexpr void check_mesh_call([[maybe_unused]] const Stage& stage, const Depth& depth) {
  ARCSPAN_CHECK(stage.mesh().vertex_count() != 0, "draw: the mesh was never made");
  ARCSPAN_CHECK(stage.transform().viewport().width != 0, "draw: the transform was never made");
  if constexpr (kIsChecked && requires { stage.lighting().shows_borders(); })
    ARCSPAN_CHECK(stage.lighting().shows_borders(),
                  "draw: a texture that does not repeat was given to a method of TextureBorders::kRepeat");
  check_call(stage.lighting(), depth);
}

}  // namespace arcspan::detail
