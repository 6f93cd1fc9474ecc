// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/line_command.hpp>
#include <arcspan/shading/unlit.hpp>
#include <arcspan/span/draw_pixels.hpp>
#include <arcspan/span/row_drawer.hpp>
#include <arcspan/span/row_memory.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace arcspan {

namespace detail {

/// The walker of a method of one colour in fog, whose pixels are drawn nearer by `bias`: the fog is that of
/// where they are.
template <class Walker>
struct BiasedWalker {
  struct Run : Walker::Run {
    std::uint16_t bias;
    constexpr Run(const BiasedWalker& from, const RowStart& start)
        : Walker::Run(from.walker.row(start)), bias(from.bias) {}
    template <bool As565, class Lighting>
    [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t enter_layer(const Lighting& lighting, Linear z,
                                                                    Linear dz, std::int32_t left) {
      const Linear farther = Linear::from_raw(std::int32_t{bias} << Linear::kFraction);
      return Walker::Run::template enter_layer<As565>(lighting, z + farther, dz, left);
    }
  };
  Walker walker;
  std::uint16_t bias;
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const { return Run(*this, start); }
};

/// The walker itself if it draws no fog: then a bias costs nothing here.
template <class Target, class Walker>
[[nodiscard]] ARCSPAN_INLINE constexpr auto behind_bias(const Walker& walker,
                                                        [[maybe_unused]] std::uint16_t bias) {
  if constexpr (LayeredRun<typename Walker::Run, typename Target::Lighting>) {
    return BiasedWalker<Walker>{walker, bias};
  } else {
    return walker;
  }
}

/// Draws a run of a method of one colour; `z` is the depth of its first pixel, `dz` its gradient.
template <class Walker, class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_one_colour(const Span& span, const Walker& walker,
                                                              Linear z, Linear dz, const Target& target,
                                                              const RowMemory<Target>& memory) {
  typename Walker::Run run = walker.row({});
  return draw_span(span, run, z, dz, target, memory);
}

/// Draws one pixel of a method of one colour: draw_one_colour() without its loop, which takes 9 instructions
/// on a Cortex-M3. With few registers the loop happens to be cheaper.
template <class Walker, class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr Status draw_pixel(const Span& at, const Walker& walker, Linear z,
                                                         const Target& target,
                                                         const RowMemory<Target>& memory) {
  using Format = typename Target::Format;
  if constexpr (!kHasManyRegisters) return draw_one_colour(at, walker, z, {}, target, memory);
  typename Walker::Run run = walker.row({});
  if constexpr (requires { run.begin(target.lighting, at.x, at.y); }) run.begin(target.lighting, at.x, at.y);
  if constexpr (LayeredRun<typename Walker::Run, typename Target::Lighting>)
    (void)run.template enter_layer<kOperates565<Format>>(target.lighting, z, {}, 1);
  const std::uint16_t depth = depth_of(z);
  std::uint16_t* const stored = memory.depths.at(at);
  typename Format::Cursor cursor = memory.pixels.open(at);
  if (!Target::Depth::kTests || Target::Depth::passes(depth, *stored)) {
    const auto colour = run.colour(target.lighting);
    if constexpr (kHasOperation<Target, typename Walker::Run>) {
      draw_operated<Target>(colour, cursor, stored, depth, at.x, at.y);
    } else {
      if constexpr (Target::Depth::kTests && Target::Depth::kWrites) *stored = depth;
      cursor.write(encode_at<Format>(colour, at.x, at.y));
    }
  }
  return target.sink.close(at);
}

/// Draws the rows of a line that lie within the scissor, of which there is at least one.
template <class Target>
class LineDrawer {
 public:
  constexpr LineDrawer(const LineCommand& line, const RasterOrigin& origin, const Target& target)
      : line_(line), target_(target), left_(line.left + origin.x), right_(line.right + origin.x) {
    const std::int32_t top = line.first_row + origin.y;
    const std::int32_t end = line.end_row + origin.y;
    y_ = top < target.scissor.top ? target.scissor.top : top;
    stop_ = end < target.scissor.bottom ? end : target.scissor.bottom;
    last_ = end - 1;
    skipped_ = y_ - top;
    edge_.x = line.edge.x + static_cast<std::int64_t>(static_cast<std::uint64_t>(origin.x) << 32);
    edge_.step = line.edge.step;
  }

  template <class Walker>
  [[nodiscard]] constexpr Status operator()(const Walker& of_method) const {
    const auto walker = behind_bias<Target>(of_method, line_.bias);
    return line_.flat ? draw_flat(walker, target_) : draw_tall(walker, target_);
  }

 private:
  /// One run of pixels per row.
  template <class Walker>
  [[nodiscard]] ARCSPAN_OUTLINE constexpr Status draw_flat(const Walker walker, const Target target) const {
    const bool leftwards = line_.leftwards;
    const Linear step = line_.step;
    EdgeWalk edge = edge_;
    std::int32_t from = leftwards ? right_ : left_;
    if (skipped_ > 0) {
      edge.advance(skipped_ - 1);
      from = edge.column();
      edge.advance();
    }
    RowMemory<Target> memory(target, y_);
    for (std::int32_t y = y_; y < stop_; ++y, edge.advance(), memory.next()) {
      const std::int32_t to = y != last_ ? edge.column() : leftwards ? left_ : right_;
      std::int32_t first = leftwards ? to : from;
      std::int32_t end = leftwards ? from : to;
      from = to;
      if (first < target.scissor.left) first = target.scissor.left;
      if (end > target.scissor.right) end = target.scissor.right;
      if (first >= end) continue;
      const Linear z = line_.depth + Linear::from_raw(wrap_mul(step.raw(), first - left_));
      const Status status = draw_one_colour({y, first, end - first}, walker, z, step, target, memory);
      if (!ok(status)) return status;
    }
    return Status::kOk;
  }

  /// One pixel per row.
  template <class Walker>
  [[nodiscard]] ARCSPAN_OUTLINE constexpr Status draw_tall(const Walker walker, const Target target) const {
    const Linear step = line_.step;
    EdgeWalk edge = edge_;
    edge.advance(skipped_);
    Linear z = line_.depth + Linear::from_raw(wrap_mul(step.raw(), skipped_));
    RowMemory<Target> memory(target, y_);
    for (std::int32_t y = y_; y < stop_; ++y, edge.advance(), z += step, memory.next()) {
      std::int32_t x = edge.column();
      if (x < left_) x = left_;
      if (x >= right_) x = right_ - 1;
      if (x < target.scissor.left || x >= target.scissor.right) continue;
      const Status status = draw_pixel({y, x, 1}, walker, z, target, memory);
      if (!ok(status)) return status;
    }
    return Status::kOk;
  }

  const LineCommand& line_;
  const Target& target_;
  std::int32_t left_;  ///< columns of the line in the picture
  std::int32_t right_;
  std::int32_t y_;        ///< first row to be drawn
  std::int32_t stop_;     ///< row after the last one to be drawn
  std::int32_t last_;     ///< last row of the line
  std::int32_t skipped_;  ///< rows above y_
  EdgeWalk edge_;
};

/// Draws a line command into the scissor of `target`, within which it has a row.
template <OneColour Method, class Target>
[[nodiscard]] constexpr Status draw_line_command(const LineCommand& line, const RasterOrigin& origin,
                                                 const Target& target) {
  typename Method::Prepared nothing{};
  return Method::walk(nothing, LineDrawer<Target>(line, origin, target));
}

/// Draws the pixels of a rectangle of one depth, which is `bias` nearer than where it is; it is not empty and
/// lies within the scissor of `target`.
template <OneColour Method, class Target>
[[nodiscard]] ARCSPAN_OUTLINE constexpr Status draw_rectangle(const Rect& rect, std::uint16_t depth,
                                                              std::uint16_t bias, const Target& all) {
  const Target target = all;  // a copy, because the members of a reference would be loaded for every pixel
  typename Method::Prepared nothing{};
  return Method::walk(nothing, [&](const auto& of_method) {
    const auto walker = behind_bias<Target>(of_method, bias);
    const Linear z = Linear::from_raw(std::int32_t{depth} << Linear::kFraction);
    RowMemory<Target> memory(target, rect.top);
    for (std::int32_t y = rect.top; y < rect.bottom; ++y, memory.next()) {
      const Status status = draw_one_colour({y, rect.left, rect.width()}, walker, z, {}, target, memory);
      if (!ok(status)) return status;
    }
    return Status::kOk;
  });
}

}  // namespace detail

}  // namespace arcspan
