// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/phong.hpp>
#include <arcspan/literature/segment.hpp>

#include <bit>
#include <cstdint>

namespace arcspan {

/// The combined method as S3 prints it: a row is cut into segments of 2^k pixels, k fixed or adaptive
/// (SegmentedIllumination), the colours at their ends are those of `Unit`'s Phong, and the colour is linear
/// between them. The last segment has full length too and is drawn up to the row's end, so that its right end
/// may lie outside of the triangle, on the continued normal. Segments start at the first pixel of a row that
/// is visible.
template <class Illumination, class Unit>
struct NormalSegments
    : LinearNormalMethod<SegmentedIllumination<Illumination>, detail::NormalisedColour<Unit>> {
  using Base = LinearNormalMethod<SegmentedIllumination<Illumination>, detail::NormalisedColour<Unit>>;
  using typename Base::Face;
  using typename Base::Lighting;
  struct Prepared : Base::Prepared {
    int bits;
  };

  template <class Method>
  static constexpr void prepare(const Lighting& lighting, const TriangleFrame<Method>& frame,
                                const Face& face, Prepared& prepared) {
    Base::prepare(lighting, frame, face, prepared);
    prepared.bits = lighting.bits;
    if (lighting.widest == 0) return;
    prepared.bits = literature::adaptive_segment_bits(
        lighting.widest, prepared.normal.step(), to_normal(frame.top->shade), to_normal(frame.middle->shade),
        to_normal(frame.bottom->shade));
  }

  /// The segments of a row (PiecewiseRun).
  class Run {
   public:
    [[nodiscard]] static constexpr Run of_row(const Prepared& prepared, const RowStart& start) {
      Run run;
      run.normal_ = prepared.normal.at(start);
      run.step_ = prepared.normal.step();
      run.bits_ = prepared.bits;
      return run;
    }
    [[nodiscard]] constexpr std::int32_t enter(const Lighting& lighting, std::int32_t left) {
      if (!is_started_) end_ = ColourSegment::of(detail::NormalisedColour<Unit>::colour(lighting, normal_));
      is_started_ = true;
      colour_ = end_;
      end_ = ColourSegment::of(detail::NormalisedColour<Unit>::colour(lighting, normal_ahead()));
      colour_step_ = colour_.step_to(end_, bits_);
      const auto ahead = [this](Linear step) { return Linear::from_raw(wrap_shl(step.raw(), bits_)); };
      normal_.advance({ahead(step_.x), ahead(step_.y), ahead(step_.z)});
      const std::int32_t length = 1 << bits_;
      return left < length ? left : length;
    }
    [[nodiscard]] constexpr ColourSegment colour(const Lighting&) const { return colour_; }
    constexpr void next() { colour_.advance(colour_step_); }

   private:
    /// The normal 2^bits pixels ahead, times a power of two that brings its largest component to 1/2...1.
    /// Beyond the triangle components reach 2^5 and would not fit a Linear.
    [[nodiscard]] constexpr LinearNormal normal_ahead() const {
      constexpr int kRoom = 5;
      const auto ahead = [this](Linear at, Linear step) {
        return wrap_add(at.raw() >> kRoom, step.raw() >> (kRoom - bits_));
      };
      const std::int32_t x = ahead(normal_.x, step_.x);
      const std::int32_t y = ahead(normal_.y, step_.y);
      const std::int32_t z = ahead(normal_.z, step_.z);
      const auto size = [](std::int32_t c) { return static_cast<std::uint32_t>(c < 0 ? -c : c); };
      const int zeros = std::countl_zero(size(x) | size(y) | size(z) | 1u);
      constexpr int kZeros = 32 - (Linear::kFraction + 15);  // of a component just below 1
      const auto scaled = [zeros](std::int32_t c) {
        return Linear::from_raw(zeros >= kZeros ? wrap_shl(c, zeros - kZeros) : c >> (kZeros - zeros));
      };
      return {scaled(x), scaled(y), scaled(z)};
    }

    LinearNormal normal_;  ///< at the segment's right end, from which the next one starts
    LinearNormal step_;    ///< per pixel
    int bits_;
    ColourSegment colour_;
    ColourSegment colour_step_;
    ColourSegment end_;
    bool is_started_ = false;
  };

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return draw(PreparedWalker<Prepared, Run>(prepared));
  }
};

/// NormalSegments whose ends are classic Phong's.
template <class Illumination>
using PhongSegment = NormalSegments<Illumination, detail::UnitByDivision>;

}  // namespace arcspan
