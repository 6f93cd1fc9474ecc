// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/prepare/triangle_command.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/draw_pixels.hpp>
#include <arcspan/span/row_memory.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <type_traits>

/// The span stage: walks down the rows of a triangle command and along each row. Per row and per pixel it
/// only multiplies, shifts, adds, compares and looks up; scripts/check-objects proves that nothing here
/// divides.
namespace arcspan {

/// Position of the viewport's middle pixel in the picture, in pixels. Commands are relative to it.
struct RasterOrigin {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

namespace detail {

/// How a command's rows meet the left and right side of the scissor.
enum class ScissorColumns : std::uint8_t {
  kInside,    ///< every row lies within the scissor
  kCrossing,  ///< rows have to be cut
  kEither     ///< rows have to be cut if RowTarget::crosses is true
};

/// Steps the edges, the depth and the shading of a command down by one row, in place.
template <class Target, class Command, class Walker>
ARCSPAN_INLINE constexpr void next_row(Command& command, Walker& walker) {
  reload_from_memory(command.left);
  reload_from_memory(command.right);
  if constexpr (kHasManyRegisters) reload_from_memory(command.depth.left);
  command.left.advance();
  command.right.advance();
  if constexpr (Target::Depth::kTests) command.depth.next_row();
  walker.next_row();
}

/// Replaces the upper short edge by the lower one, on the side of the middle vertex.
template <class Target, class Command, class Walker>
ARCSPAN_INLINE constexpr void enter_lower(Command& command, Walker& walker) {
  EdgeWalk& short_edge = command.middle_left ? command.left : command.right;
  short_edge.x = command.lower.x;  // compilers call memcpy for the whole struct on small cores
  short_edge.step = command.lower.step;
  if constexpr (Target::Depth::kTests) command.depth.enter_lower(command.middle_left);
  walker.enter_lower();
}

/// Draws the pixels of `span` in the current row. `begin` is the row's first column; the span may start right
/// of it.
template <class Command, class Walker, class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_run(const Command& command, const Walker& walker,
                                                       const Span& span, std::int32_t begin,
                                                       const Target& target,
                                                       const RowMemory<Target>& memory) {
  static_assert(RowWalker<Walker, typename Target::Lighting>);
  using Run = typename Walker::Run;
  const RowStart start = row_start(command.unit, command.left, command.right, span.x - begin, span.x);
  if constexpr (kWalksWholeRows<Run, typename Target::Lighting>) {
    std::int32_t first = span.x;  // or, left of it, the row's first column that is in the picture
    if constexpr (!SinkFromFirstColumn<typename Target::Sink>)
      first = begin >= 0 ? begin : span.x < 0 ? span.x : 0;
    Run run = walker.row(row_start(command.unit, command.left, command.right, first - begin, first));
    return draw_pieces(span, span.x - first, command.right.column() - (span.x + span.count), run,
                       linear_at(command.depth, start), command.depth.dx, target, memory);
  } else {
    Run run = walker.row(start);
    if constexpr (PiecewiseRun<Run, typename Target::Lighting>) {
      return draw_pieces(span, 0, 0, run, linear_at(command.depth, start), command.depth.dx, target, memory);
    } else {
      return draw_span(span, run, linear_at(command.depth, start), command.depth.dx, target, memory);
    }
  }
}

/// draw_run() as a function of its own, by a `Walker`: in programs that are optimised for size gcc would keep
/// the values of its loop on the stack.
template <class Walker, class Command, class Target>
[[nodiscard]] ARCSPAN_OUTLINE Status draw_run_outlined(const void* walker, const Command& command,
                                                       const Span& span, std::int32_t begin,
                                                       const Target& target,
                                                       const RowMemory<Target>& memory) {
  const Target local = target;  // the members of a reference would be loaded again for every pixel
  return draw_run(command, *static_cast<const Walker*>(walker), span, begin, local, memory);
}

/// A walker of any type, so that all walkers of a method share one loop over rows in programs that are
/// optimised for size: a loop takes 400 bytes, the calls 10 instructions per row on a Cortex-M3.
template <class Command, class Target>
class AnyWalker {
 public:
  /// `walker` must outlive this.
  template <class Walker>
  constexpr explicit AnyWalker(Walker& walker)
      : walker_(&walker),
        draw_run_(&draw_run_outlined<Walker, Command, Target>),
        next_row_(&next<Walker>),
        enter_lower_(&lower<Walker>) {}

  [[nodiscard]] Status draw_run(const Command& command, const Span& span, std::int32_t begin,
                                const Target& target, const RowMemory<Target>& memory) const {
    return draw_run_(walker_, command, span, begin, target, memory);
  }
  void next_row() { next_row_(walker_); }
  void enter_lower() { enter_lower_(walker_); }

 private:
  template <class Walker>
  static void next(void* walker) {
    static_cast<Walker*>(walker)->next_row();
  }
  template <class Walker>
  static void lower(void* walker) {
    static_cast<Walker*>(walker)->enter_lower();
  }

  void* walker_;
  Status (*draw_run_)(const void*, const Command&, const Span&, std::int32_t, const Target&,
                      const RowMemory<Target>&);
  void (*next_row_)(void*);
  void (*enter_lower_)(void*);
};

/// True if a method's rows cost little more than the test of a flag or an indirect call: the walkers of such
/// methods have loops of their own.
template <class Command>
inline constexpr bool kHasCheapRows = sizeof(Command::shade) <= 64;

/// Draws the visible part of the current row, at row y of the picture.
template <ScissorColumns kColumns, class Command, class Walker, class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_row(const Command& command, const Walker& walker,
                                                       std::int32_t y, const Target& target,
                                                       const RowMemory<Target>& memory) {
  const std::int32_t begin = command.left.column();
  std::int32_t first = begin;
  std::int32_t last = command.right.column();
  if (kColumns == ScissorColumns::kCrossing || (kColumns == ScissorColumns::kEither && target.crosses)) {
    if (first < target.scissor.left) first = target.scissor.left;
    if (last > target.scissor.right) last = target.scissor.right;
  }
  if (first >= last) return Status::kOk;
  const Span span{y, first, last - first};
  if constexpr (std::is_same_v<Walker, AnyWalker<Command, Target>>) {
    return walker.draw_run(command, span, begin, target, memory);
  } else if constexpr (kOptimisedForSize) {
    return draw_run_outlined<Walker>(&walker, command, span, begin, target, memory);
  } else {
    return draw_run(command, walker, span, begin, target, memory);
  }
}

/// Draws the rows of a command that lie within the scissor. A method's walk() calls it with the walker of its
/// choice.
template <ScissorColumns kColumns, class Command, class Target>
struct RowDrawer {
  Command& command;
  const RasterOrigin& origin;
  const Target& target;

  template <class Walker>
  [[nodiscard]] constexpr Status operator()(Walker walker) const {
    if constexpr (kOptimisedForSize && !kHasCheapRows<Command>) {
      return draw_outlined(command, origin, AnyWalker<Command, Target>(walker), target);
    } else {
      return draw(command, origin, walker, target);
    }
  }

 private:
  [[nodiscard]] ARCSPAN_OUTLINE static Status draw_outlined(Command& command, const RasterOrigin& origin,
                                                            const AnyWalker<Command, Target>& walker,
                                                            const Target& target) {
    return draw(command, origin, walker, target);
  }
  /// Not with members, which gcc would load again for every row.
  template <class Walker>
  [[nodiscard]] static constexpr Status draw(Command& command, const RasterOrigin& origin, Walker walker,
                                             const Target& target) {
    command.move_columns(origin.x);
    const std::int32_t end = command.end_row + origin.y;
    const std::int32_t stop = end < target.scissor.bottom ? end : target.scissor.bottom;
    const std::int32_t middle = command.middle_row + origin.y;
    std::int32_t half_end = middle < stop ? middle : stop;
    std::int32_t y = command.first_row + origin.y;
    // Rows above the scissor are stepped one by one, so that those that follow have the same bits.
    if (y < target.scissor.top) [[unlikely]] {
      for (; y < target.scissor.top; ++y, next_row<Target>(command, walker)) {
        if (y != half_end) continue;
        enter_lower<Target>(command, walker);
        half_end = stop;
      }
    }
    for (RowMemory<Target> memory(target, y);; y = half_end, half_end = stop) {
      // Counts down, because few sinks need y and the counter then is its own test.
      for (std::int32_t left = half_end - y; left > 0;
           --left, memory.next(), next_row<Target>(command, walker)) {
        const Status status = draw_row<kColumns>(command, walker, half_end - left, target, memory);
        if (!ok(status)) return status;
      }
      if (half_end >= stop) return Status::kOk;
      enter_lower<Target>(command, walker);
    }
  }
};

}  // namespace detail

}  // namespace arcspan
