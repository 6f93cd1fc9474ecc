// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/span/draw_run.hpp>
#include <arcspan/span/row_memory.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

/// The span stage: per row and per pixel only multiply, shift, add, compare and look up.
namespace arcspan {

/// Where the middle pixel of the viewport lies in the picture: commands are relative to it.
struct RasterOrigin {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

namespace detail {

/// Where a command's present row lies in memory.
template <class Target>
struct RowMemory {
  PixelRows<typename Target::Sink> pixels;
  DepthRows<typename Target::Depth> depths;

  constexpr RowMemory(const Target& target, std::int32_t y)
      : pixels(target.sink, y), depths(target.depth, y) {}
  constexpr void next() {
    pixels.next();
    depths.next();
  }
};

/// A walker for the few triangles that another will not do for, with much to set up for a run: its rows and
/// its runs are functions of their own, which leaves the registers to the others.
template <class Walker>
concept WalksApart = bool{Walker::kApart};

/// Draws one run of pixels, `span`, of the row that the walkers stand on and whose first column is `begin`.
template <class Command, class Walker, class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_one_run(const Command& command, const Walker& shade,
                                                           const Span& span, std::int32_t begin,
                                                           const Target& target,
                                                           const RowMemory<Target>& memory) {
  const RowStart start = row_start(command.left, command.right, span.x - begin);
  typename Walker::Run run = shade.row(start);
  // Elsewhere the run's two ends in memory cost as much as one of them and its length.
  if constexpr (kHasWideRegisters && DrawsWords<Target, typename Walker::Run> &&
                requires { memory.pixels.end(span); }) {
    Linear z = linear_at(command.depth, start);
    draw_words(memory.pixels.end(span).pixels(), memory.depths.end(span), z, span, run, target,
               command.depth.dx);
  } else {
    draw_run(
        RowPlace<Target>{memory.pixels.open(span), memory.depths.at(span), linear_at(command.depth, start)},
        span, run, target, command.depth.dx);
  }
  return target.sink.close(span);
}

/// draw_one_run() in a function of its own: next to the rows it would not find registers enough.
template <class Command, class Walker, class Target>
[[nodiscard]] ARCSPAN_OUTLINE constexpr Status draw_run_apart(const Command& command, const Walker& shade,
                                                              const Span& span, std::int32_t begin,
                                                              const Target& target,
                                                              const RowMemory<Target>& memory) {
  const Target held = target;  // no reference, so that its members can be in registers too
  return draw_one_run(command, shade, span, begin, held, memory);
}

/// Draws one run where it costs less.
template <class Command, class Walker, class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_next_run(const Command& command, const Walker& shade,
                                                            const Span& span, std::int32_t begin,
                                                            const Target& target,
                                                            const RowMemory<Target>& memory) {
  if constexpr (WalksApart<Walker> || (kHasManyRegisters && SegmentedRun<typename Walker::Run>)) {
    return draw_run_apart(command, shade, span, begin, target, memory);
  } else {
    return draw_one_run(command, shade, span, begin, target, memory);
  }
}

/// Draws `span` of the row that the walkers stand on, whose first column is `begin`.
template <class Command, class Walker, class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_span(const Command& command, const Walker& shade,
                                                        Span span, std::int32_t begin, const Target& target,
                                                        const RowMemory<Target>& memory) {
  if constexpr (Walker::kLongestRun >= 2 * kGuardBand) {
    return draw_next_run(command, shade, span, begin, target, memory);
  } else {
    const std::int32_t last = span.x + span.count;
    while (true) {
      if (span.count > Walker::kLongestRun) span.count = Walker::kLongestRun;
      const Status status = draw_next_run(command, shade, span, begin, target, memory);
      span.x += span.count;
      span.count = last - span.x;
      if (!ok(status) || span.count == 0) return status;
    }
  }
}

/// Whether a command's rows are cut at the sides of the clip rectangle.
enum class Sides : std::uint8_t {
  kWhole,  ///< they lie within it
  kCut,
};

/// Draws what is to be seen of the row that the walkers stand on: if no side cuts its command, all of it.
template <Sides AtSides, class Command, class Walker, class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_row(const Command& command, const Walker& shade,
                                                       std::int32_t y, const Target& target,
                                                       const RowMemory<Target>& memory) {
  const std::int32_t begin = command.left.column();
  const std::int32_t end = command.right.column();
  std::int32_t first = begin;
  std::int32_t last = end;
  if constexpr (AtSides == Sides::kCut) {
    if (begin < target.clip.left) first = target.clip.left;
    if (end > target.clip.right) last = target.clip.right;
  }
  if (first >= last) return Status::kOk;
  return draw_span(command, shade, {y, first, last - first}, begin, target, memory);
}

/// Steps a command's edges and attributes down by one row, in place.
template <class Target, class Command, class Walker>
ARCSPAN_INLINE constexpr void next_row(Command& command, Walker& shade) {
  reload_from_memory(command.left);
  reload_from_memory(command.right);
  if constexpr (kHasManyRegisters) reload_from_memory(command.depth.left);
  command.left.advance();
  command.right.advance();
  if constexpr (Target::kTests) command.depth.next_row();
  shade.next_row();
}

/// Changes to the lower edge on the side of the middle vertex.
template <class Target, class Command, class Walker>
ARCSPAN_INLINE constexpr void enter_lower(Command& command, Walker& shade) {
  EdgeWalk& short_edge = command.middle_left ? command.left : command.right;
  short_edge.x = command.lower.x;  // member by member: small cores would call memcpy
  short_edge.step = command.lower.step;
  if constexpr (Target::kTests) command.depth.enter_lower(command.middle_left);
  shade.enter_lower();
}

/// Steps over the rows y ... end - 1, which are not to be seen.
template <class Target, class Command, class Walker>
constexpr void skip_rows(Command& command, Walker& shade, std::int32_t& y, std::int32_t end) {
  for (; y < end; ++y) next_row<Target>(command, shade);
}

/// From relative to the raster origin to columns of the picture.
template <class Command>
ARCSPAN_INLINE constexpr void place_columns(Command& command, std::int32_t origin_x) {
  const std::int64_t shift = static_cast<std::int64_t>(static_cast<std::uint64_t>(origin_x) << 32);
  command.left.x += shift;
  command.right.x += shift;
  command.lower.x += shift;
}

/// Steps over the rows above `top`, and into the lower half if that is where it lies. `half_end` is where the
/// present half ends, `stop` the other.
template <class Target, class Command, class Walker>
constexpr void skip_above(Command& command, Walker& shade, std::int32_t& y, std::int32_t top,
                          std::int32_t& half_end, std::int32_t stop) {
  skip_rows<Target>(command, shade, y, half_end < top ? half_end : top);
  if (y == top) return;
  enter_lower<Target>(command, shade);
  half_end = stop;
  skip_rows<Target>(command, shade, y, top);
}

template <Sides AtSides, class Command, class Walker, class Target>
[[nodiscard]] constexpr Status draw_rows(Command& command, const RasterOrigin& origin, Walker shade,
                                         const Target& target) {
  const Rect& clip = target.clip;
  place_columns(command, origin.x);
  const std::int32_t end = command.end_row + origin.y;
  const std::int32_t stop = end < clip.bottom ? end : clip.bottom;
  const std::int32_t middle = command.middle_row + origin.y;
  std::int32_t half_end = middle < stop ? middle : stop;
  std::int32_t y = command.first_row + origin.y;
  if (y < clip.top) skip_above<Target>(command, shade, y, clip.top, half_end, stop);
  for (RowMemory<Target> memory(target, y);; y = half_end, half_end = stop) {
    // Counted down, since few sinks ask for y.
    for (std::int32_t left = half_end - y; left > 0;
         --left, memory.next(), next_row<Target>(command, shade)) {
      const Status status = draw_row<AtSides>(command, shade, half_end - left, target, memory);
      if (!ok(status)) return status;
    }
    if (half_end >= stop) return Status::kOk;
    enter_lower<Target>(command, shade);
  }
}

/// draw_rows() in a function of its own: next to others it would take their registers.
template <Sides AtSides, class Command, class Walker, class Target>
[[nodiscard]] ARCSPAN_OUTLINE constexpr Status draw_rows_apart(Command& command, const RasterOrigin& origin,
                                                               const Walker& shade, const Target& target) {
  return draw_rows<AtSides>(command, origin, shade, target);
}

/// Draws a command's rows by the walker that its method has for it.
template <Sides AtSides, ShadingMethod Method, class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr Status walk_command(TriangleCommand<Method>& command,
                                                           const RasterOrigin& origin, const Target& target) {
  return Method::walk(command.shade, [&](auto walker) {
    // Long rows can pay the call.
    if constexpr (SegmentedRun<typename decltype(walker)::Run> || WalksApart<decltype(walker)>) {
      return draw_rows_apart<AtSides>(command, origin, walker, target);
    } else {
      return draw_rows<AtSides>(command, origin, walker, target);
    }
  });
}

/// walk_command() in a function of its own, for few commands are cut.
template <ShadingMethod Method, class Target>
[[nodiscard]] ARCSPAN_OUTLINE constexpr Status walk_cut_command(TriangleCommand<Method>& command,
                                                                const RasterOrigin& origin,
                                                                const Target& target) {
  const Target held = target;
  return walk_command<Sides::kCut>(command, origin, held);
}

/// Whether a loop of their own for rows that no side cuts is worth its code.
inline constexpr bool kWholeRowsPay = !kOptimisedForSize && kHasManyRegisters;

/// draw_command() into a RowTarget, which may have codes made beforehand. With `WholeRows` commands that no
/// side cuts have a loop of their own; without, `sides` does not matter.
template <bool WholeRows, ShadingMethod Method, class Target>
[[nodiscard]] constexpr Status draw_command_with(TriangleCommand<Method>& command, const RasterOrigin& origin,
                                                 const Target& target, Sides sides) {
  const Rect& clip = target.clip;
  if (command.end_row + origin.y <= clip.top || command.first_row + origin.y >= clip.bottom) {
    return Status::kOk;
  }
  if constexpr (!WholeRows) {
    return walk_command<Sides::kCut>(command, origin, target);
  } else {
    if (sides == Sides::kCut) [[unlikely]] {
      return walk_cut_command(command, origin, target);
    }
    return walk_command<Sides::kWhole>(command, origin, target);
  }
}

}  // namespace detail

/// Draws a command into the sink's and the depth target's common bounds. Returns the sink's first status that
/// is not kOk, having stopped there. Rows above the bounds are walked, not skipped, so that a picture drawn
/// in bands is bit for bit the picture drawn at once.
template <ShadingMethod Method, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] constexpr Status draw_command(TriangleCommand<Method>& command, const RasterOrigin& origin,
                                            const Rect& clip, const typename Method::Lighting& lighting,
                                            Sink& sink, const Depth& depth) {
  if (clip.empty()) return Status::kOk;
  const NoEncodedColours encoded(lighting);
  const detail::RowTarget<typename Method::Lighting, Sink, Depth> target{clip, lighting, sink, depth,
                                                                         encoded};
  return detail::draw_command_with<false>(command, origin, target, detail::Sides::kCut);
}

}  // namespace arcspan
