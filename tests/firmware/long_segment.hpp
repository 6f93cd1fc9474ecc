// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/segment/segment.hpp>

namespace arcspan {

/// Segment with segments of 2^Bits pixels from the start, for the cost scenes: they make an object of a light
/// alone.
template <class Light, int Bits>
struct LongSegment : Segment<Light> {
  struct Lighting : SegmentedIllumination<Light> {
    constexpr explicit Lighting(const Light& light) : SegmentedIllumination<Light>(light) {
      this->bits = Bits;
    }
  };
};

template <class Light>
using LongSegment8 = LongSegment<Light, 3>;
template <class Light>
using LongSegment16 = LongSegment<Light, 4>;

}  // namespace arcspan
