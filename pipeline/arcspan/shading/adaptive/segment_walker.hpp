// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour_segment.hpp>
#include <arcspan/shading/method.hpp>

#include <bit>
#include <cstdint>

namespace arcspan {

/// The pixels of a row in segments of 2^bits pixels (SegmentedRun). The colour of `Inner` is computed at both
/// ends of a segment and is linear between them.
///
/// A row that is shorter than a segment is one segment of the smallest power of two that holds it. The last
/// segment of a longer row may end beyond the row, by less than the row's length; its end lies on the
/// continued arc.
template <class Inner>
class SegmentRun {
 public:
  /// Constructs the inner run in place, because small cores would copy it by memcpy.
  template <class Walker>
  constexpr SegmentRun(const Walker& walker, const RowStart& start, int bits)
      : inner_(walker.row(start)), bits_(bits) {}

  /// Starts a row of `count` pixels.
  template <class Lighting>
  constexpr void begin(const Lighting& lighting, std::int32_t count) {
    const int enough = count < 3 ? 0 : 32 - std::countl_zero(static_cast<std::uint32_t>(count - 2));
    bits_ = inner_.stride(enough < bits_ ? enough : bits_);
    end_ = ColourSegment::of(inner_.colour(lighting));
  }
  /// Steps to the next segment and returns its number of pixels, at most `left`, those left in the row.
  template <class Lighting>
  [[nodiscard]] constexpr std::int32_t enter(const Lighting& lighting, std::int32_t left) {
    colour_.red_blue = end_.red_blue;  // member by member: small cores would copy the whole by memcpy
    colour_.green = end_.green;
    if (left == 1) return 1;
    inner_.next();
    end_ = ColourSegment::of(inner_.colour(lighting));
    step_ = colour_.step_to(end_, bits_);
    const std::int32_t length = 1 << bits_;
    return left < length ? left : length;
  }
  /// Returns the number of pixels that the inner run may have (LimitedRun).
  [[nodiscard]] constexpr std::int32_t length() const requires LimitedRun<Inner> { return inner_.length(); }
  /// Returns the pixels of the segment that enter() stepped to.
  [[nodiscard]] constexpr SegmentPixels segment() const { return {colour_, step_}; }

 private:
  Inner inner_;
  int bits_;
  ColourSegment colour_;
  ColourSegment step_;
  ColourSegment end_;
};

/// Draws the rows of another method's walker in segments of 2^bits pixels (RowWalker).
template <class Inner>
class SegmentWalker {
 public:
  using Run = SegmentRun<typename Inner::Run>;

  constexpr SegmentWalker(const Inner& inner, int bits) : inner_(inner), bits_(bits) {}

  [[nodiscard]] constexpr Run row(const RowStart& start) const { return Run(inner_, start, bits_); }
  constexpr void next_row() { inner_.next_row(); }
  constexpr void skip_rows(std::int32_t rows) requires SkipsRows<Inner> { inner_.skip_rows(rows); }
  constexpr void enter_lower() { inner_.enter_lower(); }

 private:
  Inner inner_;
  int bits_;
};

}  // namespace arcspan
