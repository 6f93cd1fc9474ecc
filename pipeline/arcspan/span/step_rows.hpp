// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/edge.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// Position of the viewport's middle pixel in the picture, in pixels. Commands are relative to it.
struct RasterOrigin {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

namespace detail {

/// True if the span stage steps the depth from row to row, and not `Walker`.
template <class Target, class Walker>
inline constexpr bool kStepsDepthItself = Target::Depth::kTests && !CarriesDepth<typename Walker::Run>;

/// Steps the edges, the depth and the shading of a command down by one row, in place.
template <class Target, class Command, class Walker>
ARCSPAN_INLINE constexpr void next_row(Command& command, Walker& walker) {
  reload_from_memory(command.left);
  reload_from_memory(command.right);
  if constexpr (kHasManyRegisters && !CarriesDepth<typename Walker::Run>)
    reload_from_memory(command.depth.left);
  command.left.advance();
  command.right.advance();
  if constexpr (kStepsDepthItself<Target, Walker>) command.depth.next_row();
  walker.next_row();
}

/// Replaces the upper short edge by the lower one, on the side of the middle vertex.
template <class Target, class Command, class Walker>
ARCSPAN_INLINE constexpr void enter_lower(Command& command, Walker& walker) {
  EdgeWalk& short_edge = command.middle_left ? command.left : command.right;
  // Member by member, because compilers call memcpy for the whole struct on small cores.
  short_edge.x = command.lower.x;
  short_edge.step = command.lower.step;
  if constexpr (kStepsDepthItself<Target, Walker>) command.depth.enter_lower(command.middle_left);
  walker.enter_lower();
}

/// Steps the edges and the depth of a command down by `rows` rows.
template <bool WithDepth, class Command>
ARCSPAN_OUTLINE constexpr void skip_rows_of_command(Command& command, std::int32_t rows) {
  command.left.advance(rows);
  command.right.advance(rows);
  if constexpr (WithDepth) command.depth.skip_rows(rows);
}

/// Steps down `rows` rows of one half of the triangle without drawing. The rows that follow are exactly those
/// that next_row() leads to.
template <class Target, class Command, class Walker>
constexpr void skip_rows(Command& command, Walker& walker, std::int32_t rows) {
  if constexpr (SkipsRows<Walker> && !kOptimisedForSize) {
    if (rows == 0) return;  // then the edges of this half may be unset
    skip_rows_of_command<kStepsDepthItself<Target, Walker>>(command, rows);
    walker.skip_rows(rows);
  } else {
    for (; rows > 0; --rows) next_row<Target>(command, walker);
  }
}

/// Steps a command down from row y to row `top` without drawing. `half_end`, where the current half of the
/// triangle ends, becomes `end` if the lower half is entered.
template <class Target, class Command, class Walker>
constexpr void step_to_row(Command& command, Walker& walker, std::int32_t& y, std::int32_t top,
                           std::int32_t& half_end, std::int32_t end) {
  if (half_end < top) {
    skip_rows<Target>(command, walker, half_end - y);
    y = half_end;
    enter_lower<Target>(command, walker);
    half_end = end;
  }
  skip_rows<Target>(command, walker, top - y);
  y = top;
}

/// Steps to the first row of a command that lies within the scissor, and sets `y` to that row of the picture,
/// `half_end` to the end of its half and `stop` to that of all rows. Not a structure, which gcc keeps in
/// memory on Armv6-M.
template <class Command, class Walker, class Target>
ARCSPAN_INLINE constexpr void start_rows(Command& command, Walker& walker, const RasterOrigin& origin,
                                         const Target& target, std::int32_t& y, std::int32_t& half_end,
                                         std::int32_t& stop) {
  const Rect& scissor = target.scissor;
  command.move_columns(origin.x);
  const std::int32_t end = command.end_row + origin.y;
  stop = end < scissor.bottom ? end : scissor.bottom;
  const std::int32_t middle = command.middle_row + origin.y;
  half_end = middle < stop ? middle : stop;
  y = command.first_row + origin.y;
  if (y < scissor.top) {
    if constexpr (!kCopiesForCalls<Walker>) {
      step_to_row<Target>(command, walker, y, scissor.top, half_end, stop);
    } else {
      Walker stepped = walker;
      std::int32_t row = y;
      std::int32_t row_end = half_end;
      step_to_row<Target>(command, stepped, row, scissor.top, row_end, stop);
      walker = stepped;
      y = row;
      half_end = row_end;
    }
  }
}

}  // namespace detail

}  // namespace arcspan
