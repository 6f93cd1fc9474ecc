// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour_segment.hpp>
#include <arcspan/shading/method.hpp>

#include <bit>
#include <cstdint>

namespace arcspan {

/// A row's pixels in segments of 2^bits: the colour of `Inner` is made at a segment's two ends and is linear
/// between them.
///
/// A row that is shorter than a segment is one of the shortest power of two that holds it, and the last
/// segment of a longer one ends at most a row's length beyond it: there the arcs go on as they came.
template <class Inner>
class SegmentRun {
 public:
  /// The inner run is made in place: small cores would copy it by memcpy.
  template <class Walker>
  constexpr SegmentRun(const Walker& walker, const RowStart& start, int bits)
      : inner_(walker.row(start)), bits_(bits) {}

  template <class Lighting>
  constexpr void begin(const Lighting& lighting, std::int32_t count) {
    const int enough = count < 3 ? 0 : 32 - std::countl_zero(static_cast<std::uint32_t>(count - 2));
    bits_ = inner_.stride(enough < bits_ ? enough : bits_);
    end_ = ColourSegment::of(inner_.colour(lighting));
  }
  template <class Lighting>
  [[nodiscard]] constexpr std::int32_t enter(const Lighting& lighting, std::int32_t left) {
    colour_ = end_;
    if (left == 1) return 1;
    inner_.next();
    end_ = ColourSegment::of(inner_.colour(lighting));
    step_ = colour_.step_to(end_, bits_);
    const std::int32_t length = 1 << bits_;
    return left < length ? left : length;
  }
  /// The pixels of the segment that was entered.
  [[nodiscard]] constexpr SegmentPixels segment() const { return {colour_, step_}; }

 private:
  Inner inner_;
  int bits_;
  ColourSegment colour_;
  ColourSegment step_;
  ColourSegment end_;
};

/// Another method's walker, row by row in segments.
template <class Inner>
class SegmentWalker {
 public:
  using Run = SegmentRun<typename Inner::Run>;
  static constexpr std::int32_t kLongestRun = Inner::kLongestRun;

  constexpr SegmentWalker(const Inner& inner, int bits) : inner_(inner), bits_(bits) {}

  [[nodiscard]] constexpr Run row(const RowStart& start) const { return Run(inner_, start, bits_); }
  constexpr void next_row() { inner_.next_row(); }
  constexpr void enter_lower() { inner_.enter_lower(); }

 private:
  Inner inner_;
  int bits_;
};

}  // namespace arcspan
