// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>

#include <cstdint>

namespace arcspan {

/// Three channels in a word each, an 8-bit step with 23 fraction bits to which half a step has been added, so
/// that dropping them rounds. Below 2^31: the upper bits of a word are a level without a mask.
struct FineRgb {
  static constexpr int kFraction = 23;

  std::uint32_t r;
  std::uint32_t g;
  std::uint32_t b;

  FineRgb() = default;  // no aggregate: encode({r, g, b}) means an Rgb8

  [[nodiscard]] static constexpr FineRgb of(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    FineRgb c{};
    c.r = r;
    c.g = g;
    c.b = b;
    return c;
  }
  [[nodiscard]] constexpr PackedRgb packed() const {
    return PackedRgb::of(r >> (kFraction - 2), g >> (kFraction - 2), b >> (kFraction - 2));
  }
};

}  // namespace arcspan
