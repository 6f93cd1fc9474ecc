// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/checked.hpp>
#include <arcspan/pixel/band.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <type_traits>

namespace arcspan {

/// A rectangle of another sink: a scissor. Drawing into it leaves the pixels outside of the rectangle alone.
/// Inside, the pixels are those of drawing into the whole sink. For split screens, insets and repainting
/// parts of a picture:
///
///     SinkPart inset(frame, {200, 8, 312, 92});
///     draw_mesh<Method>(mesh, transform, lighting, inset, depth);
///
/// It refers to the sink, which must outlive it and may be moved to other bands.
template <PixelSink Sink>
class SinkPart {
 public:
  using Format = typename Sink::Format;
  /// Rows lie in memory if those of the sink do.
  using RowsInMemory = std::conditional_t<SinkInMemory<Sink>, SinkPart, void>;

  constexpr SinkPart(Sink& sink, const Rect& rect) : sink_(sink), rect_(rect) {}

  /// Rect{} if the rectangle does not meet the sink.
  [[nodiscard]] constexpr Rect bounds() const {
    const Rect common = detail::intersection(sink_.bounds(), rect_);
    return common.empty() ? Rect{} : common;
  }
  [[nodiscard]] constexpr typename Format::Cursor open(const Span& run) {
    ARCSPAN_CHECK(detail::is_within(run, bounds()), "SinkPart::open: the run leaves bounds()");
    return sink_.open(run);
  }
  [[nodiscard]] constexpr Status close(const Span& run) { return sink_.close(run); }
  [[nodiscard]] constexpr Status status() const { return detail::status_of(sink_); }
  [[nodiscard]] constexpr auto* row(std::int32_t y) const requires SinkInMemory<Sink> { return sink_.row(y); }
  [[nodiscard]] constexpr std::int32_t stride_bytes() const requires SinkInMemory<Sink> {
    return sink_.stride_bytes();
  }

 private:
  Sink& sink_;
  Rect rect_;
};

}  // namespace arcspan
