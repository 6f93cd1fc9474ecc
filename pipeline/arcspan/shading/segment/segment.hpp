// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/arc.hpp>
#include <arcspan/shading/segment/segment_walker.hpp>
#include <arcspan/status.hpp>

namespace arcspan {

/// The longest segments have 2^kMostSegmentBits = 16 pixels.
inline constexpr int kMostSegmentBits = 4;

/// An object's illumination, and the length of its segments: 2^bits pixels, 4 by default.
template <class Illumination>
struct SegmentedIllumination : Illumination {
  int bits = 2;

  constexpr SegmentedIllumination() = default;
  constexpr SegmentedIllumination(const Illumination& illumination) : Illumination(illumination) {}

  /// Sets the length to 2^value pixels. Returns kInvalidArgument and changes nothing unless `value` is in
  /// 1...kMostSegmentBits.
  [[nodiscard]] constexpr Status set_segment_bits(int value) {
    if (value < 1 || value > kMostSegmentBits) return Status::kInvalidArgument;
    bits = value;
    return Status::kOk;
  }
};

/// The combined method of segments (S3). The paths of Arc step 2^bits pixels at once, the power
/// and the colour are computed there, and between these pixels the colour is linear. Each piece of a wide row
/// starts with a new segment. The error grows with the square of the angle that a segment spans, and with the
/// exponent n.
template <class Illumination>
struct Segment : Arc<Illumination> {
  using Base = Arc<Illumination>;
  using Lighting = SegmentedIllumination<Illumination>;
  using typename Base::Face;
  using typename Base::Path;
  using typename Base::Vertex;
  struct Prepared : Base::Prepared {
    int bits;
  };

  template <class Frame>
  static constexpr void prepare(const Lighting& lighting, const Frame& unmeasured, const Face&,
                                Prepared& prepared) {
    MeasuredFrame<Frame> frame(unmeasured);
    prepared.bits = lighting.bits;
    const Path path = Base::choose_path(lighting, frame, frame.chords.widest());
    // The last segment may end beyond the row. A highlight can be within reach there, which kDiffuseWide
    // omits and kWide, its replacement where code is optimised for size, does not.
    Base::prepare_path(lighting, frame, path == Path::kDiffuseWide ? Path::kWide : path, prepared);
  }

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return Base::template walk<WalkedPaths::kPrepared>(
        prepared, [&](auto walker) { return draw(SegmentWalker<decltype(walker)>(walker, prepared.bits)); });
  }
};

}  // namespace arcspan
