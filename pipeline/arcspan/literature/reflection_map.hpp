// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/linear_normal_method.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>

namespace arcspan {

/// An illumination tabulated over all directions of the normal, 16 KB, made once per object. The octahedron
/// |x| + |y| + |z| = 1 is unfolded to a square of kSide by kSide cells, each with the colour at its centre.
template <class Illumination>
class ReflectionTable {
 public:
  static constexpr int kSideBits = 6;
  static constexpr std::int32_t kSide = 1 << kSideBits;

  // Implicit, so that a caller passes an illumination to draw_mesh(), as with every other method.
  // NOLINTNEXTLINE(google-explicit-constructor)
  ReflectionTable(const Illumination& illumination) {
    for (std::int32_t row = 0; row < kSide; ++row) {
      for (std::int32_t column = 0; column < kSide; ++column) {
        cells_[static_cast<std::size_t>(row * kSide + column)] =
            illumination.colour(illumination.scalars(centre(column, row)));
      }
    }
  }

  /// The colour of the cell that contains the direction of (x, y, z), a vector of any length with
  /// |component| < 2^17.
  [[nodiscard]] constexpr PackedRgb operator()(std::int32_t x, std::int32_t y, std::int32_t z) const {
    const Reciprocal inverse = reciprocal(magnitude(x) + magnitude(y) + magnitude(z));
    std::int32_t u = scaled(x, inverse);
    std::int32_t v = scaled(y, inverse);
    if (z < 0) mirror(u, v, x, y);
    return cells_[static_cast<std::size_t>(cell(v) * kSide + cell(u))];
  }

 private:
  static constexpr std::int32_t kOne = std::int32_t{1} << 15;

  [[nodiscard]] static constexpr std::uint32_t magnitude(std::int32_t v) {
    return static_cast<std::uint32_t>(v < 0 ? -v : v);
  }
  /// Mirrors the map coordinates u and v (15 fraction bits) at the line |u| + |v| = 1 of the quadrant of (x,
  /// y), where directions with z < 0 lie.
  static constexpr void mirror(std::int32_t& u, std::int32_t& v, std::int32_t x, std::int32_t y) {
    const std::int32_t mirrored_u = kOne - static_cast<std::int32_t>(magnitude(v));
    const std::int32_t mirrored_v = kOne - static_cast<std::int32_t>(magnitude(u));
    u = x < 0 ? -mirrored_u : mirrored_u;
    v = y < 0 ? -mirrored_v : mirrored_v;
  }
  /// component / (|x| + |y| + |z|), 15 fraction bits.
  [[nodiscard]] static constexpr std::int32_t scaled(std::int32_t component, const Reciprocal& inverse) {
    // The component has at most as many bits as the sum, 19. Shifted to 16 bits with it, the product fits 32.
    const int up = 47 - inverse.exponent;
    const std::uint32_t size = ((magnitude(component) << up) >> 16) * inverse.mantissa;
    const auto rounded = static_cast<std::int32_t>(size >> 16);
    const std::int32_t held = rounded > kOne ? kOne : rounded;
    return component < 0 ? -held : held;
  }
  /// Row or column of a coordinate, saturated to 0...kSide - 1.
  [[nodiscard]] static constexpr std::int32_t cell(std::int32_t c) {
    const std::int32_t index = (c + kOne) >> (16 - kSideBits);
    return index < 0 ? 0 : index >= kSide ? kSide - 1 : index;
  }
  /// The unit direction at a cell's centre.
  [[nodiscard]] static Direction centre(std::int32_t column, std::int32_t row) {
    const auto middle = [](std::int32_t i) { return (2 * i + 1) * (kOne / kSide) - kOne; };
    std::int32_t u = middle(column);
    std::int32_t v = middle(row);
    const std::int32_t z = kOne - static_cast<std::int32_t>(magnitude(u) + magnitude(v));
    if (z < 0) mirror(u, v, u, v);
    return normalised(u, v, z);
  }

  std::array<PackedRgb, static_cast<std::size_t>(kSide) * kSide> cells_{};
};

namespace detail {

/// The colour of a linear normal: the table's cell in its direction.
struct TabulatedColour {
  template <class Illumination>
  [[nodiscard]] ARCSPAN_INLINE static constexpr PackedRgb colour(const ReflectionTable<Illumination>& table,
                                                                 const LinearNormal& n) {
    return table(component(n.x), component(n.y), component(n.z));
  }

 private:
  /// 15 fraction bits, saturated below 4 in magnitude.
  [[nodiscard]] static constexpr std::int32_t component(Linear c) {
    constexpr std::int32_t kMost = (std::int32_t{1} << 17) - 1;
    const std::int32_t v = round_shift(c.raw(), Linear::kFraction);
    return v > kMost ? kMost : v < -kMost ? -kMost : v;
  }
};

}  // namespace detail

/// Shading by a reflection map (S0 [6]), for comparison. The normal is interpolated linearly, not normalised,
/// and its direction indexes a table of colours. The span stage has no product with L, H or V and no power,
/// but the table's cells are visible: a cell's centre is up to 3.9 degrees away.
template <class Illumination>
struct ReflectionMap : LinearNormalMethod<ReflectionTable<Illumination>, detail::TabulatedColour> {};

}  // namespace arcspan
