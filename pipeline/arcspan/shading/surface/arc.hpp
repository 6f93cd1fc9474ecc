// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/shading/surface/chords.hpp>
#include <arcspan/shading/surface/order.hpp>
#include <arcspan/shading/surface/run.hpp>
#include <arcspan/shading/surface/small.hpp>
#include <arcspan/shading/surface/surface.hpp>
#include <arcspan/shading/surface/walker.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Phong shading by scalars: the products of the normal with L, H or V are interpolated over a triangle, and
/// no pixel needs a root or a division. Each triangle is drawn by the cheapest order that is within the
/// tolerance of the illumination (choose_order()), with the highlight if that is within reach, or by N·L
/// alone. How accurate that is: docs/accuracy.md. Why: decision 35.
///
/// `Illumination` is an Illumination or an EnvironmentMap.
template <class Illumination>
struct Arc {
  static constexpr std::size_t kScalars = Illumination::kScalars;
  using Lighting = Illumination;
  struct Face {};
  using Vertex = SurfaceVertex<kScalars>;
  static constexpr bool kNeedsFaceNormal = false;
  using DrawsSmallTrianglesAs = Arc;

  /// The loops over pixels: an order each, by all scalars or by the diffuse scalar alone.
  enum class Path : std::uint8_t {
    kLinear,
    kQuadratic,
    kNormalised,
    kLinearDiffuse,
    kQuadraticDiffuse,
    kNormalisedDiffuse,
  };
  struct Prepared {
    union {
      std::array<PlaneScalar, kScalars> linear;
      std::array<BentScalar, kScalars> quadratic;
      NormalisedSurface<kScalars> normalised;
    };
    bool middle_left;
    Path path;
  };
  /// The part of a small triangle.
  struct Small : SmallSurface<kScalars> {
    Path path;
  };

  [[nodiscard]] static constexpr Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return {to_normal(normal), 0, lighting.scalars(normal)};
  }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  /// Returns the vertex at the fraction t, 0...1, of the chord from a to b.
  [[nodiscard]] static constexpr Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    return on_chord(a, b, t);
  }

  /// Chooses the order of a triangle and prepares its surface. `Frame` is a TriangleFrame of this method's
  /// vertices.
  template <class Frame>
  static constexpr void prepare(const Lighting& lighting, Frame& frame, const Face&, Prepared& prepared) {
    const SurfaceChoice choice = choose_order(lighting, frame.top->shade, frame.middle->shade,
                                              frame.bottom->shade, is_bendable(frame));
    prepare(lighting, frame, choice, prepared);
  }
  /// Prepares the surface of a triangle of the order that was chosen.
  template <class Frame>
  ARCSPAN_INLINE static constexpr void prepare(const Lighting& lighting, const Frame& frame,
                                               const SurfaceChoice& choice, Prepared& prepared) {
    const Vertex& top = frame.top->shade;
    const Vertex& middle = frame.middle->shade;
    const Vertex& bottom = frame.bottom->shade;
    prepared.middle_left = frame.middle_left;
    prepared.path = path_of(choice);
    const bool all = choice.light.reach == LightReach::kHighlight;
    const auto corner = [&](const Vertex& vertex, std::size_t i) {
      return all ? scalar(lighting, choice, vertex, i) : diffuse(lighting, choice, vertex);
    };
    for (std::size_t i = 0; i < (all ? kScalars : 1); ++i) {
      prepare_scalar(frame, choice, i, corner(top, i), corner(middle, i), corner(bottom, i), prepared);
    }
    if (choice.order == SurfaceOrder::kNormalised) prepare_missing(frame, choice.chords, prepared.normalised);
  }

  /// Calls `draw` with the walker of the triangle's path. Without `DrawsLinear` the caller draws what is
  /// linear in N·L alone (LevelArc).
  template <bool DrawsLinear = true, class Draw>
  [[nodiscard]] ARCSPAN_INLINE static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    switch (prepared.path) {
      case Path::kLinearDiffuse:
        if constexpr (kHasDiffuse && DrawsLinear)
          return draw(Linear<1>(prepared.middle_left, prepared.linear));
        break;
      case Path::kLinear:
        return draw(Linear<kScalars>(prepared.middle_left, prepared.linear));
      case Path::kQuadraticDiffuse:
        if constexpr (kHasDiffuse) return draw(Quadratic<1>(prepared.middle_left, prepared.quadratic));
        break;
      case Path::kQuadratic:
        return draw(Quadratic<kScalars>(prepared.middle_left, prepared.quadratic));
      case Path::kNormalisedDiffuse:
        if constexpr (kHasDiffuse) return draw(Normalised<1>(prepared.middle_left, prepared.normalised));
        break;
      case Path::kNormalised:
        break;
    }
    return draw(Normalised<kScalars>(prepared.middle_left, prepared.normalised));
  }

  /// Prepares a small triangle (DrawsSmallTriangles) with the vertices top, middle and bottom. Its surface is
  /// linear or normalised: a quadratic one would cost as much as it saves.
  template <class Raster>
  [[nodiscard]] ARCSPAN_INLINE static constexpr bool prepare_small(const Lighting& lighting,
                                                                   const Raster& top, const Raster& middle,
                                                                   const Raster& bottom, const Face&,
                                                                   const SmallTriangle& triangle,
                                                                   Small& part) {
    const Vertex& a = top.shade;
    const Vertex& b = middle.shade;
    const Vertex& c = bottom.shade;
    if ((a.deficit | b.deficit | c.deficit) != 0) return false;
    const SurfaceChoice choice = choose_order(lighting, a, b, c, false);
    part.path = path_of(choice);
    if (choice.light.reach != LightReach::kHighlight) {
      part.planes.prepare(0, diffuse(lighting, choice, a), diffuse(lighting, choice, b),
                          diffuse(lighting, choice, c), triangle);
    } else {
      unrolled<kScalars>([&](auto i) {
        part.planes.prepare(i, scalar(lighting, choice, a, i), scalar(lighting, choice, b, i),
                            scalar(lighting, choice, c, i), triangle);
      });
    }
    if (choice.order == SurfaceOrder::kNormalised) part.missing.prepare(choice.chords, triangle);
    return true;
  }
  /// Calls `draw` with the surface of a small triangle.
  template <class Draw>
  [[nodiscard]] static constexpr Status walk_small(const Small& part, Draw&& draw) {
    if constexpr (kHasDiffuse) {
      if (part.path == Path::kLinearDiffuse) return draw(SmallFlat<1>{part});
      if (part.path == Path::kNormalisedDiffuse) return draw(SmallRound<1>{part});
    }
    if (part.path == Path::kLinear) return draw(SmallFlat<kScalars>{part});
    return draw(SmallRound<kScalars>{part});
  }

  /// Quadratic surfaces of larger triangles would show the rounding errors of second differences: those of
  /// 128 pixels add up to 2^-17, which changes a highlight of n = 64 by half an 8-bit step.
  template <class Frame>
  [[nodiscard]] static constexpr bool is_bendable(const Frame& frame) {
    constexpr std::uint32_t kLargest = 128;
    return frame.width < kLargest << 16 && frame.long_edge.dy < std::int32_t{kLargest} << Subpixel::kFraction;
  }

  /// The scalar of a vertex as pixels without highlight take it.
  [[nodiscard]] ARCSPAN_INLINE static constexpr Cosine diffuse([[maybe_unused]] const Lighting& lighting,
                                                               const SurfaceChoice& choice,
                                                               [[maybe_unused]] const Vertex& vertex) {
    if constexpr (kHasDiffuse) {
      if (choice.light.reach == LightReach::kDiffuse)
        return lifted(choice, lighting.diffuse_scalar(vertex.scalars, choice.light.lit));
    }
    return {};
  }

 private:
  /// False for coloured lights and environment maps, whose pixels always take all scalars.
  static constexpr bool kHasDiffuse = Illumination::kHasRamp;
  template <std::size_t Used>
  using Linear = SurfaceWalker<LinearRun<Lighting, Used>, std::array<PlaneScalar, kScalars>>;
  template <std::size_t Used>
  using Quadratic = SurfaceWalker<QuadraticRun<Lighting, Used>, std::array<BentScalar, kScalars>>;
  template <std::size_t Used>
  using Normalised = SurfaceWalker<NormalisedRun<Lighting, Used>, NormalisedSurface<kScalars>>;
  template <std::size_t Used>
  using SmallFlat = SmallRows<LinearRun<Lighting, Used>, kScalars>;
  template <std::size_t Used>
  using SmallRound = SmallRows<NormalisedRun<Lighting, Used>, kScalars>;

  [[nodiscard]] static constexpr Path path_of(const SurfaceChoice& choice) {
    const int diffuse = choice.light.reach == LightReach::kHighlight ? 0 : 3;
    return static_cast<Path>(static_cast<int>(choice.order) + diffuse);
  }

  /// The scalar i of a vertex as pixels with all scalars take it.
  [[nodiscard]] ARCSPAN_INLINE static constexpr Cosine scalar(const Lighting& lighting,
                                                              const SurfaceChoice& choice,
                                                              const Vertex& vertex, std::size_t i) {
    return lighting.pixel_scalar(lifted(choice, vertex.scalars[i]), i);
  }
  [[nodiscard]] ARCSPAN_INLINE static constexpr Cosine lifted(const SurfaceChoice& choice, Cosine scalar) {
    return choice.order == SurfaceOrder::kLinear ? lengthened(scalar, choice.light.lift) : scalar;
  }

  /// Prepares the surface of scalar i from its values at the vertices.
  template <class Frame>
  static constexpr void prepare_scalar(const Frame& frame, const SurfaceChoice& choice, std::size_t i,
                                       Cosine top, Cosine middle, Cosine bottom, Prepared& prepared) {
    if (choice.order == SurfaceOrder::kQuadratic) {
      make_quadratic_scalar(frame, {top.raw(), middle.raw(), bottom.raw()},
                            sagittas(choice.chords, top, middle, bottom), {0, 0}, prepared.quadratic[i]);
    } else {
      auto& scalars = choice.order == SurfaceOrder::kLinear ? prepared.linear : prepared.normalised.scalars;
      make_linear_scalar(frame, top, middle, bottom, scalars[i]);
    }
  }

  [[nodiscard]] static constexpr EdgeBends sagittas(const NormalChords& chords, Cosine top, Cosine middle,
                                                    Cosine bottom) {
    return {sagitta(top, middle, sagitta_factor(chords.top_middle)),
            sagitta(top, bottom, sagitta_factor(chords.top_bottom)),
            sagitta(middle, bottom, sagitta_factor(chords.middle_bottom))};
  }

  /// Prepares 1 - |M|^2, whose bends are the squared chords.
  template <class Frame>
  static constexpr void prepare_missing(const Frame& frame, const NormalChords& chords,
                                        NormalisedSurface<kScalars>& surface) {
    // Opposite normals have no direction half-way; 3.75, so that sums and slopes fit.
    constexpr std::uint32_t kMost = std::uint32_t{15} << 26;
    constexpr std::uint32_t kNarrow = std::uint32_t{15} << 24;  // 0.94, just below 60 degrees
    constexpr std::uint32_t kLarge = std::uint32_t{256} << 16;  // slopes are small, but their errors add up
    const auto bend = [&](std::uint32_t chord) {
      return static_cast<std::int32_t>(chord < kMost ? chord : kMost);
    };
    const auto deficit = [](const Vertex& vertex) { return std::int32_t{vertex.deficit} << 12; };
    const CornerValues at{deficit(frame.top->shade), deficit(frame.middle->shade),
                          deficit(frame.bottom->shade)};
    const bool narrow = chords.widest() < kNarrow && (at.top | at.middle | at.bottom) == 0;
    surface.slope_dropped = narrow || frame.width >= kLarge ? 0 : 2;
    make_quadratic_scalar(frame, at,
                          {bend(chords.top_middle), bend(chords.top_bottom), bend(chords.middle_bottom)},
                          {2, surface.slope_dropped}, surface.missing);
  }
};

}  // namespace arcspan
