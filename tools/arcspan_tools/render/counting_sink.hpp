// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>

#include <cstdint>
#include <type_traits>

namespace arcspan::tools {

/// Hands everything on to another sink and counts the spans and their pixels.
template <PixelSink Target>
class CountingSink {
 public:
  using Format = typename Target::Format;
  using RowsInMemory = std::conditional_t<SinkInMemory<Target>, CountingSink, void>;

  explicit CountingSink(Target& target) : target_(&target) {}

  [[nodiscard]] Rect bounds() const { return target_->bounds(); }
  [[nodiscard]] typename Format::Cursor open(const Span& run) { return target_->open(run); }
  [[nodiscard]] typename Format::Unit* row(std::int32_t y) const requires SinkInMemory<Target> {
    return target_->row(y);
  }
  [[nodiscard]] std::int32_t stride() const requires SinkInMemory<Target> { return target_->stride(); }
  [[nodiscard]] Status close(const Span& run) {
    ++spans_;
    pixels_ += static_cast<std::uint64_t>(run.count);
    return target_->close(run);
  }

  [[nodiscard]] std::uint64_t spans() const { return spans_; }
  [[nodiscard]] std::uint64_t pixels() const { return pixels_; }

 private:
  Target* target_;
  std::uint64_t spans_ = 0;
  std::uint64_t pixels_ = 0;
};

}  // namespace arcspan::tools
