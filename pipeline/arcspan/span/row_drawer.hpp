// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/span/row_memory.hpp>
#include <arcspan/span/run_drawer.hpp>
#include <arcspan/span/step_rows.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <type_traits>

/// The span stage: walks down the rows of a triangle command and along each row. Per row and per pixel it
/// only multiplies, shifts, adds, compares and looks up; scripts/check-objects proves that nothing here
/// divides.
namespace arcspan {

namespace detail {

/// How a command's rows meet the left and right side of the scissor.
enum class ScissorColumns : std::uint8_t {
  kInside,   ///< every row lies within the scissor
  kCrossing  ///< rows have to be cut
};

/// Draws the pixels of `span` in the current row. `begin` is the row's first column; the span may start right
/// of it. Shortens `span` if the run is shorter (LimitedRun).
template <class Command, class Walker, class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_run(const Command& command, const Walker& walker,
                                                       Span& span, std::int32_t begin, const Target& target,
                                                       const RowMemory<Target>& memory) {
  static_assert(RowWalker<Walker, typename Target::Lighting>);
  const RowStart start = row_start(command.left, command.right, span.x - begin, span.x);
  const RunDrawer<Command, Target> draw{command, start, span, target, memory};
  if constexpr (ChoosesRuns<Walker, typename Target::Lighting>) {
    return walker.with_run(start, target.lighting, draw);
  } else {
    typename Walker::Run run = walker.row(start);
    return draw(run);
  }
}

/// draw_run() in a function of its own, for runs that need many registers.
template <class Command, class Walker, class Target>
[[nodiscard]] ARCSPAN_OUTLINE constexpr Status draw_run_outlined(const Command& command, const Walker& walker,
                                                                 Span& span, std::int32_t begin,
                                                                 const Target& target,
                                                                 const RowMemory<Target>& memory) {
  // A copy, because the members of a reference would be loaded again for every pixel.
  const Target local = target;
  return draw_run(command, walker, span, begin, local, memory);
}

/// Draws the visible part of the current row, at row y of the picture; in several runs if they are
/// LimitedRun.
template <ScissorColumns kColumns, class Command, class Walker, class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_row(const Command& command, const Walker& walker,
                                                       std::int32_t y, const Target& target,
                                                       const RowMemory<Target>& memory) {
  const std::int32_t begin = command.left.column();
  std::int32_t first = begin;
  std::int32_t last = command.right.column();
  if constexpr (kColumns == ScissorColumns::kCrossing) {
    if (first < target.scissor.left) first = target.scissor.left;
    if (last > target.scissor.right) last = target.scissor.right;
  }
  if (first >= last) return Status::kOk;
  Span span{y, first, last - first};
  while (true) {
    Status status;
    if constexpr (OutlinedWalker<Walker> || kOptimisedForSize ||
                  (kHasManyRegisters && SegmentedRun<typename Walker::Run>)) {
      status = draw_run_outlined(command, walker, span, begin, target, memory);
    } else {
      status = draw_run(command, walker, span, begin, target, memory);
    }
    if constexpr (!LimitedRun<typename Walker::Run>) {
      return status;
    } else {
      span.x += span.count;
      span.count = last - span.x;
      if (!ok(status) || span.count == 0) return status;
    }
  }
}

/// True if the rows of a walker are functions of their own: their set-up takes more registers than are left
/// beside other walkers, or they would take registers from those.
template <class Walker>
inline constexpr bool kOutlineRows =
    OutlinedWalker<Walker> || OutlinedRowLoop<Walker> || SegmentedRun<typename Walker::Run>;

/// Draws the rows of a command that lie within the scissor. A method's walk() calls it with the walker of its
/// choice.
template <ScissorColumns kColumns, class Command, class Target>
struct RowDrawer {
  Command& command;
  const RasterOrigin& origin;
  const Target& target;

  template <class Walker>
  [[nodiscard]] constexpr Status operator()(Walker walker) const {
    if constexpr (JoinsDepth<Walker> && Target::Depth::kTests) {
      return draw(command, origin, walker.with_depth(command.depth), target);
    } else if constexpr (kOutlineRows<Walker>) {
      // One row loop serves both kinds of columns, because these rows take much longer than the test or are
      // few.
      return RowDrawer<ScissorColumns::kCrossing, Command, Target>::draw_outlined(command, origin, walker,
                                                                                  target);
    } else {
      return draw(command, origin, walker, target);
    }
  }

  template <class Walker>
  [[nodiscard]] ARCSPAN_OUTLINE static constexpr Status draw_outlined(Command& command,
                                                                      const RasterOrigin& origin,
                                                                      const Walker& walker,
                                                                      const Target& target) {
    // No copy for draw_run_outlined(), which makes one.
    std::conditional_t<OutlinedWalker<Walker>, const Target&, const Target> local = target;
    return draw(command, origin, walker, local);
  }

 private:
  template <class Walker>
  [[nodiscard]] static constexpr Status draw(Command& command, const RasterOrigin& origin, Walker walker,
                                             const Target& target) {
    std::int32_t y;
    std::int32_t half_end;
    std::int32_t stop;
    start_rows(command, walker, origin, target, y, half_end, stop);
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

/// A RowDrawer whose loop over the rows is a part of its caller, unless the walker asks for a function of its
/// own (kOutlineRows) or for depth and scalars together (JoinsDepth). For methods with many walkers, of
/// which compilers would give some a function, where a row costs a sixth more. The loop is written twice,
/// because a shared one changes the compiler's choice for methods with one walker (decision 16).
template <ScissorColumns kColumns, class Command, class Target>
struct InlinedRowDrawer : RowDrawer<kColumns, Command, Target> {
  using Base = RowDrawer<kColumns, Command, Target>;

  template <class Walker>
  [[nodiscard]] ARCSPAN_INLINE constexpr Status operator()(Walker walker) const {
    if constexpr (kOutlineRows<Walker> || (JoinsDepth<Walker> && Target::Depth::kTests)) {
      return Base::operator()(walker);
    } else {
      return draw_inlined(this->command, this->origin, walker, this->target);
    }
  }

 private:
  template <class Walker>
  [[nodiscard]] ARCSPAN_INLINE static constexpr Status draw_inlined(Command& command,
                                                                    const RasterOrigin& origin, Walker walker,
                                                                    const Target& target) {
    std::int32_t y;
    std::int32_t half_end;
    std::int32_t stop;
    start_rows(command, walker, origin, target, y, half_end, stop);
    for (RowMemory<Target> memory(target, y);; y = half_end, half_end = stop) {
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

/// The RowDrawer of a method: InlinedRowDrawer for those that draw small triangles, too, which have many
/// walkers.
template <ShadingMethod Method, ScissorColumns kColumns, class Target>
using RowDrawerOf = std::conditional_t<DrawsSmallTriangles<Method> && !kOptimisedForSize,
                                       InlinedRowDrawer<kColumns, TriangleCommand<Method>, Target>,
                                       RowDrawer<kColumns, TriangleCommand<Method>, Target>>;

/// True if DrawFeatures::whole_rows is worth its code: a second loop for rows within the scissor.
inline constexpr bool kWholeRowsPay = !kOptimisedForSize && kHasManyRegisters;

}  // namespace detail

}  // namespace arcspan
