// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/shading/arc/arc_paths.hpp>
#include <arcspan/shading/arc/dark_walker.hpp>
#include <arcspan/shading/arc/small_shading.hpp>
#include <arcspan/shading/arc/wide_walker.hpp>
#include <arcspan/shading/patch/diffuse_scalars.hpp>
#include <arcspan/shading/patch/one_highlight.hpp>
#include <arcspan/shading/patch/patch_limits.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/shading/patch/stepped_distance.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <type_traits>

namespace arcspan {

/// The paths that ArcUpTo::walk() compiles. A union holds what they need; one that is left out must not be
/// the command's.
enum class WalkedPaths : std::uint8_t {
  kAll,
  kExceptWide,  ///< all but kWide
  kPrepared     ///< those of prepare_path()
};

/// Spherical-angular Phong shading on scalars: the products of the normal with L, H or V follow great circles
/// down the edges and along the rows (S0). Small angles need no exact circle, so a triangle that is lit is
/// drawn in one of two ways (Path):
///
/// - Normals within 5.2 to 33 degrees, depending on the highlight, its strength in the triangle and the shape
///   (choose_path()): a quadratic surface through the arcs' ends and middles, which second differences step
///   without a multiply (decision 5).
/// - Wider, narrower than half a pixel, or larger than kLargestPatch: great circles down the edges (ArcEdge),
///   and each row in pieces of at most 1.3 times the angle of the widest patch (widest_piece()), which are
///   parabolas through the arc's ends and middle (decision 23).
///
/// literature/recurrence_method.hpp has the recurrence of S0 eq. 14 for edges and pixels.
template <class Illumination, WidestNormals kWidest>
struct ArcUpTo : ArcPaths<Illumination, kWidest> {
  using Choice = ArcPaths<Illumination, kWidest>;
  using typename Choice::Path;
  static constexpr std::size_t kScalars = Illumination::kScalars;
  using Scalars = std::array<Cosine, kScalars>;
  using Lighting = Illumination;
  struct Face {};
  using Vertex = ArcVertex<kScalars>;
  static constexpr bool kHasOneHighlight = requires { requires Illumination::kDrawsOneHighlight; };
  struct Prepared {
    union {
      WideOrVeryWide<kScalars, kWidest> wide;
      Patch<kScalars> patch;
    };
    Path path;
    bool middle_left;
    [[no_unique_address]] std::conditional_t<kHasOneHighlight, OneHighlight, NoOneHighlight> highlight;
  };
  using Small = SmallShading<Lighting>;
  static constexpr bool kNeedsFaceNormal = false;
  using DrawsSmallTrianglesAs = ArcUpTo;

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return {to_normal(normal), lighting.scalars(normal)};
  }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  /// Returns the vertex at the fraction t, 0...1, of the arc from a to b.
  [[nodiscard]] static constexpr Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    return on_arc(a, b, t);
  }

  /// Chooses the path of a triangle and prepares it. `Frame` is a TriangleFrame whose vertices have this
  /// method's `Vertex` as their shade.
  template <class Frame>
  static constexpr void prepare(const Lighting& lighting, const Frame& unmeasured, const Face&,
                                Prepared& prepared) {
    MeasuredFrame<Frame> frame(unmeasured);
    prepare_chosen(lighting, frame, choose_path(lighting, frame, frame.chords.widest()), prepared);
  }

  /// Calls `draw` with the walker of the command's path. Methods on top of this one that draw some paths in
  /// their own way leave them out of `kPaths`.
  template <WalkedPaths kPaths = WalkedPaths::kAll, class Draw>
  [[nodiscard]] ARCSPAN_INLINE static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    constexpr bool kAll = kPaths != WalkedPaths::kPrepared;
    using AllScalars = PatchRun<Lighting, kScalars>;
    if constexpr (kAll && kHasOneHighlight) {
      if (prepared.path == Path::kOneHighlight) {
        return draw(
            OneHighlightWalker<Lighting, kScalars>(prepared.patch, prepared.middle_left, prepared.highlight));
      }
    }
    constexpr bool kAlwaysSteps = kAll && kAlwaysStepsBlinnDistance<Lighting>;
    if constexpr (kAll && kMayStepBlinnDistance<Lighting> && !kAlwaysSteps) {
      if (prepared.path == Path::kSteppedDistance)
        return draw(
            PatchWalker<SteppedDistanceRun<Lighting>, kScalars>(prepared.patch, prepared.middle_left));
    }
    if constexpr (kPaths != WalkedPaths::kExceptWide) {
      if (prepared.path == Path::kWide) return draw(WideWalker<AllScalars, kScalars, kWidest>(prepared.wide));
    }
    if constexpr (kDrawsDark && kHasRoomForLoops) {
      if (prepared.path == Path::kDark) return draw(DarkWalker<Lighting>{});
    }
    if constexpr (kHasDiffusePath) {
      if constexpr (kHasDiffuseWide) {
        if (prepared.path == Path::kDiffuseWide)
          return draw(WideWalker<PatchRun<Lighting, 1>, kScalars, kWidest>(prepared.wide));
      }
      if (prepared.path == Path::kDiffusePatch) {
        return draw(PatchWalker<PatchRun<Lighting, 1>, kScalars>(prepared.patch, prepared.middle_left));
      }
    }
    if constexpr (kSumsLights) {
      if (prepared.path == Path::kDiffuseSumPatch)
        return draw(PatchWalker<PatchRun<Lighting, Illumination::kLights>, kScalars>(prepared.patch,
                                                                                     prepared.middle_left));
    }
    using Pixels = std::conditional_t<kAlwaysSteps, SteppedDistanceRun<Lighting>, AllScalars>;
    return draw(PatchWalker<Pixels, kScalars>(prepared.patch, prepared.middle_left));
  }

  /// Prepares a small triangle (DrawsSmallTriangles).
  template <class Raster>
  [[nodiscard]] static constexpr bool prepare_small(const Lighting& lighting, const Raster& a,
                                                    const Raster& b, const Raster& c,
                                                    const SmallTriangle& triangle, Small& small) {
    if (small.prepare_dark(a.shade.scalars, b.shade.scalars, c.shade.scalars)) return true;
    const TriangleChords chords = chords_between(a.shade.normal, b.shade.normal, c.shade.normal);
    const SmallCorners corners{a, b, c};
    bool shines = true;
    if constexpr (kHasDiffusePath) {
      const std::int32_t reach = lighting.power().half_reach();
      const std::int32_t nearest = lighting.nearest_highlight(a.shade.scalars, b.shade.scalars,
                                                              c.shade.scalars, arc_headroom(chords.widest()));
      shines = Small::sharper_nearest(lighting, nearest, reach, reach, corners, chords) < reach;
    }
    const auto diffuse =
        Small::diffuse_of(lighting, corners, chords.widest(), shines, Small::within_patch_error(lighting));
    return small.prepare(lighting, corners, chords, shines, diffuse, triangle);
  }
  template <class Draw>
  [[nodiscard]] static constexpr Status walk_small(const Small& small, Draw&& draw) {
    return small.walk(draw);
  }

 protected:
  using Choice::choose_path;
  using Choice::kDrawsDark;
  using Choice::kFindsFaintHighlights;
  using Choice::kHasDiffusePath;
  using Choice::kHasDiffuseWide;
  using Choice::kSumsLights;

  /// Prepares the triangle for `path`, or instead of kPatch for a cheaper path of the same colours that the
  /// illumination allows.
  template <class Frame>
  static constexpr void prepare_chosen(const Lighting& lighting, Frame& frame, Path path,
                                       Prepared& prepared) {
    if constexpr (kHasOneHighlight) {
      if (path == Path::kPatch &&
          prepare_one_highlight(lighting, frame, prepared.patch, prepared.highlight)) {
        prepared.middle_left = frame.middle_left;
        prepared.path = Path::kOneHighlight;
        return;
      }
    }
    if constexpr (kMayStepBlinnDistance<Lighting>) {
      if (path == Path::kPatch && steps_blinn_distance(lighting)) {
        if (!has_lit_vertex(frame)) {
          path = Path::kDiffusePatch;
        } else if (is_out_of_fade(lighting, frame)) {
          prepare_stepped_distance(lighting, frame, prepared.patch);
          prepared.middle_left = frame.middle_left;
          prepared.path = Path::kSteppedDistance;
          return;
        } else {
          path = Path::kWide;
        }
      }
    }
    prepare_path(lighting, frame, path, prepared);
  }

  /// Prepares the triangle for `path`, which its normals and its size must allow.
  template <class Frame>
  static constexpr void prepare_path(const Lighting& lighting, Frame& frame, Path path, Prepared& prepared) {
    prepared.middle_left = frame.middle_left;
    prepared.path = path;
    if (kDrawsDark && path == Path::kDark) {
      if constexpr (!kHasRoomForLoops) {  // N·L = 0 as a patch
        prepared.patch[0] = {};
        prepared.path = Path::kDiffusePatch;
      }
      return;
    }
    const std::size_t count = path == Path::kDiffusePatch || path == Path::kDiffuseWide ? 1
                              : path == Path::kDiffuseSumPatch ? Illumination::kLights
                                                               : kScalars;
    const TriangleChords& chords = frame.chords;
    if (path == Path::kWide || path == Path::kDiffuseWide) {
      prepare_wide(frame, count, widest_piece(lighting.widest_patch()), prepared.wide);
      return;
    }
    const EdgeSagittaFactors sagitta_factors = sagitta_factors_of(chords);
    if constexpr (kHasDiffusePath && Illumination::kLights > 1) {
      if (path == Path::kDiffusePatch) {
        (void)make_diffuse_patch(lighting, frame, sagitta_factors, prepared.patch[0]);
        return;
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      make_patch_scalar(
          frame, sagitta_factors,
          {frame.top->shade.scalars[i], frame.middle->shade.scalars[i], frame.bottom->shade.scalars[i]},
          prepared.patch[i]);
    }
  }
};

/// ArcUpTo for any normals.
template <class Illumination>
using Arc = ArcUpTo<Illumination, WidestNormals::kAny>;

}  // namespace arcspan
