// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/shading/literature/linear_normal.hpp>

#include <array>
#include <cstddef>

namespace arcspan {

/// An illumination tabulated over all directions of the normal: the octahedron unfolded to a square of kSide
/// by kSide cells, each with the colour at its centre. 16 KB; made once an object.
template <class Illumination>
class ReflectionTable {
 public:
  static constexpr int kSideBits = 6;
  static constexpr std::int32_t kSide = 1 << kSideBits;

  // Implicit, so that a reflection map is drawn with the illumination that it is of, as every method is.
  // NOLINTNEXTLINE(google-explicit-constructor)
  ReflectionTable(const Illumination& lit) {
    for (std::int32_t v = 0; v < kSide; ++v) {
      for (std::int32_t u = 0; u < kSide; ++u) {
        cells_[static_cast<std::size_t>(v * kSide + u)] = lit.colour(lit.scalars(centre(u, v)));
      }
    }
  }

  /// The colour of the cell that the direction of (x, y, z) is in, whatever its length; |component| < 2^17.
  [[nodiscard]] constexpr PackedRgb operator()(std::int32_t x, std::int32_t y, std::int32_t z) const {
    const Reciprocal inverse = reciprocal(magnitude(x) + magnitude(y) + magnitude(z));
    std::int32_t u = scaled(x, inverse);
    std::int32_t v = scaled(y, inverse);
    if (z < 0) {
      const std::int32_t folded_u = kOne - static_cast<std::int32_t>(magnitude(v));
      const std::int32_t folded_v = kOne - static_cast<std::int32_t>(magnitude(u));
      u = x < 0 ? -folded_u : folded_u;
      v = y < 0 ? -folded_v : folded_v;
    }
    return cells_[static_cast<std::size_t>(cell(v) * kSide + cell(u))];
  }

 private:
  static constexpr std::int32_t kOne = std::int32_t{1} << 15;

  [[nodiscard]] static constexpr std::uint32_t magnitude(std::int32_t v) {
    return static_cast<std::uint32_t>(v < 0 ? -v : v);
  }
  /// component / (|x| + |y| + |z|), 15 fraction bits.
  [[nodiscard]] static constexpr std::int32_t scaled(std::int32_t component, const Reciprocal& inverse) {
    // The component has at most the bits of the sum, 19: shifted to 16 with it, the product fits 32.
    const int up = 47 - inverse.exponent;
    const std::uint32_t size = ((magnitude(component) << up) >> 16) * inverse.mantissa;
    const auto rounded = static_cast<std::int32_t>(size >> 16);
    const std::int32_t held = rounded > kOne ? kOne : rounded;
    return component < 0 ? -held : held;
  }
  [[nodiscard]] static constexpr std::int32_t cell(std::int32_t c) {
    const std::int32_t index = (c + kOne) >> (16 - kSideBits);
    return index < 0 ? 0 : index >= kSide ? kSide - 1 : index;
  }
  [[nodiscard]] static Direction centre(std::int32_t column, std::int32_t row) {
    const auto middle = [](std::int32_t i) { return (2 * i + 1) * (kOne / kSide) - kOne; };
    std::int32_t u = middle(column);
    std::int32_t v = middle(row);
    const std::int32_t z = kOne - static_cast<std::int32_t>(magnitude(u) + magnitude(v));
    if (z < 0) {
      const std::int32_t folded_u = kOne - static_cast<std::int32_t>(magnitude(v));
      const std::int32_t folded_v = kOne - static_cast<std::int32_t>(magnitude(u));
      u = u < 0 ? -folded_u : folded_u;
      v = v < 0 ? -folded_v : folded_v;
    }
    return normalised(u, v, z);
  }

  std::array<PackedRgb, static_cast<std::size_t>(kSide) * kSide> cells_{};
};

/// Shading by a reflection map (S0 [6]), for comparison: the normal is interpolated linearly, not normalised,
/// and its direction indexes a table of colours. No product with L, H or V and no power is left in the span,
/// and the table's cells are to be seen: a cell's centre is up to 3.9 degrees away.
template <class Illumination>
struct ReflectionMap {
  using Lighting = ReflectionTable<Illumination>;
  struct Face {};
  using Vertex = Direction;
  struct Prepared {
    NormalPlane normal;
    bool middle_left;
  };
  static constexpr bool kNeedsFaceNormal = false;

  [[nodiscard]] static Vertex shade_vertex(const Lighting&, const Direction& normal) { return normal; }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    return between_normalised(a, b, t);
  }
  [[nodiscard]] static constexpr bool too_wide(const Vertex&, const Vertex&) { return false; }

  static constexpr void prepare(const Lighting&, const TriangleFrame<ReflectionMap>& frame, const Face&,
                                Prepared& prepared) {
    make_normal_plane(frame, frame.top->shade, frame.middle->shade, frame.bottom->shade, prepared.normal);
    prepared.middle_left = frame.middle_left;
  }

  struct Run {
    LinearNormal normal;
    LinearNormal step;

    [[nodiscard]] constexpr PackedRgb colour(const Lighting& table) const {
      return table(short_component(normal.x), short_component(normal.y), short_component(normal.z));
    }
    constexpr void next() { normal.advance(step); }

   private:
    /// 15 fraction bits, kept below 4: gradients of slivers have errors.
    [[nodiscard]] static constexpr std::int32_t short_component(Linear c) {
      constexpr std::int32_t kMost = (std::int32_t{1} << 17) - 1;
      const std::int32_t v = round_shift(c.raw(), Linear::kFraction);
      return v > kMost ? kMost : v < -kMost ? -kMost : v;
    }
  };

  class Walker {
   public:
    using Run = ReflectionMap::Run;
    static constexpr std::int32_t kLongestRun = 2 * kGuardBand;
    constexpr explicit Walker(Prepared& prepared) : p_(&prepared) {}
    [[nodiscard]] constexpr Run row(const RowStart& start) const {
      return {p_->normal.at(start), p_->normal.step()};
    }
    constexpr void next_row() { p_->normal.next_row(); }
    constexpr void enter_lower() { p_->normal.enter_lower(p_->middle_left); }

   private:
    Prepared* p_;
  };

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return draw(Walker(prepared));
  }
};

}  // namespace arcspan
