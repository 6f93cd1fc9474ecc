// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/root.hpp>
#include <arcspan/shading/arc/arc_walker.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <array>

namespace arcspan {

/// Spherical-angular Phong shading on scalars (S0 eq. 14). The products of the normal with L, H or V follow
/// great circles down the edges and along the rows; the recurrence steps each by one multiply, one shift and
/// three sums (ArcScalar). Triangles whose normals are within 16 degrees, or 12 degrees under a highlight
/// with n > 16 (widest_patch()), are patches instead: quadratic surfaces that second differences step
/// (decision 5).
template <class Illumination>
struct Arc {
  static constexpr std::size_t kScalars = Illumination::kScalars;
  using Scalars = std::array<Cosine, kScalars>;
  using Lighting = Illumination;
  struct Face {};
  struct Vertex {
    Normal normal;
    Scalars scalars;
  };
  enum class Path : std::uint8_t {
    kArcs,          ///< arcs: normals too far apart for a patch, slivers, triangles larger than kLargestPatch
    kPatch,         ///< a patch of every scalar
    kDiffusePatch,  ///< a patch of N·L only, up to 16 degrees; no highlight is within reach
  };
  struct Prepared {
    union {
      ArcTriangle<kScalars> arcs;
      Patch<kScalars> patch;
    };
    Path path;
    bool middle_left;
  };
  static constexpr bool kNeedsFaceNormal = false;
  static constexpr bool kUsesEncodedColours = true;

  /// The widest squared chord between two normals of a triangle: 1 (60 degrees), 28 fraction bits. Wider
  /// triangles are split.
  static constexpr std::uint32_t kWidestChord = std::uint32_t{1} << 28;

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return {to_normal(normal), lighting.scalars(normal)};
  }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static constexpr bool too_wide(const Vertex& a, const Vertex& b) {
    return squared_chord(a.normal, b.normal) > kWidestChord;
  }

  /// Returns the vertex at the fraction t, 0...1, of the arc from a to b. An arc wider than kWidestChord is
  /// halved up to twice first, so that the series of on_arc() hold.
  [[nodiscard]] ARCSPAN_COLD static constexpr Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    Vertex from = a;
    Vertex to = b;
    constexpr Factor kHalf = Factor::of(0.5);
    for (int halvings = 0; halvings < 2 && too_wide(from, to); ++halvings) {
      const Vertex middle = middle_of(from, to);
      if (t == kHalf) return middle;  // exact and independent of the order of a and b
      if (t < kHalf) {
        to = middle;
        t = t + t;
      } else {
        from = middle;
        t = t + t - Factor::of(1.0);
      }
    }
    return on_arc(from, to, t);
  }

  /// Returns the squared chords between the normals of a TriangleFrame (MeasuresChords).
  template <class Frame>
  [[nodiscard]] static constexpr TriangleChords chords_of(const Frame& frame) {
    const Normal& top = frame.top->shade.normal;
    const Normal& middle = frame.middle->shade.normal;
    const Normal& bottom = frame.bottom->shade.normal;
    return {squared_chord(top, middle), squared_chord(top, bottom), squared_chord(middle, bottom)};
  }

  /// Chooses the path of a triangle and prepares it. `Frame` is a TriangleFrame whose vertices have this
  /// method's `Vertex` as their shade.
  template <class Frame>
  static constexpr void prepare(const Lighting& lighting, Frame& frame, const Face&, Prepared& prepared) {
    prepare_path(frame, choose_path(lighting, frame, frame.chords.widest()), prepared);
  }

  /// Calls `draw` with the walker of the command's path.
  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if (prepared.path == Path::kArcs) return draw(ArcWalker<Lighting>(prepared.arcs));
    if constexpr (kHasDiffusePath) {
      if (prepared.path == Path::kDiffusePatch) {
        return draw(PatchWalker<PatchRun<Lighting, 1>, kScalars>(prepared.patch, prepared.middle_left));
      }
    }
    return draw(PatchWalker<PatchRun<Lighting, kScalars>, kScalars>(prepared.patch, prepared.middle_left));
  }

 protected:
  static constexpr bool kHasDiffusePath = Illumination::kLights == 1;

  /// Prepares the triangle for `path`, which its normals and its size must allow.
  template <class Frame>
  static constexpr void prepare_path(Frame& frame, Path path, Prepared& prepared) {
    prepared.middle_left = frame.middle_left;
    prepared.path = path;
    if (path == Path::kArcs) {
      prepare_arcs(frame, prepared.arcs);
      return;
    }
    const TriangleChords& chords = frame.chords;
    const EdgeSagittaFactors sagitta_factors{sagitta_factor(chords.top_middle),
                                             sagitta_factor(chords.top_bottom),
                                             sagitta_factor(chords.middle_bottom)};
    const std::size_t count = path == Path::kDiffusePatch ? 1 : kScalars;
    for (std::size_t i = 0; i < count; ++i) {
      make_patch_scalar(
          frame, sagitta_factors,
          {frame.top->shade.scalars[i], frame.middle->shade.scalars[i], frame.bottom->shade.scalars[i]},
          prepared.patch[i]);
    }
  }

  /// Returns the path of a triangle; `widest` is its widest squared chord, 28 fraction bits.
  template <class Frame>
  [[nodiscard]] static constexpr Path choose_path(const Lighting& lighting, const Frame& frame,
                                                  std::uint32_t widest) {
    if (widest > kWidestPatch || !patch_fits(frame)) return Path::kArcs;
    if constexpr (kHasDiffusePath) {
      if (!lighting.may_shine(frame.top->shade.scalars, frame.middle->shade.scalars,
                              frame.bottom->shade.scalars, kPatchHeadroom)) {
        return Path::kDiffusePatch;
      }
    }
    return widest > lighting.widest_patch() ? Path::kArcs : Path::kPatch;
  }

 private:
  /// Returns sum / sqrt(value), rounded to nearest. `root` is the reciprocal root of the raw value, which has
  /// 15 fraction bits: 1/sqrt(value) = 2^7.5 / sqrt(raw), and 46341 = 2^15.5.
  [[nodiscard]] ARCSPAN_COLD_OUTLINE static constexpr std::int64_t scaled(std::int64_t sum,
                                                                          const ReciprocalRoot& root) {
    const std::int64_t product = ((sum * root.mantissa) >> 8) * 46341;
    return (product + (std::int64_t{1} << (root.exponent - 1))) >> root.exponent;
  }

  /// Returns the middle of an arc by dichotomy (S3): (a + b) / sqrt(2 + z), z = 2 a·b = 2 - s, where s is the
  /// squared chord and 2 + z = |a + b|^2. Opposite normals have no middle; they give the zero vector, which
  /// is dark.
  [[nodiscard]] ARCSPAN_COLD static constexpr Vertex middle_of(const Vertex& a, const Vertex& b) {
    const std::int32_t squared_sum =
        Factor::of(4.0).raw() - scaled_chord(squared_chord(a.normal, b.normal), AngleFormat::kWide).raw();
    ReciprocalRoot root = reciprocal_root(static_cast<std::uint32_t>(squared_sum));
    if (squared_sum <= 64) root.mantissa = 0;
    const auto component = [&root](NormalComponent p, NormalComponent q) {
      return NormalComponent::from_raw(
          static_cast<std::int16_t>(scaled(std::int64_t{p.raw()} + q.raw(), root)));
    };
    Vertex middle;
    middle.normal = {component(a.normal.x, b.normal.x), component(a.normal.y, b.normal.y),
                     component(a.normal.z, b.normal.z)};
    for (std::size_t i = 0; i < kScalars; ++i) {
      middle.scalars[i] = Cosine::from_raw(
          static_cast<std::int32_t>(scaled(std::int64_t{a.scalars[i].raw()} + b.scalars[i].raw(), root)));
    }
    return middle;
  }

  /// Returns the vertex at the fraction t, 0...1, of an arc of at most 60 degrees (S0 eq. 2).
  [[nodiscard]] ARCSPAN_COLD static constexpr Vertex on_arc(const Vertex& a, const Vertex& b, Factor t) {
    constexpr AngleFormat kFormat = AngleFormat::kWide;
    const SquaredAngle angle =
        angle_of_chord(scaled_chord(squared_chord(a.normal, b.normal), kFormat), kFormat);
    const ArcStart at = arc_start(angle, kFormat, t, Factor{});
    const auto component = [&at](NormalComponent p, NormalComponent q) {
      const Factor middle = Factor::from_raw(std::int32_t{p.raw()} +
                                             q.raw());  // the sum has 14 fraction bits, so the mean has 15
      const Factor difference = Factor::from_raw((std::int32_t{q.raw()} - p.raw()) * 2);
      const Factor sum =
          middle + times_angle(middle, at.even, kFormat) + multiply<Factor>(at.odd, difference);
      return NormalComponent::from_raw(static_cast<std::int16_t>(round_shift(sum.raw(), 1)));
    };
    constexpr SlopeScale kWholeArc = slope_scale(ArcFraction{}, 15, 0);  // d of start_scalar() is not used
    Vertex point;
    point.normal = {component(a.normal.x, b.normal.x), component(a.normal.y, b.normal.y),
                    component(a.normal.z, b.normal.z)};
    for (std::size_t i = 0; i < kScalars; ++i) {
      point.scalars[i] = start_scalar(at, kFormat, kWholeArc, a.scalars[i], b.scalars[i]).x;
    }
    return point;
  }
};

}  // namespace arcspan
