// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/shading/literature/linear_normal_method.hpp>

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
    MapPoint point{scaled(x, inverse), scaled(y, inverse)};
    if (z < 0) point = mirrored(point, x < 0, y < 0);
    return cells_[static_cast<std::size_t>(cell(point.v) * kSide + cell(point.u))];
  }

 private:
  static constexpr std::int32_t kOne = std::int32_t{1} << 15;

  /// A point of the unfolded octahedron, -1...1 with 15 fraction bits. Directions with z >= 0 lie in
  /// |u| + |v| <= 1.
  struct MapPoint {
    std::int32_t u;
    std::int32_t v;
  };

  [[nodiscard]] static constexpr std::uint32_t magnitude(std::int32_t v) {
    return static_cast<std::uint32_t>(v < 0 ? -v : v);
  }
  /// `p` mirrored at the line |u| + |v| = 1 of its quadrant, which exchanges z and -z.
  [[nodiscard]] static constexpr MapPoint mirrored(const MapPoint& p, bool negative_u, bool negative_v) {
    const std::int32_t u = kOne - static_cast<std::int32_t>(magnitude(p.v));
    const std::int32_t v = kOne - static_cast<std::int32_t>(magnitude(p.u));
    return {negative_u ? -u : u, negative_v ? -v : v};
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
    MapPoint point{middle(column), middle(row)};
    const std::int32_t z = kOne - static_cast<std::int32_t>(magnitude(point.u) + magnitude(point.v));
    if (z < 0) point = mirrored(point, point.u < 0, point.v < 0);
    return normalised(point.u, point.v, z);
  }

  std::array<PackedRgb, static_cast<std::size_t>(kSide) * kSide> cells_{};
};

namespace detail {

/// The colour of a linear normal: the table's cell in its direction.
struct TabulatedColour {
  template <class Illumination>
  [[nodiscard]] static constexpr PackedRgb colour(const ReflectionTable<Illumination>& table,
                                                  const LinearNormal& n) {
    return table(component(n.x), component(n.y), component(n.z));
  }

 private:
  /// 15 fraction bits, saturated below 4 in magnitude, because gradients of slivers have errors.
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
