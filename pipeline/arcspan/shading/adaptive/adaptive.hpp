// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/shading/adaptive/adaptive_illumination.hpp>
#include <arcspan/shading/adaptive/linear_light.hpp>
#include <arcspan/shading/arc/arc.hpp>
#include <arcspan/shading/segment/segment.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

/// The pixels of a row (PixelRun) with the highlight of one light. Second differences step both
/// diffuse_scalar() and the highlight's scaled distance (HighlightTable), so no product is computed per pixel
/// (decision 7).
template <class Lighting>
class HighlightPatchRun : public SecondDifferenceRun<2> {
 public:
  static constexpr std::size_t kUsed = 2;

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    return lighting.colour_with_highlight_at(scalars()[0], scalars()[1].raw(), weight());
  }
  /// Returns the parts of colour() (LightRun).
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    return lighting.light_with_highlight_at(scalars()[0], scalars()[1].raw(), weight());
  }
  /// Returns colour() encoded in `Format`; `encoded` is an EncodedColourTable (EncodingRun).
  template <class Format, class Colours>
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded encoded(const Lighting& lighting,
                                                                          const Colours& encoded) const {
    if constexpr (Colours::kForHighlights) {
      return lighting.template encoded_with_highlight_at<Format>(scalars()[0], scalars()[1].raw(), weight(),
                                                                 encoded);
    } else {
      return Format::encode(colour(lighting));
    }
  }
  constexpr void set_weight(std::uint32_t weight) {
    if constexpr (Lighting::kLights > 1) weight_[0] = weight;
  }

 private:
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t weight() const {
    if constexpr (Lighting::kLights > 1) return weight_[0];
    return std::uint32_t{1} << 15;
  }
  std::array<std::uint32_t, Lighting::kLights == 1 ? 0 : 1> weight_;  ///< highlight_weight() of its light
};

/// Steps a highlight patch (RowWalker).
template <class Lighting, std::size_t Count>
class HighlightPatchWalker : public PatchWalker<HighlightPatchRun<Lighting>, Count> {
 public:
  using Base = PatchWalker<HighlightPatchRun<Lighting>, Count>;
  using typename Base::Run;

  constexpr HighlightPatchWalker(Patch<Count>& patch, bool middle_left, std::uint32_t weight)
      : Base(patch, middle_left), weight_(weight) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run = Base::row(start);
    run.set_weight(weight_);
    return run;
  }

 private:
  std::uint32_t weight_;
};

/// Arc with the cheapest path per triangle whose predicted error is within a tolerance (decisions 6 and 7).
/// The paths are tried in this order; those without highlight and the highlight patch need a ramp, and that
/// each of several lights reaches the whole triangle or nothing of it:
///
/// 1. Light that is linear on the screen: no highlight above half the tolerance is within reach, and the
///    circle through the normals is so small that N·L differs from a plane by at most the rest of the
///    tolerance.
/// 2. A patch of N·L alone: no highlight above half the tolerance is within reach.
/// 3. Segments of 4...16 pixels (S3): wide rows whose colours have small second derivatives, away
///    from the terminator.
/// 4. A patch of N·L and of a highlight's distance: small triangles whose vertices are all lit, within reach
/// of the
///    highlight of one light.
/// 5. The paths of Arc: a patch of every scalar, or arcs.
template <class Illumination>
struct Adaptive : Arc<Illumination> {
  using Base = Arc<Illumination>;
  using Lighting = AdaptiveIllumination<Illumination>;
  using DrawsSmallTrianglesAs = Adaptive;
  using typename Base::Face;
  using typename Base::Path;
  using typename Base::Vertex;
  struct Prepared : Base::Prepared {
    FullLinearPlane light;
    int segment_bits;      ///< path 3: segments have 2^segment_bits pixels; 0 for none
    bool linear_light;     ///< path 1: N·L alone, in `light`
    bool highlight_patch;  ///< path 4: the patch has the diffuse scalar and a highlight's scaled distance
    std::uint32_t highlight_weight;  ///< path 4: of the light
  };

  template <class Frame>
  static constexpr void prepare(const Lighting& lighting, Frame& frame, const Face&, Prepared& prepared) {
    const TriangleChords& chords = frame.chords;
    prepared.middle_left = frame.middle_left;
    prepared.linear_light = false;
    prepared.highlight_patch = false;
    prepared.segment_bits = 0;
    if constexpr (Base::kHasDiffusePath) {
      if (chords.widest() <= kWidestArc) {
        const std::int32_t nearest = nearest_highlight(lighting, frame);
        if (nearest >= lighting.half_tolerance_reach() && Base::has_diffuse_scalar(lighting, frame)) {
          prepare_without_highlight(lighting, frame, lighting.linear_limit(nearest), prepared);
          return;
        }
      }
    }
    const bool fits_patch = chords.widest() <= lighting.widest_patch() && patch_fits(frame);
    prepared.segment_bits = segment_bits(lighting, frame);
    if constexpr (kHasHighlightPatch) {
      if (fits_patch && prepared.segment_bits == 0 && chords.widest() <= kWidestBounded &&
          chords.widest() <= lighting.highlight_patch_limit()) {
        prepared.highlight_patch = prepare_highlight_patch(lighting, frame, prepared);
        if (prepared.highlight_patch) return;
      }
    }
    Base::prepare_path(lighting, frame, fits_patch ? Path::kPatch : Path::kWide, prepared);
  }

  /// A small triangle (DrawsSmallTriangles): linear light, or as Arc draws it without highlights below half
  /// the tolerance.
  struct Small {
    union {
      SmallLinearLight<Lighting> light;
      typename Base::Small arc;
    };
    bool linear_light;
  };
  template <class Raster>
  [[nodiscard]] static constexpr bool prepare_small(const Lighting& lighting, const Raster& a,
                                                    const Raster& b, const Raster& c,
                                                    const SmallTriangle& triangle, Small& small) {
    const TriangleChords chords = chords_between(a.shade.normal, b.shade.normal, c.shade.normal);
    small.linear_light = false;
    bool shines = true;
    if constexpr (Base::kHasDiffusePath) {
      const std::int32_t nearest = lighting.nearest_highlight(a.shade.scalars, b.shade.scalars,
                                                              c.shade.scalars, arc_headroom(chords.widest()));
      shines = nearest < lighting.half_tolerance_reach();
      std::uint32_t lit = 0;
      if (!shines && chords.widest() <= kWidestBounded &&
          lighting.lit_throughout(a.shade.scalars, b.shade.scalars, c.shade.scalars, lit)) {
        const LinearLevels levels(chords, lighting.diffuse_scalar(a.shade.scalars, lit),
                                  lighting.diffuse_scalar(b.shade.scalars, lit),
                                  lighting.diffuse_scalar(c.shade.scalars, lit));
        if (levels.quadruple_error() <= lighting.linear_limit(nearest)) {
          small.linear_light = true;
          small.light.prepare(levels.lifted(levels.a), levels.lifted(levels.b), levels.lifted(levels.c),
                              triangle);
          return true;
        }
      }
    }
    return small.arc.prepare(lighting, SmallCorners{a, b, c}, chords, shines, triangle);
  }
  /// Calls `draw` with the surface of a small triangle.
  template <class Draw>
  [[nodiscard]] static constexpr Status walk_small(const Small& small, Draw&& draw) {
    if constexpr (Base::kHasDiffusePath) {
      if (small.linear_light) return draw(small.light);
    }
    return small.arc.walk(draw);
  }

  template <class Draw>
  [[nodiscard]] ARCSPAN_INLINE static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if constexpr (Base::kHasDiffusePath) {
      if (prepared.linear_light)
        return draw(LinearLightWalker<Lighting>(prepared.light, prepared.middle_left));
    }
    if constexpr (kHasHighlightPatch) {
      if (prepared.highlight_patch) {
        return draw(HighlightPatchWalker<Lighting, Base::kScalars>(prepared.patch, prepared.middle_left,
                                                                   prepared.highlight_weight));
      }
    }
    if (prepared.segment_bits == 0) return Base::walk(prepared, draw);
    return Base::walk(prepared, [&](auto walker) {
      return draw(SegmentWalker<decltype(walker)>(walker, prepared.segment_bits));
    });
  }

 private:
  static constexpr bool kHasHighlightPatch = Base::kHasDiffusePath;
  /// The squared chord of 16 degrees, 28 fraction bits, up to which the errors of linear light and of
  /// highlight patches are bounded.
  static constexpr std::uint32_t kWidestBounded = 20797469u;

  /// Returns a lower bound of the highlight's half distance over the triangle: (1 - c) / 2 of its cosine c.
  template <class Frame>
  [[nodiscard]] static constexpr std::int32_t nearest_highlight(const Lighting& lighting,
                                                                const Frame& frame) {
    return lighting.nearest_highlight(frame.top->shade.scalars, frame.middle->shade.scalars,
                                      frame.bottom->shade.scalars, arc_headroom(frame.chords.widest()));
  }
  /// Returns true if a highlight above half the tolerance is within reach of the triangle.
  template <class Frame>
  [[nodiscard]] static constexpr bool shines(const Lighting& lighting, const Frame& frame) {
    return nearest_highlight(lighting, frame) < lighting.half_tolerance_reach();
  }

  /// Prepares N·L alone: linear if the error is within `linear_limit`, otherwise by Arc's paths.
  template <class Frame>
  static constexpr void prepare_without_highlight(const Lighting& lighting, Frame& frame,
                                                  std::uint32_t linear_limit, Prepared& prepared) {
    const PatchValues light = Base::diffuse_scalars(lighting, frame);
    const LinearLevels levels(frame.chords, light.top, light.middle, light.bottom);
    // A gradient saturates at 2 per pixel, which a sliver may exceed.
    if (levels.range() < frame.width && levels.quadruple_error() <= linear_limit) {
      prepared.linear_light = true;
      make_linear_plane(frame, levels.lifted(levels.a), levels.lifted(levels.b), levels.lifted(levels.c),
                        prepared.light);
      return;
    }
    const std::uint32_t widest = frame.chords.widest();
    Base::prepare_path(lighting, frame, Base::diffuse_path(patch_fits(frame), widest), prepared);
  }

  /// Returns the light whose highlight is above half the tolerance and within reach of the triangle, or
  /// kLights if there are several.
  template <class Frame>
  [[nodiscard]] static constexpr std::size_t shining_light(const Lighting& lighting, const Frame& frame) {
    if constexpr (Illumination::kLights == 1) return 0;
    std::size_t found = Illumination::kLights;
    for (std::size_t i = 0; i < Illumination::kLights; ++i) {
      const std::int32_t nearest =
          lighting.nearest_highlight_of(i, frame.top->shade.scalars, frame.middle->shade.scalars,
                                        frame.bottom->shade.scalars, arc_headroom(frame.chords.widest()));
      if (nearest >= lighting.half_tolerance_reach()) continue;
      if (found != Illumination::kLights) return Illumination::kLights;
      found = i;
    }
    return found;
  }

  /// Prepares the diffuse scalar and the scaled distance of a highlight as patches. Returns false if there
  /// are several highlights, if a vertex is not lit or its highlight fades, or if HighlightTable cannot scale
  /// the largest distance.
  template <class Frame>
  [[nodiscard]] static constexpr bool prepare_highlight_patch(const Lighting& lighting, const Frame& frame,
                                                              Prepared& prepared) {
    const TriangleChords& chords = frame.chords;
    const std::size_t light = shining_light(lighting, frame);
    if (Illumination::kLights > 1 &&
        (light == Illumination::kLights || !Base::has_diffuse_scalar(lighting, frame))) {
      return false;
    }
    prepared.highlight_weight = lighting.highlight_weight(light);
    // Above 0 or the end of the fade by 2^-10, which is more than any rounding error.
    const std::int32_t lit_from = lighting.fade_end().raw() + (std::int32_t{1} << 20);
    const std::size_t other = Illumination::highlight_index(light);
    const auto& top = frame.top->shade.scalars;
    const auto& middle = frame.middle->shade.scalars;
    const auto& bottom = frame.bottom->shade.scalars;
    if (top[light].raw() < lit_from || middle[light].raw() < lit_from || bottom[light].raw() < lit_from)
      return false;
    std::int32_t farthest = 0;  // the largest half distance so far
    const auto distance = [&](Cosine at_light, Cosine at_other) {
      const std::int32_t half = lighting.half_distance(at_light, at_other, light);
      if (half > farthest) farthest = half;
      return half;
    };
    const auto half_way = [&](const auto& a, const auto& b, SagittaFactor factor) {
      const auto middle_of = [&](std::size_t i) {
        return detail::patch_middle(a[i], b[i], detail::quadruple_sagitta(a[i], b[i], factor));
      };
      return distance(middle_of(light), middle_of(other));
    };
    const EdgeSagittaFactors factors{sagitta_factor(chords.top_middle), sagitta_factor(chords.top_bottom),
                                     sagitta_factor(chords.middle_bottom)};
    const std::int32_t top_middle = half_way(top, middle, factors.top_middle);
    const std::int32_t top_bottom = half_way(top, bottom, factors.top_bottom);
    const std::int32_t middle_bottom = half_way(middle, bottom, factors.middle_bottom);
    const std::int32_t at_top = distance(top[light], top[other]);
    const std::int32_t at_middle = distance(middle[light], middle[other]);
    const std::int32_t at_bottom = distance(bottom[light], bottom[other]);
    const HighlightTable& table = lighting.highlight_table();
    if (!table.fits(farthest)) return false;
    make_patch_scalar(frame, factors, Base::diffuse_scalars(lighting, frame), prepared.patch[0]);
    const auto scaled = [&table](std::int32_t half) { return Cosine::from_raw(table.scaled(half)); };
    const PatchValues at{scaled(at_top), scaled(at_middle), scaled(at_bottom)};
    const EdgeQuadrupleSagittas sagittas{
        detail::quadruple_sagitta_through(at.top, at.middle, scaled(top_middle)),
        detail::quadruple_sagitta_through(at.top, at.bottom, scaled(top_bottom)),
        detail::quadruple_sagitta_through(at.middle, at.bottom, scaled(middle_bottom))};
    make_patch_surface(frame, at, sagittas, prepared.patch[1]);
    return true;
  }

  /// N·L at the vertices of a triangle, and what follows for linear light.
  struct LinearLevels {
    std::int32_t a;  ///< LinearLight::level()
    std::int32_t b;
    std::int32_t c;
    std::uint32_t radius2;  ///< squared_radius() of the normals
    bool bounded;           ///< the normals are so close that `radius2` holds

    constexpr LinearLevels(const TriangleChords& chords, Cosine at_a, Cosine at_b, Cosine at_c)
        : a(LinearLight::level(at_a)),
          b(LinearLight::level(at_b)),
          c(LinearLight::level(at_c)),
          radius2(squared_radius(chords)),
          bounded(chords.widest() <= kWidestBounded) {}

    [[nodiscard]] constexpr std::int32_t most() const {
      const std::int32_t upper = a > b ? a : b;
      return upper > c ? upper : c;
    }
    [[nodiscard]] constexpr std::uint32_t range() const {
      const std::int32_t lower = a < b ? a : b;
      return static_cast<std::uint32_t>(most() - (lower < c ? lower : c));
    }
    /// Returns a bound of four times the error of linear light, 28 fraction bits: R^2 N·L with the largest
    /// N·L. Where N·L is positive, it is above the plane through its vertices by at most R^2/2 of itself and
    /// never below; lifting the plane by R^2/4 leaves R^2/4 either way.
    [[nodiscard]] constexpr std::uint32_t quadruple_error() const {
      if (!bounded) return UINT32_MAX;
      if (most() <= 0) return 0;
      return (radius2 >> 9) * ((static_cast<std::uint32_t>(most()) >> 6) + 1);
    }
    /// Returns a level of the lifted plane.
    [[nodiscard]] constexpr std::int32_t lifted(std::int32_t level) const {
      const auto lift = static_cast<std::int32_t>(radius2 >> (28 - LinearLight::kFraction + 2));
      return level + (wrap_mul(level, lift) >> LinearLight::kFraction);
    }
  };

  /// Returns an upper bound of the squared radius of the smallest circle around the three normals, which are
  /// at most 16 degrees apart; 28 fraction bits, of which 25 are used. The circle passes through all three,
  /// or has the widest edge as its diameter if the triangle of the normals is obtuse.
  ///
  /// With c the longest chord and e = max(0, a^2 + b^2 - c^2), the squared radius is at most c^2/4 + e/12.
  [[nodiscard]] static constexpr std::uint32_t squared_radius(const TriangleChords& chords) {
    const std::uint32_t widest = chords.widest();
    const std::uint32_t others = chords.top_middle + chords.top_bottom + chords.middle_bottom - widest;
    const std::uint32_t excess = others > widest ? others - widest : 0;
    // The last term, about 4%, covers the higher terms at 16 degrees.
    return (widest >> 2) + (excess >> 3) - (excess >> 5) + (widest >> 6);
  }

  /// Returns true if every N·L keeps its sign over the triangle and stays out of the fade of the highlights,
  /// by a margin whose square is `margin2` (28 fraction bits). At a change of sign, colours have a kink and
  /// highlights end abruptly or fade. The margin is needed because a segment may end up to a quarter of a row
  /// beyond the edge.
  template <class Frame>
  [[nodiscard]] static constexpr bool away_from_terminator(const Lighting& lighting, const Frame& frame,
                                                           std::uint32_t margin2) {
    const std::int32_t fade_end = lighting.fade_end().raw();
    const auto square = [fade_end](std::int32_t v) {
      const std::int32_t away = v <= 0 ? v : v > fade_end ? v - fade_end : 0;
      return static_cast<std::uint32_t>(wrap_mul(away >> 16, away >> 16));
    };
    for (std::size_t i = 0; i < Illumination::kLights; ++i) {
      const std::int32_t a = frame.top->shade.scalars[i].raw();
      const std::int32_t b = frame.middle->shade.scalars[i].raw();
      const std::int32_t c = frame.bottom->shade.scalars[i].raw();
      if (((a ^ b) | (b ^ c)) < 0) return false;
      if (square(a) <= margin2 || square(b) <= margin2 || square(c) <= margin2) return false;
    }
    return true;
  }

  /// Returns the bits of the longest segments that the tolerance allows and of which the triangle's widest
  /// row holds at least four; 0 if there are none.
  template <class Frame>
  [[nodiscard]] static constexpr int segment_bits(const Lighting& lighting, const Frame& frame) {
    const TriangleChords& chords = frame.chords;
    // With a ramp, a pixel without highlight is one look-up, so only segments of 8 or 16 pixels are faster.
    constexpr int kLeastBits = Illumination::kHasRamp ? 3 : 2;
    constexpr std::uint32_t kLeastWidth = 4u << kLeastBits;
    const std::uint32_t whole = frame.width >> 16;
    if (whole < kLeastWidth) return 0;
    // The angle of the widest row is at most that of the wider edge at the middle vertex. The pixels of a row
    // are not quite evenly spaced in angle; reducing the limit by a quarter covers that.
    const std::uint32_t limit = lighting.segment_limit(shines(lighting, frame));
    const std::uint32_t width = whole > 1023 ? 1023 : whole;
    const std::uint32_t across =
        chords.top_middle > chords.middle_bottom ? chords.top_middle : chords.middle_bottom;
    if (chords.widest() > kWidestArc) return 0;  // a chord says too little of its angle there
    if (!away_from_terminator(lighting, frame, across >> 4)) return 0;
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
