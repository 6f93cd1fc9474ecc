// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>

#include <cstdint>

namespace arcspan::hal {

/// Clockwise rotation of the picture relative to the glass.
enum class Orientation : std::uint8_t { k0, k90, k180, k270 };

[[nodiscard]] constexpr bool is_orientation(Orientation o) { return o <= Orientation::k270; }

/// A rotation is applied in two steps: exchange the axes if swaps_axes(o), then mirror columns and rows.
[[nodiscard]] constexpr bool swaps_axes(Orientation o) {
  return o == Orientation::k90 || o == Orientation::k270;
}
[[nodiscard]] constexpr bool mirrors_columns(Orientation o) {
  return o == Orientation::k90 || o == Orientation::k180;
}
[[nodiscard]] constexpr bool mirrors_rows(Orientation o) {
  return o == Orientation::k180 || o == Orientation::k270;
}

/// Geometry of a display module: the part of the controller's memory that its glass shows, and how it is
/// wired. The module's maker decides this, so no controller datasheet states it. Columns and rows are the
/// controller's.
struct Glass {
  std::uint16_t width = 0;
  std::uint16_t height = 0;
  std::uint16_t column_offset = 0;  ///< controller column of the glass's first column
  std::uint16_t row_offset = 0;     ///< controller row of the glass's first row
  bool columns_mirrored = false;    ///< the controller's first column is on the right side
  bool rows_mirrored = false;       ///< the controller's first row is at the bottom
  bool blue_first = false;          ///< subpixels are in the order blue, green, red
  bool inverted = false;            ///< colours are complemented unless the controller inverts (IPS)

  /// True if it is not empty and lies in a controller's memory. int may have 16 bits, in which sums would
  /// wrap.
  [[nodiscard]] constexpr bool fits(std::int32_t columns, std::int32_t rows) const {
    return width > 0 && height > 0 && column_offset <= columns - std::int32_t{width} &&
           row_offset <= rows - std::int32_t{height};
  }
};
static_assert(!Glass{240, 320, 65500, 0}.fits(240, 320) && Glass{200, 320, 40, 0}.fits(240, 320));

/// Whether the controller has to mirror for a picture in orientation `o` on `glass`.
[[nodiscard]] constexpr bool mirrors_columns(const Glass& glass, Orientation o) {
  return mirrors_columns(o) != glass.columns_mirrored;
}
[[nodiscard]] constexpr bool mirrors_rows(const Glass& glass, Orientation o) {
  return mirrors_rows(o) != glass.rows_mirrored;
}

/// `area`, given in picture coordinates, in the controller's columns and rows before mirroring.
[[nodiscard]] constexpr Rect to_controller_axes(const Rect& area, Orientation o) {
  return swaps_axes(o) ? Rect{area.top, area.left, area.bottom, area.right} : area;
}

}  // namespace arcspan::hal
