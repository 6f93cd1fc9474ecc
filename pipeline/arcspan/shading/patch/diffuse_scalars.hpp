// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/patch/patch.hpp>

#include <cstdint>

namespace arcspan {

/// Returns true if a TriangleFrame has a diffuse_scalar() (Illumination), and sets `lit` to its argument.
template <class Lighting, class Frame>
[[nodiscard]] constexpr bool lit_throughout(const Lighting& lighting, const Frame& frame,
                                            std::uint32_t& lit) {
  return lighting.lit_throughout(frame.top->shade.scalars, frame.middle->shade.scalars,
                                 frame.bottom->shade.scalars, lit);
}

/// Returns the diffuse_scalar() of the vertices of a TriangleFrame.
template <class Lighting, class Frame>
[[nodiscard]] constexpr PatchValues diffuse_scalars(const Lighting& lighting, const Frame& frame,
                                                    std::uint32_t lit) {
  return {lighting.diffuse_scalar(frame.top->shade.scalars, lit),
          lighting.diffuse_scalar(frame.middle->shade.scalars, lit),
          lighting.diffuse_scalar(frame.bottom->shade.scalars, lit)};
}

}  // namespace arcspan
