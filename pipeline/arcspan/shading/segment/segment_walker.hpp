// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour_segment.hpp>
#include <arcspan/shading/method.hpp>

#include <bit>
#include <cstdint>

namespace arcspan {

/// The pixels of a row in segments of 2^bits pixels (PiecewiseRun). The colour of `Inner` is computed at both
/// ends of a segment and is linear between them.
///
/// A row that is shorter than a segment is one segment of the smallest power of two that holds it. The last
/// segment of a longer row may end beyond the row, by less than the row's length; its end lies on the
/// continued arc. The same holds for each piece of an `Inner` that is a PiecewiseRun.
template <class Inner>
class SegmentRun {
 public:
  /// Constructs the inner run in place, because small cores would copy it by memcpy.
  template <class Walker>
  constexpr SegmentRun(const Walker& walker, const RowStart& start, int bits)
      : inner_(walker.row(start)), most_bits_(bits) {}

  /// Steps to the next segment and returns its number of pixels, at most `left`, those left in the row.
  template <class Lighting>
  [[nodiscard]] constexpr std::int32_t enter(const Lighting& lighting, std::int32_t left) {
    if (inner_left_ == 0) begin(lighting, left);
    colour_.red_blue = end_.red_blue;  // member by member: small cores would copy the whole by memcpy
    colour_.green = end_.green;
    std::int32_t length = 1;
    if (inner_left_ != 1) {
      inner_.next();
      end_ = ColourSegment::of(inner_.colour(lighting));
      step_ = colour_.step_to(end_, bits_);
      length = 1 << bits_;
    }
    if (length > inner_left_) length = inner_left_;
    inner_left_ -= length;
    return length;
  }
  template <class Lighting>
  [[nodiscard]] constexpr ColourSegment colour(const Lighting&) const {
    return colour_;
  }
  constexpr void next() { colour_.advance(step_); }

 private:
  /// Starts the segments of a piece of the inner run.
  template <class Lighting>
  constexpr void begin(const Lighting& lighting, std::int32_t left) {
    inner_left_ = left;
    if constexpr (PiecewiseRun<Inner, Lighting>) inner_left_ = inner_.enter(lighting, left);
    const int enough =
        inner_left_ < 3 ? 0 : 32 - std::countl_zero(static_cast<std::uint32_t>(inner_left_ - 2));
    bits_ = inner_.stride(enough < most_bits_ ? enough : most_bits_);
    end_ = ColourSegment::of(inner_.colour(lighting));
  }

  Inner inner_;
  int most_bits_;
  int bits_ = 0;
  std::int32_t inner_left_ = 0;  ///< pixels of the piece of the inner run
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
  constexpr void enter_lower() { inner_.enter_lower(); }

 private:
  Inner inner_;
  int bits_;
};

}  // namespace arcspan
