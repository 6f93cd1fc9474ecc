// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>

#include <array>
#include <cstdint>

namespace arcspan {

/// The light of a pixel in two parts, for surfaces that reflect them in different colours, as a texture does.
/// Their sum, saturated, is the colour of an untextured surface.
struct PixelLight {
  PackedRgb diffuse;    ///< ambient and diffuse part
  PackedRgb highlight;  ///< specular part, without the half 8-bit step that a PackedRgb includes otherwise
};

/// The light of a pixel on a 5-6-5 texel.
struct ChannelLight {
  std::array<std::uint32_t, 3> factors;  ///< of red, green and blue, 0...1023
  std::uint32_t shine;                   ///< the highlight as a wide_spread()
};

/// A colour as Gouraud shading interpolates it: per channel 0...65280, in 256ths of an 8-bit step.
struct DeepColour {
  std::int32_t r;
  std::int32_t g;
  std::int32_t b;
};

}  // namespace arcspan
