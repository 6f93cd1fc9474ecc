// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/shading/adaptive/adaptive_illumination.hpp>
#include <arcspan/shading/adaptive/linear_light.hpp>
#include <arcspan/shading/arc/arc.hpp>
#include <arcspan/shading/segment/segment.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

/// A row with a highlight whose distance goes by second differences, as N·L does: no product a pixel.
template <class Lighting>
class HighlightPatchRun : public PatchScalars<2> {
 public:
  static constexpr std::size_t kUsed = 2;

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    return lighting.colour_with_highlight_at(scalars()[0], scalars()[1].raw());
  }
  /// The same, encoded; `encoded` is an EncodedColourTable.
  template <class Format, class Colours>
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded encoded(const Lighting& lighting,
                                                                          const Colours& encoded) const {
    if constexpr (Colours::kForHighlights) {
      return lighting.template encoded_with_highlight_at<Format>(scalars()[0], scalars()[1].raw(), encoded);
    } else {
      return Format::encode(colour(lighting));
    }
  }
};

/// Arc with, per triangle, the cheapest way whose predicted error is within a tolerance (S0 section 4 for the
/// segments, whose length is chosen too):
///
///     light that is linear on the screen    no highlight above half the tolerance within reach, and the
///                                           normals' circle so small that the arcs' rise is below it
///     no highlight                          none above half the tolerance within reach
///     highlight by its own distance         small triangles, all of them lit: quadratic, as N·L is
///     segments of 4...16 pixels             wide rows whose colours hardly second_difference, away from the
///     terminator arc                                   everything else
template <class Illumination>
struct Adaptive : Arc<Illumination> {
  using Base = Arc<Illumination>;
  using Lighting = AdaptiveIllumination<Illumination>;
  using typename Base::Face;
  using typename Base::Path;
  using typename Base::Vertex;
  struct Prepared : Base::Prepared {
    FullLinearPlane light;
    int segment_bits;
    bool linear_light;     ///< N·L alone, linear on the screen
    bool highlight_patch;  ///< N·L and the highlight's distance as patches
  };

  template <class Frame>
  static constexpr void prepare(const Lighting& lighting, Frame& frame, const Face&, Prepared& prepared) {
    const TriangleChords& chords = frame.chords;
    prepared.middle_left = frame.middle_left;
    prepared.linear_light = false;
    prepared.highlight_patch = false;
    prepared.segment_bits = 0;
    if constexpr (Base::kHasDiffusePath) {
      if (chords.widest() <= kWidestPatch) {
        const std::int32_t nearest = nearest_highlight(lighting, frame);
        if (nearest >= lighting.half_tolerance_reach() &&
            prepare_without_highlight(frame, lighting.linear_limit(nearest), prepared)) {
          return;
        }
      }
    }
    const bool fits_patch = chords.widest() <= lighting.widest_patch() && patch_fits(frame);
    prepared.segment_bits = segment_bits(lighting, frame);
    if constexpr (kHasHighlightPatch) {
      if (fits_patch && prepared.segment_bits == 0 && chords.widest() <= lighting.highlight_patch_limit()) {
        prepared.highlight_patch = prepare_highlight_patch(lighting, frame, prepared);
        if (prepared.highlight_patch) return;
      }
    }
    Base::prepare_path(frame, fits_patch ? Path::kPatch : Path::kArcs, prepared);
  }

  template <class Draw>
  [[nodiscard]] ARCSPAN_INLINE static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if constexpr (Base::kHasDiffusePath) {
      if (prepared.linear_light)
        return draw(LinearLightWalker<Lighting>(prepared.light, prepared.middle_left));
    }
    if constexpr (kHasHighlightPatch) {
      if (prepared.highlight_patch) {
        return draw(
            PatchWalker<HighlightPatchRun<Lighting>, Base::kScalars>(prepared.patch, prepared.middle_left));
      }
    }
    if (prepared.segment_bits == 0) return Base::walk(prepared, draw);
    return Base::walk(prepared, [&](auto walker) {
      return draw(SegmentWalker<decltype(walker)>(walker, prepared.segment_bits));
    });
  }

 private:
  static constexpr bool kHasHighlightPatch =
      Base::kHasDiffusePath && Illumination::kModel == Highlight::kPhong;

  template <class Frame>
  [[nodiscard]] static constexpr std::int32_t nearest_highlight(const Lighting& lighting,
                                                                const Frame& frame) {
    return lighting.nearest_highlight(frame.top->shade.scalars, frame.middle->shade.scalars,
                                      frame.bottom->shade.scalars, kPatchHeadroom);
  }
  /// Whether a highlight above half the tolerance is within reach.
  template <class Frame>
  [[nodiscard]] static constexpr bool shines(const Lighting& lighting, const Frame& frame) {
    return nearest_highlight(lighting, frame) < lighting.half_tolerance_reach();
  }

  /// Prepares N·L alone, linear if that is within `linear_limit`; false if the triangle fits neither.
  template <class Frame>
  [[nodiscard]] static constexpr bool prepare_without_highlight(Frame& frame, std::uint32_t linear_limit,
                                                                Prepared& prepared) {
    const std::int32_t a = LinearLight::level(frame.top->shade.scalars[0]);
    const std::int32_t b = LinearLight::level(frame.middle->shade.scalars[0]);
    const std::int32_t c = LinearLight::level(frame.bottom->shade.scalars[0]);
    const std::int32_t upper = a > b ? a : b;
    const std::uint32_t radius2 = squared_radius(frame.chords);
    if (linear_rise(radius2, upper > c ? upper : c) <= linear_limit) {
      prepared.linear_light = true;
      const auto lift = static_cast<std::int32_t>(radius2 >> (28 - LinearLight::kFraction + 2));
      const auto lifted = [lift](std::int32_t level) {
        return level + (wrap_mul(level, lift) >> LinearLight::kFraction);
      };
      make_linear_plane(frame, lifted(a), lifted(b), lifted(c), prepared.light);
      return true;
    }
    if (!patch_fits(frame)) return false;
    Base::prepare_path(frame, Path::kDiffusePatch, prepared);
    return true;
  }

  /// Prepares N·L and the highlight's scaled distance as patches; false if a normal turns away from the light
  /// or the distances do not fit.
  template <class Frame>
  [[nodiscard]] static constexpr bool prepare_highlight_patch(const Lighting& lighting, const Frame& frame,
                                                              Prepared& prepared) {
    const TriangleChords& chords = frame.chords;
    constexpr std::int32_t kLit = std::int32_t{1} << 20;  // more than rounding can take away
    const auto& top = frame.top->shade.scalars;
    const auto& middle = frame.middle->shade.scalars;
    const auto& bottom = frame.bottom->shade.scalars;
    if (top[0].raw() < kLit || middle[0].raw() < kLit || bottom[0].raw() < kLit) return false;
    std::int32_t farthest = 0;
    const auto distance = [&](Cosine light, Cosine eye) {
      const std::int32_t half = lighting.half_distance(light, eye);
      if (half > farthest) farthest = half;
      return half;
    };
    QuadrupleSagittas light;
    const auto half_way = [&](const auto& a, const auto& b, std::uint32_t chord, Cosine& rise) {
      const SagittaFactor sagitta4 = sagitta_factor(chord);
      rise = detail::quadruple_sagitta(a[0], b[0], sagitta4);
      return distance(detail::patch_middle(a[0], b[0], rise),
                      detail::patch_middle(a[1], b[1], detail::quadruple_sagitta(a[1], b[1], sagitta4)));
    };
    const std::int32_t top_middle = half_way(top, middle, chords.top_middle, light.top_middle);
    const std::int32_t top_bottom = half_way(top, bottom, chords.top_bottom, light.top_bottom);
    const std::int32_t middle_bottom = half_way(middle, bottom, chords.middle_bottom, light.middle_bottom);
    const std::int32_t at_top = distance(top[0], top[1]);
    const std::int32_t at_middle = distance(middle[0], middle[1]);
    const std::int32_t at_bottom = distance(bottom[0], bottom[1]);
    const HighlightTable& ramp = lighting.highlight_table();
    if (!ramp.fits(farthest)) return false;
    make_patch_surface(frame, {top[0], middle[0], bottom[0]}, light, prepared.patch[0]);
    const auto scaled = [&ramp](std::int32_t half) { return Cosine::from_raw(ramp.scaled(half)); };
    const PatchValues at{scaled(at_top), scaled(at_middle), scaled(at_bottom)};
    const QuadrupleSagittas rises{
        detail::quadruple_sagitta_through(at.top, at.middle, scaled(top_middle)),
        detail::quadruple_sagitta_through(at.top, at.bottom, scaled(top_bottom)),
        detail::quadruple_sagitta_through(at.middle, at.bottom, scaled(middle_bottom))};
    make_patch_surface(frame, at, rises, prepared.patch[1]);
    return true;
  }

  /// The squared radius of the circle through the three normals (if its centre is within the triangle; else
  /// of that around the widest edge), at most 16 degrees apart; 28 fraction bits, of which 25 are used.
  ///
  /// With c the longest chord and e = a^2 + b^2 - c^2 >= 0 it is at most c^2/4 + e/12.
  [[nodiscard]] static constexpr std::uint32_t squared_radius(const TriangleChords& chords) {
    const std::uint32_t widest = chords.widest();
    const std::uint32_t others = chords.top_middle + chords.top_bottom + chords.middle_bottom - widest;
    const std::uint32_t excess = others > widest ? others - widest : 0;
    // 4% for the higher terms of 16 degrees.
    return (widest >> 2) + (excess >> 3) - (excess >> 5) + (widest >> 6);
  }

  /// Twice what N·L, at most `most_level`, rises above the plane through its vertices: where it is positive,
  /// it never falls below. 28 fraction bits.
  [[nodiscard]] static constexpr std::uint32_t linear_rise(std::uint32_t radius2, std::int32_t most_level) {
    if (most_level <= 0) return 0;
    return (radius2 >> 9) * ((static_cast<std::uint32_t>(most_level) >> 6) + 1);
  }

  /// Whether every N·L keeps its sign, with a margin whose square is `margin2` (28 fraction bits): where it
  /// changes, colours have a kink and highlights end at once. A segment may end a quarter row beyond the
  /// edge.
  template <class Frame>
  [[nodiscard]] static constexpr bool away_from_terminator(const Frame& frame, std::uint32_t margin2) {
    const auto square = [](std::int32_t v) { return static_cast<std::uint32_t>(wrap_mul(v >> 16, v >> 16)); };
    for (std::size_t i = 0; i < Illumination::kLights; ++i) {
      const std::int32_t a = frame.top->shade.scalars[i].raw();
      const std::int32_t b = frame.middle->shade.scalars[i].raw();
      const std::int32_t c = frame.bottom->shade.scalars[i].raw();
      if (((a ^ b) | (b ^ c)) < 0) return false;
      if (square(a) <= margin2 || square(b) <= margin2 || square(c) <= margin2) return false;
    }
    return true;
  }

  /// The longest segments that the object's limit allows on the triangle's rows, and that its rows are
  /// worth, or 0.
  template <class Frame>
  [[nodiscard]] static constexpr int segment_bits(const Lighting& lighting, const Frame& frame) {
    const TriangleChords& chords = frame.chords;
    // With one light a pixel without highlight is a look-up: segments must be longer to pay.
    constexpr int kLeastBits = Illumination::kLights == 1 ? 3 : 2;
    constexpr std::uint32_t kLeastWidth = 4u << kLeastBits;
    const std::uint32_t whole = frame.width >> 16;
    if (whole < kLeastWidth) return 0;
    // The widest row is no wider an angle than the wider of the two edges at the middle vertex; a row's
    // pixels are not quite even in angle, which the limit's quarter covers.
    const std::uint32_t limit = lighting.segment_limit(shines(lighting, frame));
    const std::uint32_t width = whole > 1023 ? 1023 : whole;
    const std::uint32_t across =
        chords.top_middle > chords.middle_bottom ? chords.top_middle : chords.middle_bottom;
    if (!away_from_terminator(frame, across >> 4)) return 0;
    const std::uint32_t allowed = (limit >> 8) - (limit >> 10);
    const std::uint64_t room = static_cast<std::uint64_t>(allowed) * (width * width);
    for (int bits = kMostSegmentBits; bits >= kLeastBits; --bits) {
      if ((width >> bits) >= 4 && (static_cast<std::uint64_t>(across >> 8) << (2 * bits)) <= room)
        return bits;
    }
    return 0;
  }
};

}  // namespace arcspan
