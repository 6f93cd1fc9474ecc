// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/band.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// The rows of a sink, from row y of the picture downwards: asks the sink for the memory of every run.
///
/// Instead of stepping by next(), a caller may tell how many `rows` a span is below the current row.
template <class Sink>
class PixelRows {
 public:
  constexpr PixelRows(Sink& sink, std::int32_t) : sink_(sink) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Sink::Format::Cursor open(const Span& span,
                                                                            std::int32_t = 0) const {
    return sink_.open(span);
  }
  /// The cursor behind the span's last pixel.
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Sink::Format::Cursor behind(const Span& span,
                                                                              std::int32_t = 0) const {
    typename Sink::Format::Cursor cursor = sink_.open(span);
    cursor.skip(span.count);
    return cursor;
  }
  ARCSPAN_INLINE constexpr void next() {}

 private:
  Sink& sink_;
};

/// For sinks in memory an address that is stepped from row to row. With few registers a product is cheaper.
template <SinkInMemory Sink>
requires kHasManyRegisters class PixelRows<Sink> {
 public:
  ARCSPAN_INLINE constexpr PixelRows(Sink& sink, std::int32_t y)
      : row_(hidden(sink.row(y))), stride_(sink.stride_bytes() / kUnit) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Sink::Format::Cursor open(const Span& span,
                                                                            std::int32_t rows = 0) const {
    return typename Sink::Format::Cursor(moved_by_units(row_, rows * stride_), span.x);
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Sink::Format::Cursor behind(const Span& span,
                                                                              std::int32_t rows = 0) const {
    return typename Sink::Format::Cursor(moved_by_units(row_, rows * stride_), span.x + span.count);
  }
  ARCSPAN_INLINE constexpr void next() {
    row_ = moved_by_units(row_, stride_);
    hide_value(row_);
  }

 private:
  static constexpr std::int32_t kUnit = kRowUnitBytes<typename Sink::Format::Word>;

  typename Sink::Format::Word* row_;
  std::int32_t stride_;  ///< in RowUnits
};

/// The rows of a depth buffer, from row y of the picture downwards, as an address that is stepped.
template <class Depth>
class DepthRows {
 public:
  ARCSPAN_INLINE constexpr DepthRows(const Depth& depth, std::int32_t y)
      : row_(hidden(depth.row(y))), stride_(depth.stride()) {}
  /// The depth of the span's first pixel.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t* at(const Span& span, std::int32_t rows = 0) const {
    return row_ + (rows * stride_ + span.x);
  }
  /// The depth behind the span's last pixel.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t* behind(const Span& span,
                                                               std::int32_t rows = 0) const {
    return row_ + (rows * stride_ + (span.x + span.count));
  }
  ARCSPAN_INLINE constexpr void next() {
    row_ += stride_;
    hide_value(row_);
  }

 private:
  std::uint16_t* row_;
  std::int32_t stride_;
};

/// With few registers a product is cheaper.
template <class Depth>
requires(!kHasManyRegisters) class DepthRows<Depth> {
 public:
  constexpr DepthRows(const Depth& depth, std::int32_t) : depth_(depth) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t* at(const Span& span, std::int32_t = 0) const {
    return depth_.row(span.y) + span.x;
  }
  ARCSPAN_INLINE constexpr void next() {}

 private:
  const Depth& depth_;
};

template <>
class DepthRows<NoDepth> {
 public:
  constexpr DepthRows(const NoDepth&, std::int32_t) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t* at(const Span&, std::int32_t = 0) const {
    return nullptr;
  }
  ARCSPAN_INLINE constexpr void next() {}
};

/// The memory of the current row of a command: its pixels and its depths.
template <class Target>
struct RowMemory {
  PixelRows<typename Target::Sink> pixels;
  DepthRows<typename Target::Depth> depths;

  ARCSPAN_INLINE constexpr RowMemory(const Target& target, std::int32_t y)
      : pixels(target.sink, y), depths(target.depth, y) {}
  ARCSPAN_INLINE constexpr void next() {
    pixels.next();
    depths.next();
  }
};

}  // namespace arcspan::detail
