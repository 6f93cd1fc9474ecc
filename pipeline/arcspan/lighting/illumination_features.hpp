// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The cosine that the highlight is a power of.
enum class Highlight : std::uint8_t {
  kBlinn,  ///< N·H (S0 eq. 12)
  kPhong,  ///< R·V (S0 eq. 1)
};

/// Features of an Illumination, chosen at compile time. One that is off costs nothing.
struct IlluminationFeatures {
  /// Each of several lights has a colour (S0's I(lambda)), for three multiplies in place of one per light and
  /// pixel that it reaches, three in place of one in its highlight, and no ramp: all sums are multiplied out
  /// per channel, and every triangle carries all scalars (decision 22). Otherwise several lights must be
  /// grey. A single light may always be coloured, at no cost.
  bool coloured_lights = false;
  /// Material::highlight_fade works, for one comparison per pixel of a highlight.
  bool fading_highlights = false;
};

}  // namespace arcspan
