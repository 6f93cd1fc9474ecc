// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/shading/textured/joined_point.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// u or v on the grid of pixels, in fractions of a repetition in 32 bits, which wrap.
struct GridCoordinate {
  std::uint32_t at;        ///< at the centre of column 0, relative to the raster origin, in the first row
  std::int32_t step_down;  ///< per row
  std::int32_t step;       ///< per column

  constexpr GridCoordinate() = default;
  /// `along` and `along_step` are the coordinate on the long edge in the first row and its change per row,
  /// `edge` is that edge, `across` the change per column. The step down follows from both, so that the grid
  /// meets the edge in every row, however steep it is.
  constexpr GridCoordinate(std::uint32_t along, std::int32_t along_step, std::int32_t across,
                           const EdgeWalk& edge)
      : at(along + static_cast<std::uint32_t>(wrap_sub(across, product(edge.x, across)))),
        step_down(wrap_sub(along_step, product(edge.step, across))),
        step(across) {}

 private:
  /// distance * change, for a distance in columns with 32 fraction bits; wraps, and is off by less than 3.
  [[nodiscard]] static constexpr std::int32_t product(std::int64_t distance, std::int32_t change) {
    const auto whole = static_cast<std::int32_t>(distance >> 32);
    const auto half_fraction = static_cast<std::int32_t>(static_cast<std::uint32_t>(distance) >> 1);
    return wrap_add(wrap_mul(whole, change), wrap_shl(multiply_high(half_fraction, change), 1));
  }
};

/// u and v of a triangle where they are linear on the screen, on the grid of its pixels: a word of 64 bits
/// with a step per column and a step per row. All wraps, so that neither the edges nor the cuts of a picture
/// matter. `Steps` says what the word holds: TexelSteps or BorderSteps.
struct TextureGrid {
  std::uint64_t at;         ///< at the centre of column 0 of the picture, in the current row
  std::uint64_t step_down;  ///< per row
  std::uint64_t step;       ///< per column

  template <class Steps>
  constexpr void make(const GridCoordinate& u, const GridCoordinate& v, unsigned height_bits) {
    at = Steps::joined(u.at, v.at, height_bits);
    step_down = Steps::step(Steps::rounded(u.step_down, height_bits), v.step_down, height_bits);
    step = Steps::step(u.step, v.step, height_bits);
  }
  /// Adds a level in JoinedLevel::kBits to a grid whose v leaves room for it. At column 0 the level may have
  /// wrapped; by each time v is off by 2^-14 texels, 1/32 at most.
  constexpr void add_level(const GridCoordinate& level) {
    at += level.at >> JoinedLevel::kRoundedBits;
    step_down += static_cast<std::uint64_t>(std::int64_t{JoinedLevel::rounded(level.step_down)});
    step += static_cast<std::uint64_t>(std::int64_t{level.step >> JoinedLevel::kRoundedBits});
  }
  /// At the centre of a column of the current row.
  template <class Steps>
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint64_t at_column(std::uint32_t column) const {
    return Steps::sum(at, Steps::times(step, column));
  }
  template <class Steps>
  ARCSPAN_INLINE constexpr void next_row() {
    at = Steps::sum(at, step_down);
  }
  /// Moves the grid to the right; |pixels| < 2^16.
  template <class Steps>
  constexpr void move_columns(std::int32_t pixels) {
    const std::uint64_t change =
        Steps::times(step, static_cast<std::uint32_t>(pixels < 0 ? -pixels : pixels));
    at = Steps::sum(at, pixels < 0 ? change : Steps::negative(change));
  }
};

}  // namespace arcspan
