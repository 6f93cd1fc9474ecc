// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>

#include <cstdint>

namespace arcspan::hal {

/// How far the picture is turned clockwise against the glass.
enum class Orientation : std::uint8_t { k0, k90, k180, k270 };

[[nodiscard]] constexpr bool is_orientation(Orientation o) { return o <= Orientation::k270; }

/// A picture is brought to the glass by exchanging its axes first and mirroring columns and rows then.
[[nodiscard]] constexpr bool swaps_axes(Orientation o) {
  return o == Orientation::k90 || o == Orientation::k270;
}
[[nodiscard]] constexpr bool mirrors_columns(Orientation o) {
  return o == Orientation::k90 || o == Orientation::k180;
}
[[nodiscard]] constexpr bool mirrors_rows(Orientation o) {
  return o == Orientation::k180 || o == Orientation::k270;
}

/// How a display is connected to its controller: what the maker of the module decided, and no datasheet of
/// the controller tells. Columns and rows are the controller's, in pixels.
struct Glass {
  std::uint16_t width = 0;
  std::uint16_t height = 0;
  std::uint16_t column_offset = 0;  ///< the controller's column that the glass begins at
  std::uint16_t row_offset = 0;     ///< the controller's row that the glass begins at
  bool columns_mirrored = false;    ///< the controller's first column is on the right
  bool rows_mirrored = false;       ///< the controller's first row is at the bottom
  bool blue_first = false;          ///< the stripes are blue, green, red
  bool inverted = false;            ///< it shows complements unless the controller inverts (IPS glasses)
};

/// Whether the controller has to mirror, for a picture in orientation `o` on `glass`.
[[nodiscard]] constexpr bool mirrors_columns(const Glass& glass, Orientation o) {
  return mirrors_columns(o) != glass.columns_mirrored;
}
[[nodiscard]] constexpr bool mirrors_rows(const Glass& glass, Orientation o) {
  return mirrors_rows(o) != glass.rows_mirrored;
}

/// `area` of the picture in the controller's columns and rows before mirroring.
[[nodiscard]] constexpr Rect on_glass(const Rect& area, Orientation o) {
  return swaps_axes(o) ? Rect{area.top, area.left, area.bottom, area.right} : area;
}

}  // namespace arcspan::hal
