// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/root.hpp>
#include <arcspan/shading/arc/arc_walker.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <array>

namespace arcspan {

/// Spherical-angular Phong shading on scalars (S0 eq. 14): the products of the normal with L, H or V run
/// along great circles down the edges and along the rows, each by one multiply, one shift and sums a step. In
/// triangles whose normals are within 16 degrees the arcs are so flat that second differences do.
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
    kArcs,          ///< wide angles, slivers and very large triangles
    kPatch,         ///< near normals
    kDiffusePatch,  ///< near normals and no highlight within reach: N·L only
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

  /// Normals farther apart than 60 degrees (squared chord 1) are not interpolated; the triangle is split.
  static constexpr std::uint32_t kWidestChord = std::uint32_t{1} << 28;

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return {to_normal(normal), lighting.scalars(normal)};
  }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static constexpr bool too_wide(const Vertex& a, const Vertex& b) {
    return squared_chord(a.normal, b.normal) > kWidestChord;
  }

  /// The vertex at the fraction t of the arc from a to b. Wide arcs are halved until the series hold.
  [[nodiscard]] ARCSPAN_COLD static constexpr Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    Vertex from = a;
    Vertex to = b;
    constexpr Factor kHalf = Factor::of(0.5);
    for (int halvings = 0; halvings < 2 && too_wide(from, to); ++halvings) {
      const Vertex middle = middle_of(from, to);
      if (t == kHalf) return middle;  // exact, and the same from either end
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

  template <class Frame>
  [[nodiscard]] static constexpr TriangleChords chords_of(const Frame& frame) {
    const Normal& top = frame.top->shade.normal;
    const Normal& middle = frame.middle->shade.normal;
    const Normal& bottom = frame.bottom->shade.normal;
    return {squared_chord(top, middle), squared_chord(top, bottom), squared_chord(middle, bottom)};
  }

  /// `Frame` is a TriangleFrame whose vertices have this method's shade.
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

  /// Prepares the triangle for a path, which must be one that its angles allow.
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
  /// The root is of the raw value, 15 fraction bits up: 1/sqrt(value) = 2^7.5 / sqrt(raw), 46341 = 2^15.5.
  [[nodiscard]] ARCSPAN_COLD_OUTLINE static constexpr std::int64_t scaled(std::int64_t sum,
                                                                          const ReciprocalRoot& root) {
    const std::int64_t product = ((sum * root.mantissa) >> 8) * 46341;
    return (product + (std::int64_t{1} << (root.exponent - 1))) >> root.exponent;
  }

  /// Middle of an arc by dichotomy: (a + b) / sqrt(2 + z), z = 2 a·b = 2 - s. Opposite normals have no middle
  /// and give the zero vector, which is dark.
  [[nodiscard]] ARCSPAN_COLD static constexpr Vertex middle_of(const Vertex& a, const Vertex& b) {
    const std::int32_t rest =
        Factor::of(4.0).raw() - scaled_chord(squared_chord(a.normal, b.normal), AngleFormat::kWide).raw();
    ReciprocalRoot root = reciprocal_root(static_cast<std::uint32_t>(rest));
    if (rest <= 64) root.mantissa = 0;
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

  /// S0 eq. 2 at the fraction t of an arc of at most 60 degrees.
  [[nodiscard]] ARCSPAN_COLD static constexpr Vertex on_arc(const Vertex& a, const Vertex& b, Factor t) {
    constexpr AngleFormat kFormat = AngleFormat::kWide;
    const SquaredAngle angle =
        angle_of_chord(scaled_chord(squared_chord(a.normal, b.normal), kFormat), kFormat);
    const ArcStart at = arc_start(angle, kFormat, t, Factor{});
    const auto component = [&at](NormalComponent p, NormalComponent q) {
      const Factor middle =
          Factor::from_raw(std::int32_t{p.raw()} + q.raw());  // 14 bits summed: 15 bits of the mean
      const Factor rise = Factor::from_raw((std::int32_t{q.raw()} - p.raw()) * 2);
      const Factor sum = middle + times_angle(middle, at.even, kFormat) + multiply<Factor>(at.odd, rise);
      return NormalComponent::from_raw(static_cast<std::int16_t>(round_shift(sum.raw(), 1)));
    };
    constexpr SlopeScale kWholeArc = slope_scale(ArcFraction{}, 15, 0);  // only x is wanted of start_scalar()
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
