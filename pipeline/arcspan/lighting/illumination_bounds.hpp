// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Bounds of the light over a triangle, by which shading methods choose a path.
namespace arcspan {

namespace detail {

/// Returns how far a scalar (the product of the normal and a fixed unit vector) may exceed the largest of its
/// values at the vertices of a triangle whose widest squared chord is s = `chord` (28 fraction bits, at most
/// 1): s/6 + 0.058 s^2, 30 fraction bits. The normals lie in a cap of the radius R, sin^2(R) <= s/3. The
/// result is at least 1 / cos(R) - 1 = s/6 + s^2/24 + ..., and therefore at least 1 - cos(R). Only for s
/// above 0.99 it may be smaller than the former, by less than 2^-13.
[[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t cap_height(std::uint32_t chord) {
  const std::uint32_t s = chord >> 13;  // 15 fraction bits
  return static_cast<std::int32_t>(s * (5462u + ((s * 1901u) >> 15)));
}

/// The largest of three scalars, at least 0.
[[nodiscard]] constexpr std::int32_t largest(Cosine a, Cosine b, Cosine c) {
  const std::int32_t two = a.raw() > b.raw() ? a.raw() : b.raw();
  const std::int32_t three = two > c.raw() ? two : c.raw();
  return three > 0 ? three : 0;
}

/// Returns the slope of c^n by c at a half distance, as a part of the slope at c = 1, 15 fraction bits; above
/// 1 by up to 1/8 if n = 1. With p = c^n and h = (1 - c) / 2 it is c^(n - 1) = p / c: at most p (1 + 4 h) for
/// c of at least 1/2, and 2^(1 - n) below.
[[nodiscard]] constexpr std::uint32_t highlight_slope(const PowerTable& table, std::uint32_t shininess,
                                                      std::int32_t half_distance) {
  if (half_distance >= table.half_reach()) return 0;
  const std::uint32_t h = half_distance < 0 ? 0 : static_cast<std::uint32_t>(half_distance);
  if (h > std::uint32_t{1} << 28) return 32768u >> (shininess - 1);  // below half_reach() only if n < 10
  const std::uint32_t power = table(half_distance);
  return power + ((power * (h >> 15)) >> 13);
}

}  // namespace detail

/// By R·V the highlight cannot reach N·L = x if (1 + L·V) / 2 - x is beyond its reach: the half distance (1 +
/// L·V) / 2 - (N·L)(N·V) is at least that. x is 2^-7 above the N·L from which on highlights have their full
/// strength.
template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr bool Illumination<Lights, Model, Features>::may_end(std::size_t light, const Scalars& a,
                                                              const Scalars& b, const Scalars& c) const {
  const std::int32_t lit_from = fade().end().raw() + (std::int32_t{1} << (Cosine::kFraction - 7));
  if (Model == Highlight::kPhong && highlight_distance({}, {}, light) - lit_from >= power_.half_reach())
    return false;
  return a[light].raw() < lit_from || b[light].raw() < lit_from || c[light].raw() < lit_from;
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr bool Illumination<Lights, Model, Features>::lit_throughout(const Scalars& a, const Scalars& b,
                                                                     const Scalars& c,
                                                                     std::uint32_t& lit) const {
  lit = 0;
  if constexpr (Lights > 1) {
    for (std::size_t i = 0; i < Lights; ++i) {
      const bool any = a[i].raw() > 0 || b[i].raw() > 0 || c[i].raw() > 0;
      if (any && (a[i].raw() | b[i].raw() | c[i].raw()) < 0) return false;
      lit |= static_cast<std::uint32_t>(any) << i;
    }
  }
  return true;
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr std::int32_t Illumination<Lights, Model, Features>::nearest_highlight_of(
    std::size_t light, const Scalars& a, const Scalars& b, const Scalars& c, Cosine headroom) const {
  const auto highest = [&](std::size_t i) {
    const Cosine upper = a[i] > b[i] ? a[i] : b[i];
    const Cosine most = (upper > c[i] ? upper : c[i]) + headroom;
    return most.raw() < 0 ? Cosine{} : most;
  };
  const Cosine most_light = highest(light);
  if (most_light.raw() == 0) return INT32_MAX;
  return highlight_distance(most_light, highest(highlight_index(light)), light);
}

/// The linear normal is shorter than 1 by at most e/2, where e is at most a third of the widest squared chord
/// s: by s/6, if s is small. Planes are off by half of that, because all values are lengthened by the other
/// half. So N·L is off by s/12 of its largest value at the corners, the cosine of a highlight by s/3 by R·V,
/// and by s/12 by N·H.
template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr TriangleLight Illumination<Lights, Model, Features>::light_over(const Scalars& a, const Scalars& b,
                                                                          const Scalars& c,
                                                                          std::uint32_t widest) const {
  const Cosine headroom = Cosine::from_raw(detail::cap_height(widest) + (std::int32_t{1} << 18));
  std::int32_t nearest = INT32_MAX;
  bool ends = false;
  std::int32_t brightest = 0;
  for (std::size_t i = 0; i < Lights; ++i) {
    const std::int32_t distance = nearest_highlight_of(i, a, b, c, headroom);
    if (distance < nearest) nearest = distance;
    if constexpr (Lights == 1) brightest = detail::largest(a[i], b[i], c[i]);
    if (distance < limits_.shine_reach) ends = ends || may_end(i, a, b, c);
  }
  const std::uint32_t s = widest >> 13;  // 15 fraction bits
  const auto is_linear = [this, s](std::int32_t most) {
    const std::uint32_t light = (limits_.light_height * (static_cast<std::uint32_t>(most) >> 15)) >> 15;
    return ((light * s) >> 15) <= limits_.allowed_light;
  };
  TriangleLight result{LightReach::kHighlight, false, 0, static_cast<std::int32_t>((s * 21845u) >> 18),
                       limits_.widest_diffuse};
  if constexpr (kHasRamp) {
    std::uint32_t lit = 0;
    if (nearest >= limits_.shine_reach && lit_throughout(a, b, c, lit)) {
      result.reach = LightReach::kDiffuse;
      result.lit = static_cast<std::uint8_t>(lit);
      if constexpr (Lights > 1)
        brightest = detail::largest(diffuse_scalar(a, lit), diffuse_scalar(b, lit), diffuse_scalar(c, lit));
      result.linear = is_linear(brightest);
      return result;
    }
  }
  const std::uint32_t of_nearest = ends ? 32768u : detail::highlight_slope(power_, shininess_, nearest);
  const std::uint32_t slope = of_nearest < 32768u ? of_nearest : 32768u;
  const std::uint32_t sharp = (limits_.sharpness * (slope >> 3)) >> 12;
  if constexpr (Lights > 1) brightest = std::int32_t{1} << Cosine::kFraction;
  result.linear = is_linear(brightest) && s < 4096 && ((sharp * s) >> 9) <= limits_.allowed_highlight;
  const std::uint32_t limit =
      slope >= 32768u ? limits_.widest_highlight
                      : limit_at_slope(limits_.widest_highlight, static_cast<std::uint8_t>(slope >> 11));
  if (limit < result.quadratic_limit) result.quadratic_limit = limit;
  return result;
}

}  // namespace arcspan
