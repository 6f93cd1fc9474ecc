// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/colour_segment.hpp>
#include <arcspan/literature/highlights_over.hpp>
#include <arcspan/literature/linear_normal.hpp>
#include <arcspan/literature/patch.hpp>
#include <arcspan/literature/segment_path.hpp>
#include <arcspan/literature/wide_rows.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The longest segments have 2^kMostSegmentBits = 16 pixels.
inline constexpr int kMostSegmentBits = 4;

/// An object's illumination, and the length of its segments: 2^UsualBits pixels unless it is set.
template <class Illumination, int UsualBits = 2>
struct SegmentedIllumination : Illumination {
  int bits = UsualBits;
  /// If segments are adaptive, the squared chord that one may turn by, 28 fraction bits; 0 otherwise.
  std::uint32_t widest = 0;

  constexpr SegmentedIllumination() = default;
  constexpr SegmentedIllumination(const Illumination& illumination) : Illumination(illumination) {}

  /// Sets the length to 2^value pixels. Returns kInvalidArgument and changes nothing unless `value` is in
  /// 1...kMostSegmentBits.
  [[nodiscard]] constexpr Status set_segment_bits(int value) {
    if (value < 1 || value > kMostSegmentBits) return Status::kInvalidArgument;
    bits = value;
    widest = 0;
    return Status::kOk;
  }

  /// Makes each triangle choose its segments by the accuracy wanted, as S3 asks: the longest of 1 to
  /// 2^kMostSegmentBits pixels in whose middle linear light is at most 1/64 too dark, relative to itself. For
  /// the light's power n, `shininess`, that error is 1 - cos^n(psi/2) at an angle psi, and at most n s/8 at
  /// its squared chord s. The last segment of a row may leave the triangle and then err by more. Returns
  /// kInvalidArgument and changes nothing unless `shininess` is in 1...256.
  [[nodiscard]] constexpr Status set_adaptive_segments(std::int32_t shininess) {
    if (shininess < 1 || shininess > 256) return Status::kInvalidArgument;
    widest = (std::uint32_t{1} << 25) / static_cast<std::uint32_t>(shininess);
    return Status::kOk;
  }
};

namespace literature {

/// Returns the bits of the longest segment, 0...kMostSegmentBits, whose unit normals are at most the squared
/// chord `limit` (28 fraction bits) apart. `step` is the change of the triangle's linear normal per pixel.
[[nodiscard]] constexpr int adaptive_segment_bits(std::uint32_t limit, const LinearNormal& step,
                                                  const Normal& top, const Normal& middle,
                                                  const Normal& bottom) {
  const NormalChords chords{squared_chord(top, middle), squared_chord(top, bottom),
                            squared_chord(middle, bottom)};
  // The linear normal is nowhere shorter than sqrt(1 - s/3), which an equilateral triangle has in its middle.
  const std::uint32_t third = chords.widest() / 3;
  constexpr std::uint32_t kOne = std::uint32_t{1} << 28;
  const std::uint64_t most = (std::uint64_t{limit} * (third < kOne ? kOne - third : 0)) >> 28;
  const auto squared = [](Linear c) {
    const std::int64_t fine = c.raw();  // 27 fraction bits
    return static_cast<std::uint64_t>(fine * fine) >> 2;
  };
  std::uint64_t square = (squared(step.x) + squared(step.y) + squared(step.z)) >> 24;  // 28 fraction bits
  int bits = 0;
  while (bits < kMostSegmentBits && (square << 2) <= most) {
    square <<= 2;
    ++bits;
  }
  return bits;
}

}  // namespace literature

namespace literature {

/// The pixels of a row in segments of 2^bits pixels (PiecewiseRun). The colour is computed at both ends of a
/// segment by the scalars of `walker.piece(start)` and is linear between them.
///
/// A piece of a row that is shorter than a segment is one segment of the smallest power of two that holds it.
/// The last segment of a longer piece may end beyond it, by less than its length; its end lies on the
/// continued arc.
template <class Walker>
class SegmentRun {
 public:
  constexpr SegmentRun(const Walker& walker, const RowStart& start, int bits)
      : walker_(&walker), start_(start), most_bits_(bits) {}

  /// Steps to the next segment and returns its number of pixels, at most `left`, those left in the row.
  template <class Lighting>
  [[nodiscard]] constexpr std::int32_t enter(const Lighting& lighting, std::int32_t left) {
    if (left_in_piece_ == 0) begin_piece(lighting, left);
    colour_ = end_;
    std::int32_t length = 1;
    if (left_in_piece_ > 1) {
      piece_.next();
      end_ = ColourSegment::of(piece_.colour(lighting));
      step_ = colour_.step_to(end_, bits_);
      length = 1 << bits_;
      if (length > left_in_piece_) length = left_in_piece_;
    }
    left_in_piece_ -= length;
    return length;
  }
  template <class Lighting>
  [[nodiscard]] constexpr ColourSegment colour(const Lighting&) const {
    return colour_;
  }
  constexpr void next() { colour_.advance(step_); }

 private:
  template <class Lighting>
  constexpr void begin_piece(const Lighting& lighting, std::int32_t left) {
    piece_ = walker_->piece(start_);
    const std::int32_t length = piece_.length();
    left_in_piece_ = length < left ? length : left;
    if (length < left) start_ = rest_of_row(start_, length);
    const int enough =
        left_in_piece_ < 3 ? 0 : 32 - std::countl_zero(static_cast<std::uint32_t>(left_in_piece_ - 2));
    bits_ = enough < most_bits_ ? enough : most_bits_;
    piece_.stride(bits_);
    end_ = ColourSegment::of(piece_.colour(lighting));
  }

  const Walker* walker_;
  RowStart start_;
  int most_bits_;
  std::int32_t left_in_piece_ = 0;
  typename Walker::Piece piece_;
  int bits_ = 0;
  ColourSegment colour_;
  ColourSegment step_;
  ColourSegment end_;
};

/// Draws the rows of `Inner` in segments of 2^bits pixels (RowWalker).
template <class Inner>
class SegmentWalker {
 public:
  using Run = SegmentRun<Inner>;

  constexpr SegmentWalker(const Inner& inner, int bits) : inner_(inner), bits_(bits) {}

  [[nodiscard]] constexpr Run row(const RowStart& start) const { return Run(inner_, start, bits_); }
  constexpr void next_row() { inner_.next_row(); }
  constexpr void enter_lower() { inner_.enter_lower(); }

 private:
  Inner inner_;
  int bits_;
};

/// The pixels of a row of a patch.
template <std::size_t Count>
struct PatchPiece : SecondDifferenceRun<Count> {
  SegmentPath path;

  [[nodiscard]] static constexpr std::int32_t length() { return INT32_MAX; }
  template <class Lighting>
  [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
    if constexpr (Lighting::kHasRamp) {
      if (path == SegmentPath::kDiffusePatch) return lighting.diffuse_colour(this->of[0].x);
      if constexpr (Lighting::kLights > 1) {
        if (path == SegmentPath::kDiffuseSumPatch)
          return lighting.diffuse_colour(lighting.diffuse_sum(this->scalars()));
      }
    }
    return lighting.colour(this->scalars());
  }
};

/// Steps the scalars of a patch's left edge from row to row. It changes the patch in place.
template <std::size_t Count>
class PatchWalker {
 public:
  using Piece = PatchPiece<Count>;

  constexpr PatchWalker(Patch<Count>& patch, SegmentPath path, bool middle_left)
      : patch_(&patch), path_(path), middle_left_(middle_left) {}

  [[nodiscard]] constexpr Piece piece(const RowStart& start) const {
    Piece piece;
    unrolled<Count>([&](auto i) { piece.of[i] = (*patch_)[i].at(start.fraction); });
    piece.skip(start.skipped);
    piece.path = path_;
    return piece;
  }
  constexpr void next_row() {
    unrolled<Count>([this](auto i) { (*patch_)[i].left.advance(); });
  }
  constexpr void enter_lower() {
    if (!middle_left_) return;
    unrolled<Count>([this](auto i) { (*patch_)[i].left = (*patch_)[i].lower; });
  }

 private:
  Patch<Count>* patch_;
  SegmentPath path_;
  bool middle_left_;
};

}  // namespace literature

/// The combined method of segments (S3). The scalars step 2^bits pixels at once on arcs or patches
/// (SegmentPath), the power and the colour are computed there, and between these pixels the colour is linear.
/// Each piece of a wide row starts with a new segment. The error grows with the square of the angle that a
/// segment spans, and with the exponent n.
template <class Illumination>
struct Segment : literature::ArcMethod<SegmentedIllumination<Illumination>, Illumination::kScalars> {
  static constexpr std::size_t kScalars = Illumination::kScalars;
  using Base = literature::ArcMethod<SegmentedIllumination<Illumination>, kScalars>;
  using typename Base::Face;
  using typename Base::Lighting;
  using typename Base::Vertex;
  using Path = literature::SegmentPath;
  using Scalars = std::array<Cosine, kScalars>;
  struct Prepared {
    union {
      literature::Patch<kScalars> patch;
      literature::WideTriangle<kScalars> wide;
      literature::VeryWideTriangle<kScalars> very_wide;
    };
    Path path;
    bool middle_left;
    int bits;
  };

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return {to_normal(normal), lighting.scalars(normal)};
  }
  [[nodiscard]] static constexpr PackedRgb colour_of(const Lighting& lighting, const Scalars& scalars) {
    return lighting.colour(scalars);
  }

  template <class Frame>
  static constexpr void prepare(const Lighting& lighting, const Frame& unmeasured, const Face&,
                                Prepared& prepared) {
    literature::MeasuredFrame<Frame> frame(unmeasured);
    std::uint32_t lit = 0;
    prepared.bits = lighting.widest == 0 ? lighting.bits : adaptive_bits(lighting.widest, unmeasured);
    prepared.middle_left = frame.middle_left;
    prepared.path = literature::choose_segment_path(lighting, frame, lit);
    const Factor widest_piece = literature::widest_piece(lighting.widest_patch());
    if (prepared.path == Path::kWide) {
      prepared.wide.prepare(frame, widest_piece);
    } else if (prepared.path == Path::kVeryWide) {
      prepared.very_wide.prepare(frame, widest_piece);
    } else {
      prepared.patch = {};
      prepare_patch(lighting, frame, lit, prepared);
    }
  }

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    const auto draw_segments = [&](const auto& inner) {
      return draw(literature::SegmentWalker(inner, prepared.bits));
    };
    using literature::WideWalker;
    if (prepared.path == Path::kWide)
      return draw_segments(WideWalker<Segment, literature::WideTriangle, kScalars>(prepared.wide));
    if (prepared.path == Path::kVeryWide)
      return draw_segments(literature::VeryWideWalker<Segment, kScalars>(prepared.very_wide));
    return draw_segments(
        literature::PatchWalker<kScalars>(prepared.patch, prepared.path, prepared.middle_left));
  }

 private:
  template <class Frame>
  [[nodiscard]] static constexpr int adaptive_bits(std::uint32_t limit, const Frame& frame) {
    const auto finer = [](NormalComponent c) { return DirectionComponent::from_raw(wrap_shl(c.raw(), 1)); };
    const auto direction = [&finer](const Normal& n) {
      return Direction{finer(n.x), finer(n.y), finer(n.z)};
    };
    const Normal& top = frame.top->shade.normal;
    const Normal& middle = frame.middle->shade.normal;
    const Normal& bottom = frame.bottom->shade.normal;
    NormalPlane plane;
    make_normal_plane(frame, direction(top), direction(middle), direction(bottom), plane);
    return literature::adaptive_segment_bits(limit, plane.step(), top, middle, bottom);
  }

  /// Makes the scalars of a patch that `prepared.path` needs; the others are 0.
  template <class Frame>
  static constexpr void prepare_patch(const Lighting& lighting, const Frame& frame,
                                      [[maybe_unused]] std::uint32_t lit, Prepared& prepared) {
    const auto& top = frame.top->shade.scalars;
    const auto& middle = frame.middle->shade.scalars;
    const auto& bottom = frame.bottom->shade.scalars;
    std::size_t count = kScalars;
    if constexpr (Illumination::kHasRamp) {
      if (prepared.path == Path::kDark) {
        prepared.path = Path::kDiffusePatch;  // of N·L = 0
        return;
      }
      if (prepared.path == Path::kDiffusePatch) {
        literature::make_patch_scalar(
            frame,
            {lighting.diffuse_scalar(top, lit), lighting.diffuse_scalar(middle, lit),
             lighting.diffuse_scalar(bottom, lit)},
            prepared.patch[0]);
        return;
      }
      if (prepared.path == Path::kDiffuseSumPatch) count = Illumination::kLights;
    }
    for (std::size_t i = 0; i < count; ++i) {
      literature::make_patch_scalar(frame, {top[i], middle[i], bottom[i]}, prepared.patch[i]);
    }
  }
};

}  // namespace arcspan
