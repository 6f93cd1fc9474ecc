// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/arc.hpp>
#include <arcspan/shading/segment/segment_walker.hpp>
#include <arcspan/status.hpp>

namespace arcspan {

inline constexpr int kMostSegmentBits = 4;

/// An object's illumination, and the length of its segments: 2^bits pixels.
template <class Illumination>
struct SegmentedIllumination : Illumination {
  int bits = 2;

  constexpr SegmentedIllumination() = default;
  constexpr SegmentedIllumination(const Illumination& illumination) : Illumination(illumination) {}

  /// 1...kMostSegmentBits, else kInvalidArgument and nothing changes.
  [[nodiscard]] constexpr Status set_segment_bits(int value) {
    if (value < 1 || value > kMostSegmentBits) return Status::kInvalidArgument;
    bits = value;
    return Status::kOk;
  }
};

/// The combined method of segments (S0 section 4, S3): the arcs step 2^j pixels at once, the power and the
/// colour are made there, and between them colours are linear. What that costs in accuracy grows with the
/// square of the angle that a segment spans, and with n.
template <class Illumination>
struct Segment : Arc<Illumination> {
  using Base = Arc<Illumination>;
  using Lighting = SegmentedIllumination<Illumination>;
  using typename Base::Face;
  using typename Base::Vertex;
  static constexpr bool kUsesEncodedColours = false;
  struct Prepared : Base::Prepared {
    int bits;
  };

  template <class Frame>
  static constexpr void prepare(const Lighting& lighting, Frame& frame, const Face& face,
                                Prepared& prepared) {
    prepared.bits = lighting.bits;
    Base::prepare(lighting, frame, face, prepared);
  }

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return Base::walk(
        prepared, [&](auto walker) { return draw(SegmentWalker<decltype(walker)>(walker, prepared.bits)); });
  }
};

}  // namespace arcspan
