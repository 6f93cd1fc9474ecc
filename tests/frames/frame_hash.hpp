// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>

#include <cstdint>

/// The size of the frames of hashes.txt and textured_hashes.txt, and the hash of their pixels.
namespace arcspan::scenes {

inline constexpr std::int32_t kWidth = 160;
inline constexpr std::int32_t kHeight = 120;
inline constexpr std::int32_t kFrameRadius = 52;

/// FNV-1a over bytes.
class Hash {
 public:
  constexpr void add(std::uint8_t byte) { state_ = (state_ ^ byte) * 16777619u; }
  constexpr void add(Rgb8 c) {
    add(c.r);
    add(c.g);
    add(c.b);
  }
  [[nodiscard]] constexpr std::uint32_t value() const { return state_; }

 private:
  std::uint32_t state_ = 2166136261u;
};

}  // namespace arcspan::scenes
