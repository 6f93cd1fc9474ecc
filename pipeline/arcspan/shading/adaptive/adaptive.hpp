// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/shading/adaptive/adaptive_illumination.hpp>
#include <arcspan/shading/adaptive/adaptive_rows.hpp>
#include <arcspan/shading/adaptive/highlight_distances.hpp>
#include <arcspan/shading/adaptive/highlight_patch.hpp>
#include <arcspan/shading/adaptive/highlight_product.hpp>
#include <arcspan/shading/adaptive/highlight_quartic.hpp>
#include <arcspan/shading/adaptive/highlight_sum.hpp>
#include <arcspan/shading/adaptive/linear_levels.hpp>
#include <arcspan/shading/adaptive/linear_light.hpp>
#include <arcspan/shading/adaptive/nearest_highlight.hpp>
#include <arcspan/shading/adaptive/segment_length.hpp>
#include <arcspan/shading/arc/arc.hpp>
#include <arcspan/shading/segment/segment.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// How AdaptivePaths draws the highlights that are within reach of a triangle.
enum class HighlightPath : std::uint8_t {
  kNone,      ///< not at all, or as Arc does
  kDistance,  ///< the highlight's scaled distance: path 4
  kProduct,   ///< HighlightProduct: path 5, one light
  kQuartic,   ///< QuarticHighlight: path 5, several lights
  kSum,       ///< HighlightSumRun: path 6
};

/// Arc with the cheapest path per triangle whose predicted error is within a tolerance (decisions 6, 7 and
/// 28). The paths are tried in this order. All but 3 and 7 need a ramp. With several lights, paths 1, 4 and 5
/// also need every light to reach either the whole triangle or nothing of it. The diffuse scalar is N·L, or
/// the weighted mean of several (Illumination::diffuse_scalar()).
///
/// 1. Light that is linear on the screen: no highlight above half the tolerance is within reach, and the
///    circle through the normals is so small that the diffuse scalar differs from a plane by at most the rest
///    of the tolerance.
/// 2. Darkness, a patch of the diffuse scalar, or a patch of N·L of every light where one of them reaches a
///    part of the triangle: no highlight above half the tolerance is within reach.
/// 3. Segments of 4...16 pixels (S3), without a ramp: wide rows whose colours have small second derivatives,
///    away from the terminator. With a ramp other paths are cheaper (decision 6).
/// 4. A patch of the diffuse scalar and of a highlight's distance: within reach of the highlight of one
///    light, which lights all vertices beyond the fade; under R·V only where normals are close. The diffuse
///    scalar is linear if its error and that of the distance together are within the tolerance.
/// 5. A patch of the factors of a highlight R·V (HighlightFactors), and of the diffuse scalar if there are
///    several lights: as path 4, where normals are farther apart or HighlightTable cannot scale a distance,
///    for n up to 64 and a tolerance above 0. With several lights at least 12 pixels wide.
/// 6. A patch of N·L of every light and N·V: other triangles by several lights within reach of highlights
///    R·V, unless highlights fade; n and tolerance as for path 5.
/// 7. The paths of Arc: a patch of every scalar or of one highlight, or arcs.
///
/// `Segments` false leaves out path 3.
template <class Illumination, bool Segments>
struct AdaptivePaths : Arc<Illumination> {
  static_assert(!Segments || !Illumination::kHasRamp);
  using Base = Arc<Illumination>;
  using Lighting = AdaptiveIllumination<Illumination>;
  using typename Base::Face;
  using typename Base::Path;
  using typename Base::Vertex;
  static constexpr bool kHasHighlightPatch = Base::kHasDiffusePath;
  static constexpr bool kHasHighlightProduct = kHasHighlightPatch && kMayMultiply<Illumination>;
  static constexpr bool kHasSeveralHighlights =
      kHasHighlightPatch && kMayReflect<Illumination> && Illumination::kLights > 1;
  struct NoQuartic {};  ///< in its place by one light
  struct Prepared : Base::Prepared {
    FullLinearPlane light;
    int segment_bits;                ///< path 3: segments have 2^segment_bits pixels; 0 for none
    bool linear_light;               ///< path 1: N·L alone, in `light`
    HighlightPath highlight_path;    ///< paths 4 to 6; otherwise kNone
    bool linear_diffuse;             ///< path 4: the diffuse scalar is in `light`
    HighlightPixels pixels;          ///< path 4, linear_diffuse: the loop that suffices
    std::uint32_t highlight_weight;  ///< paths 4 and 5: of the light, if there are several
    std::int32_t product_origin;     ///< path 5, and rows of arcs, by one light: product_origin()
    /// Path 5, several lights.
    [[no_unique_address]] std::conditional_t<kHasSeveralHighlights, QuarticConstants, NoQuartic> quartic;
    ProductOrigins<kHasSeveralHighlights ? Illumination::kLights : 0> origins;  ///< path 6
  };

  template <class Frame>
  static constexpr void prepare(const Lighting& lighting, const Frame& unmeasured, const Face&,
                                Prepared& prepared) {
    MeasuredFrame<Frame> frame(unmeasured);
    prepared.middle_left = frame.middle_left;
    prepared.linear_light = false;
    prepared.highlight_path = HighlightPath::kNone;
    prepared.product_origin = 0;
    prepared.segment_bits = 0;
    Path path = Path::kWide;
    if (prepare_own_path(lighting, frame, path, prepared)) return;
    if constexpr (kAdaptsWideRows && kMayMultiply<Illumination>) {
      if (path == Path::kWide) prepared.product_origin = product_origin(lighting, 0);
    }
    if constexpr (Segments) {
      if (prepared.segment_bits != 0) {
        Base::prepare_path(lighting, frame, path, prepared);
        return;
      }
    }
    if constexpr (kHasWideRegisters) {  // inlined, it would cost x86-64 3 % of a frame
      prepare_chosen_outlined(lighting, frame, path, prepared);
    } else {
      Base::prepare_chosen(lighting, frame, path, prepared);
    }
  }

  /// A small triangle (DrawsSmallTriangles): linear light, or as Arc draws it without highlights below half
  /// the tolerance.
  using Small = SmallShading<Illumination, SmallLinearLight<Lighting>>;
  template <class Raster>
  [[nodiscard]] static constexpr bool prepare_small(const Lighting& lighting, const Raster& a,
                                                    const Raster& b, const Raster& c,
                                                    const SmallTriangle& triangle, Small& small) {
    if (small.prepare_dark(a.shade.scalars, b.shade.scalars, c.shade.scalars)) return true;
    const TriangleChords chords = chords_between(a.shade.normal, b.shade.normal, c.shade.normal);
    const SmallCorners corners{a, b, c};
    bool shines = true;
    typename Small::Diffuse diffuse{};
    if constexpr (Base::kHasDiffusePath) {
      const std::int32_t nearest = Small::sharper_nearest(
          lighting,
          lighting.nearest_highlight(a.shade.scalars, b.shade.scalars, c.shade.scalars,
                                     arc_headroom(chords.widest())),
          lighting.half_tolerance_reach(), lighting.eighth_tolerance_reach(), corners, chords);
      shines = nearest < lighting.half_tolerance_reach();
      const auto is_allowed = [&](std::uint32_t error) {
        return error <= lighting.diffuse_patch_error(nearest);
      };
      diffuse = Small::diffuse_of(lighting, corners, chords.widest(), shines, is_allowed);
      if (diffuse.suffices && chords.widest() <= kWidestBounded) {
        const LinearLevels levels(chords, diffuse.a, diffuse.b, diffuse.c);
        if (levels.quadruple_error() <= lighting.linear_limit(nearest)) {
          small.take_own().prepare(levels.lifted(levels.a), levels.lifted(levels.b), levels.lifted(levels.c),
                                   triangle);
          return true;
        }
      }
    }
    return small.prepare(lighting, corners, chords, shines, diffuse, triangle);
  }
  /// Calls `draw` with the surface of a small triangle.
  template <class Draw>
  [[nodiscard]] static constexpr Status walk_small(const Small& small, Draw&& draw) {
    return small.walk(draw);
  }

  template <class Draw>
  [[nodiscard]] ARCSPAN_INLINE static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if constexpr (Base::kHasDiffusePath) {
      if (prepared.linear_light) {
        return draw(LinearLightWalker<Lighting>(prepared.light, prepared.middle_left));
      }
    }
    if constexpr (kHasHighlightPatch) {
      if (prepared.highlight_path == HighlightPath::kDistance) {
        if (prepared.linear_diffuse) {
          if constexpr (kHasWhiteLoops) {
            if (prepared.pixels == HighlightPixels::kWhiteFitting)
              return draw(linear_highlight_walker<HighlightPixels::kWhiteFitting>(prepared));
            if constexpr (!kHasWideRegisters) {  // where that of any colour is as fast
              if (prepared.pixels == HighlightPixels::kOnlyWhite)
                return draw(linear_highlight_walker<HighlightPixels::kOnlyWhite>(prepared));
            }
          }
          return draw(linear_highlight_walker<HighlightPixels::kAny>(prepared));
        }
        return draw(HighlightPatchWalker<Lighting, Base::kScalars>(prepared.patch, prepared.middle_left,
                                                                   weight_of(prepared)));
      }
    }
    if constexpr (kHasHighlightProduct) {
      if (prepared.highlight_path == HighlightPath::kProduct) {
        return draw(HighlightProductWalker<Lighting, Base::kScalars>(
            prepared.patch, prepared.middle_left, prepared.product_origin, weight_of(prepared)));
      }
    }
    if constexpr (kHasSeveralHighlights) {
      if (prepared.highlight_path == HighlightPath::kQuartic) {
        return draw(HighlightQuarticWalker<Lighting, Base::kScalars>(prepared.patch, prepared.middle_left,
                                                                     prepared.quartic, weight_of(prepared)));
      }
      if (prepared.highlight_path == HighlightPath::kSum) {
        return draw(HighlightSumWalker<Lighting, Base::kScalars>(prepared.patch, prepared.middle_left,
                                                                 prepared.origins));
      }
    }
    if constexpr (Segments) {
      if (prepared.segment_bits != 0) {
        return Base::template walk<WalkedPaths::kPrepared>(prepared, [&](auto walker) {
          return draw(SegmentWalker<decltype(walker)>(walker, prepared.segment_bits));
        });
      }
    }
    if constexpr (kAdaptsWideRows) {
      if (prepared.path == Path::kWide) {
        return draw(AdaptiveWideWalker<Lighting, PatchRun<Illumination, Base::kScalars>, Base::kScalars>(
            prepared.wide, prepared.product_origin));
      }
      return Base::template walk<WalkedPaths::kExceptWide>(prepared, draw);
    } else {
      return Base::walk(prepared, draw);
    }
  }

 private:
  [[nodiscard]] static constexpr std::uint32_t weight_of(const Prepared& prepared) {
    if constexpr (Illumination::kLights == 1) return std::uint32_t{1} << 15;
    return prepared.highlight_weight;
  }
  template <HighlightPixels kPixels>
  [[nodiscard]] ARCSPAN_INLINE static constexpr LinearHighlightWalker<Lighting, kPixels>
  linear_highlight_walker(Prepared& prepared) {
    return {prepared.light, prepared.patch[1], prepared.middle_left, weight_of(prepared)};
  }
  /// True if white highlights have loops of their own. They are only faster; the colours are the same.
  static constexpr bool kHasWhiteLoops = !kOptimisedForSize && Illumination::kLights == 1;
  static constexpr bool kAdaptsWideRows = Base::kHasDiffusePath;
  /// The squared chord of 16 degrees, 28 fraction bits, up to which the error of linear light is bounded.
  static constexpr std::uint32_t kWidestBounded = 20797469u;

  template <class Frame>
  ARCSPAN_OUTLINE static constexpr void prepare_chosen_outlined(const Lighting& lighting, Frame& frame,
                                                                Path path, Prepared& prepared) {
    Base::prepare_chosen(lighting, frame, path, prepared);
  }

  /// Prepares path 1, 4, 5 or 6 and returns true. Otherwise sets `path` to the path of Arc, and segment_bits
  /// if it is to be drawn in segments, and returns false.
  template <class Frame>
  [[nodiscard]] ARCSPAN_INLINE static constexpr bool prepare_own_path(const Lighting& lighting, Frame& frame,
                                                                      Path& path, Prepared& prepared) {
    const std::uint32_t widest = frame.chords.widest();
    const bool is_arc = widest <= kWidestArc;  // wider chords say too little of their angles
    NearestHighlight nearest{};
    if constexpr (Base::kHasDiffusePath) {
      if (is_arc) {
        nearest = nearest_highlight(lighting, frame);
        if (nearest.distance >= lighting.half_tolerance_reach()) {
          if (Base::kDrawsDark && Base::is_dark(frame)) {
            path = Path::kDark;
            return false;
          }
          std::uint32_t lit = 0;
          if (lit_throughout(lighting, frame, lit) &&
              prepare_linear_light(lighting, frame, lighting.linear_limit(nearest.distance), lit, prepared))
            return true;
          path = Base::diffuse_path(lighting, frame, patch_fits(frame), widest);
          return false;
        }
      }
    }
    bool fits_patch = is_accurate_patch(frame, widest, lighting.widest_patch()) && patch_fits(frame);
    if (is_arc && !fits_patch) [[unlikely]] {
      const WidePatch wide = wide_patch_of(lighting, frame, widest, nearest.distance);
      if constexpr (Base::kHasDiffusePath) {
        if (wide.nearest >= lighting.half_tolerance_reach()) {
          path = Base::diffuse_path(lighting, frame, patch_fits(frame), widest);
          return false;
        }
      }
      nearest.distance = wide.nearest;
      fits_patch = wide.fits;
    }
    path = fits_patch ? Path::kPatch : is_arc ? Path::kWide : Base::wide_path(frame);
    if constexpr (Segments) {
      if (is_arc && frame.width >> 16 >= kLeastWidthOfSegments) {
        nearest = nearest_highlight(lighting, frame);
        prepared.segment_bits =
            longest_segment_bits(lighting, frame, nearest.distance < lighting.half_tolerance_reach());
      }
    }
    if constexpr (kHasHighlightPatch) {
      if (fits_patch && widest < lighting.highlight_patch_limit()) {
        const bool is_patch = prepare_highlight_patch(lighting, frame, nearest.light, prepared);
        if constexpr (kHasWhiteLoops) {
          if (is_patch && prepared.linear_diffuse)
            prepared.pixels = highlight_pixels_of(lighting, frame, nearest.distance);
        }
        if (is_patch) return true;
      }
    }
    if constexpr (kHasHighlightPatch && kMayReflect<Illumination>)
      return fits_patch && prepare_factors(lighting, frame, nearest.light, prepared);
    return false;
  }

  /// Makes the plane of a diffuse scalar, of a triangle of at most kWidestBounded, if its error is within
  /// `linear_limit`; otherwise returns false.
  template <class Frame>
  [[nodiscard]] static constexpr bool make_linear_light(const Frame& frame, const PatchValues& light,
                                                        std::uint32_t linear_limit, Prepared& prepared) {
    const LinearLevels levels(frame.chords, light.top, light.middle, light.bottom);
    // A gradient saturates at 2 per pixel, which a sliver may exceed.
    if (levels.range() >= frame.width || levels.quadruple_error() > linear_limit) return false;
    make_linear_plane(frame, levels.lifted(levels.a), levels.lifted(levels.b), levels.lifted(levels.c),
                      prepared.light);
    return true;
  }

  /// Prepares N·L alone as linear light; returns false if the error is beyond `linear_limit`. `lit` is that
  /// of lit_throughout().
  template <class Frame>
  [[nodiscard]] static constexpr bool prepare_linear_light(const Lighting& lighting, Frame& frame,
                                                           std::uint32_t linear_limit, std::uint32_t lit,
                                                           Prepared& prepared) {
    if (frame.chords.widest() > kWidestBounded) return false;
    const PatchValues light = diffuse_scalars(lighting, frame, lit);
    prepared.linear_light = make_linear_light(frame, light, linear_limit, prepared);
    return prepared.linear_light;
  }

  /// Prepares the diffuse scalar and the scaled distance of the highlight of one light as patches. Returns
  /// false if there are several highlights (`nearest_light` is kLights), if a vertex is not lit or its
  /// highlight fades, or if HighlightTable cannot scale the largest distance.
  template <class Frame>
  [[nodiscard]] ARCSPAN_OUTLINE static constexpr bool prepare_highlight_patch(const Lighting& lighting,
                                                                              const Frame& frame,
                                                                              std::size_t nearest_light,
                                                                              Prepared& prepared) {
    const std::size_t light = Illumination::kLights == 1 ? 0 : nearest_light;
    std::uint32_t lit = 0;
    if (light == Illumination::kLights || !lit_throughout(lighting, frame, lit)) return false;
    if constexpr (Illumination::kLights > 1) prepared.highlight_weight = lighting.highlight_weight(light);
    if (!is_fully_lit(lighting, frame, light)) return false;
    EdgeSagittaFactors factors{};
    if (!has_linear_distance(lighting)) factors = sagitta_factors_of(frame.chords);
    const HalfDistances half = half_distances_of(lighting, frame, light, factors);
    if (!lighting.highlight_table().fits(half.farthest)) return false;
    const PatchValues diffuse = diffuse_scalars(lighting, frame, lit);
    const std::uint32_t widest = frame.chords.widest();
    prepared.linear_diffuse =
        widest <= kWidestBounded &&
        make_linear_light(frame, diffuse, lighting.linear_limit_with_highlight(widest), prepared);
    if (has_linear_distance(lighting)) factors = sagitta_factors_of(frame.chords);
    if (!prepared.linear_diffuse) {
      // A copy whose address is passed on, so that `factors` can stay in registers.
      const EdgeSagittaFactors in_memory = factors;
      make_patch_scalar(frame, in_memory, diffuse, prepared.patch[0]);
    }
    make_distance_surface(lighting, frame, light, factors, half, prepared.patch[1]);
    prepared.highlight_path = HighlightPath::kDistance;
    return true;
  }

  /// Prepares path 5 or 6 and returns true; `nearest_light` is NearestHighlight::light. Returns false unless
  /// multiplies_highlights(); with one light if a vertex is not fully lit; with several if highlights fade
  /// and the triangle is not for path 5.
  template <class Frame>
  [[nodiscard]] ARCSPAN_OUTLINE static constexpr bool prepare_factors(const Lighting& lighting,
                                                                      const Frame& frame,
                                                                      std::size_t nearest_light,
                                                                      Prepared& prepared) {
    if (!lighting.multiplies_highlights()) return false;
    const std::size_t light = Illumination::kLights == 1 ? 0 : nearest_light;
    std::uint32_t lit = 0;
    const bool is_one = light != Illumination::kLights && lit_throughout(lighting, frame, lit) &&
                        is_fully_lit(lighting, frame, light);
    if constexpr (kHasHighlightProduct) {
      if (lighting.lights() == 1) {
        if (!is_one) return false;
        if constexpr (Illumination::kLights > 1) prepared.highlight_weight = lighting.highlight_weight(0);
        prepare_product(lighting, frame, prepared.patch, prepared.product_origin);
        prepared.highlight_path = HighlightPath::kProduct;
        return true;
      }
    }
    if constexpr (kHasSeveralHighlights) {
      if (is_one && frame.width >= QuarticConstants::kLeastWidth) {
        prepared.highlight_weight = lighting.highlight_weight(light);
        prepare_quartic(lighting, frame, light, lit, prepared.patch, prepared.quartic);
        prepared.highlight_path = HighlightPath::kQuartic;
        return true;
      }
      if (lighting.fade_end().raw() != 0) return false;
      prepare_sum(lighting, frame, prepared.patch, prepared.origins);
      prepared.highlight_path = HighlightPath::kSum;
      return true;
    }
    return false;
  }

  /// Returns true if all vertices of a TriangleFrame are fully lit by a light.
  template <class Frame>
  [[nodiscard]] static constexpr bool is_fully_lit(const Lighting& lighting, const Frame& frame,
                                                   std::size_t light) {
    return lighting.is_fully_lit(frame.top->shade.scalars[light]) &&
           lighting.is_fully_lit(frame.middle->shade.scalars[light]) &&
           lighting.is_fully_lit(frame.bottom->shade.scalars[light]);
  }
};

/// Phong shading by the cheapest path whose error is invisible: see AdaptivePaths.
template <class Illumination>
struct Adaptive : AdaptivePaths<Illumination, !Illumination::kHasRamp> {
  using DrawsSmallTrianglesAs = Adaptive;
};

}  // namespace arcspan
