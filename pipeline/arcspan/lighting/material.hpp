// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>

#include <cstdint>

namespace arcspan {

/// One value per colour channel, each 0...1.
struct ChannelCoefficients {
  Coefficient r{};
  Coefficient g{};
  Coefficient b{};

  friend constexpr bool operator==(const ChannelCoefficients&, const ChannelCoefficients&) = default;
};

/// How a surface reflects light: the shares of ambient, diffuse and specular light, 0...1 per channel.
struct Material {
  ChannelCoefficients ambient;
  ChannelCoefficients diffuse;
  ChannelCoefficients specular;
  std::int32_t shininess = 32;  ///< exponent of the highlight, 1...256
  /// The N·L, 0...1, below which highlights fade out towards the terminator (HighlightFade). At 0 they end
  /// there abruptly. Other values need IlluminationFeatures::fading_highlights.
  Coefficient highlight_fade{};
};

}  // namespace arcspan
