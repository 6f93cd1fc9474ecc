// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// A sink's rows from row y on, one after the other.
template <class Sink>
class PixelRows {
 public:
  constexpr PixelRows(Sink& sink, std::int32_t) : sink_(sink) {}
  [[nodiscard]] constexpr typename Sink::Format::Cursor open(const Span& run) const {
    return sink_.open(run);
  }
  constexpr void next() {}

 private:
  Sink& sink_;
};

/// In memory by an address that is stepped, which with few registers costs more than a product.
template <SinkInMemory Sink>
requires kHasManyRegisters class PixelRows<Sink> {
 public:
  constexpr PixelRows(Sink& sink, std::int32_t y) : row_(sink.row(y)), stride_(sink.stride()) {}
  [[nodiscard]] constexpr typename Sink::Format::Cursor open(const Span& run) const {
    return typename Sink::Format::Cursor(row_, run.x);
  }
  /// Behind the run's last pixel.
  [[nodiscard]] constexpr typename Sink::Format::Cursor end(const Span& run) const {
    return typename Sink::Format::Cursor(row_, run.x + run.count);
  }
  constexpr void next() {
    row_ += stride_;
    hide_value(row_);
  }

 private:
  typename Sink::Format::Word* row_;
  std::int32_t stride_;
};

/// The same of a depth buffer.
template <class Depth, bool Steps = kHasManyRegisters>
class DepthRows {
 public:
  constexpr DepthRows(const Depth& depth, std::int32_t y)
      : row_(depth.row(y)), stride_(depth.bounds().right) {}
  [[nodiscard]] constexpr std::uint16_t* at(const Span& run) const { return row_ + run.x; }
  [[nodiscard]] constexpr std::uint16_t* end(const Span& run) const { return row_ + (run.x + run.count); }
  constexpr void next() {
    row_ += stride_;
    hide_value(row_);
  }

 private:
  std::uint16_t* row_;
  std::int32_t stride_;
};

template <>
class DepthRows<DepthBuffer, false> {
 public:
  constexpr DepthRows(const DepthBuffer& depth, std::int32_t) : depth_(depth) {}
  [[nodiscard]] constexpr std::uint16_t* at(const Span& run) const { return depth_.row(run.y) + run.x; }
  constexpr void next() {}

 private:
  const DepthBuffer& depth_;
};

template <bool Steps>
class DepthRows<NoDepth, Steps> {
 public:
  constexpr DepthRows(const NoDepth&, std::int32_t) {}
  [[nodiscard]] constexpr std::uint16_t* at(const Span&) const { return nullptr; }
  constexpr void next() {}
};

}  // namespace arcspan::detail
