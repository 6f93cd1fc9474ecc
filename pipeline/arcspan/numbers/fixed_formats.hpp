// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

/// All number formats of the pipeline, each with its range and the reason for it. 28.4: 28 integer bits with
/// the sign, and 4 fraction bits.
namespace arcspan {

/// Screen coordinate, 28.4: pixels from the raster origin (the viewport's middle pixel), y down. Range
/// [-1024, 1024), the guard band. Differences fit 15 bits and a sign, and twice a triangle's area
/// fits 32 bits.
using Subpixel = Fixed<std::int32_t, 4>;

/// A scalar of a normal, N·L, N·H or N·V, and its difference per pixel: 2.30, [-2, 2). The amplitude
/// is 1 and one bit is head-room. Differences need all 30 fraction bits, because their error grows with the
/// length of the span (decision 4).
using Cosine = Fixed<std::int32_t, 30>;

/// Fraction of an edge, and in the literature squared chords and angles up to 1.1 (60 degrees): 17.15. Kept
/// below 2 in magnitude, so that a product of two fits 32 bits (one 16x16 multiply).
using Factor = Fixed<std::int32_t, 15>;

/// Where an edge is cut: 0...1, within 2^-28. The 15 bits of a Factor would move a texture on a long edge.
struct CutFraction {
  std::int32_t raw;  ///< 30 fraction bits

  constexpr operator Factor() const { return Factor::from_raw(raw >> 15); }
  [[nodiscard]] constexpr std::int32_t between(std::int32_t a, std::int32_t b) const {
    return static_cast<std::int32_t>(a + (((std::int64_t{b} - a) * raw + (std::int32_t{1} << 29)) >> 30));
  }
};

/// Component of a unit normal, 2.14 in 16 bits: [-1, 1].
using NormalComponent = Fixed<std::int16_t, 14>;

/// Component of a Direction, 17.15: [-1, 1] and 2^-13 more by rounding. A dot product of two is three 32-bit
/// multiplies and fits 2.30.
using DirectionComponent = Fixed<std::int32_t, 15>;

/// Attribute that is linear on the screen, such as depth (0...65535): 16 integer bits and 12 fraction bits,
/// so that the error of a gradient stays below 1/8 over 1024 pixels; 3 bits are head-room.
using Linear = Fixed<std::int32_t, 12>;

/// The 16-bit depth of a surface whose interpolated depth is `z`. On RISC-V compilers take the shift to the
/// left out of a loop, by shifting the start and the step of `z`.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t depth_of(Linear z) {
  constexpr int kUp = 16 - Linear::kFraction;
  if constexpr (kExtendsHalfwords) return static_cast<std::uint16_t>(z.raw() >> Linear::kFraction);
  return static_cast<std::uint16_t>(static_cast<std::uint32_t>(z.raw()) << kUp >> 16);
}

/// Linear attribute with 15 fraction bits and no head-room: Gouraud's colours (0...255 in 256ths, [0, 2^16)),
/// N·L in units of 2^-15 (LinearLight), and their gradients, up to 2^16 in magnitude. Intermediate sums may
/// wrap, because the final sum wraps back.
using FullLinear = Fixed<std::int32_t, 15>;

/// Entry of a rotation, 2.30, [-1, 1].
using RotationEntry = Fixed<std::int32_t, 30>;

/// Length in object units (1 = one step of a 16-bit position), 24.8: up to 8.3 million in magnitude.
using ObjectLength = Fixed<std::int32_t, 8>;

/// Length in world units, 16.16: below 32768 in magnitude. An object is moved in steps of 2^-16, far below a
/// subpixel unless a world unit covers hundreds of pixels.
using WorldLength = Fixed<std::int32_t, 16>;

/// Length in pixels, 21.11: focal lengths below 2^20 pixels.
using PixelLength = Fixed<std::int32_t, 11>;

/// Material coefficient, light intensity, attenuation: 17.15, [0, 1].
using Coefficient = Fixed<std::int32_t, 15>;

namespace detail {

/// The pixel that contains a coordinate, the raw value of a Subpixel.
[[nodiscard]] constexpr std::int32_t pixel_of(std::int32_t raw) { return raw >> Subpixel::kFraction; }

}  // namespace detail

}  // namespace arcspan
