// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Bounds of the highlights over a triangle. (`Arc` takes Illumination::light_over().)
namespace arcspan {

/// Bounds of the highlights over a triangle. The slope of a highlight is that of c^n by c, as a part of the
/// slope at c = 1; those of several lights are added by their weights.
struct HighlightBound {
  std::int32_t nearest;  ///< least half distance (PowerTable); INT32_MAX if no light reaches the triangle
  /// The sum of the slopes is at most (slope + 1) / 16 of that of the weights; 15 if it may be all.
  std::uint8_t slope;

  static constexpr std::uint8_t kBrightest = 15;
};

namespace detail {

/// Returns an upper bound of a scalar over a triangle from its values c_i at the vertices; `chord` is the
/// widest squared chord, 28 fraction bits.
///
/// A normal inside is N = sum l_i N_i / w with l_i >= 0, sum l_i = 1 and w = |sum l_i N_i|. Let P be the sum
/// of l_i l_j over the edges, at most 1/3. Then w^2 >= 1 - s P, and because 1 / w is convex in P, it is at
/// most 1 + 3 P cap_height(). So the scalar is at most sum l_i c_i + 3 P cap_height(): the sum is at most 1,
/// and if it is negative, dividing by w <= 1 only lowers it. Let m be the largest c_i and m' the second one.
/// Then m - sum l_i c_i >= sum l_i l_j ((m - c_i) + (m - c_j)) >= P (m - m'), as one end of every edge has at
/// most m'. Since 3 P <= 1, the scalar exceeds m by at most cap_height() - (m - m') / 3, and not at all if
/// that is negative.
[[nodiscard]] constexpr Cosine highest_over(Cosine a, Cosine b, Cosine c, std::uint32_t chord) {
  const auto lesser = [](std::int32_t p, std::int32_t q) { return p < q ? p : q; };
  const auto greater = [](std::int32_t p, std::int32_t q) { return p > q ? p : q; };
  const std::int32_t of_two = greater(a.raw(), b.raw());
  const std::int32_t most = greater(of_two, c.raw());
  const std::int32_t second = lesser(of_two, greater(lesser(a.raw(), b.raw()), c.raw()));
  const std::int32_t quarter_gap = (most >> 2) - (second >> 2);  // the whole gap may overflow
  const std::int32_t above = cap_height(chord) - (quarter_gap + (quarter_gap >> 2));  // 5/16 < 1/3
  constexpr std::int32_t kRounding = std::int32_t{1} << 18;  // of packed normals, scalars and cap_height()
  return Cosine::from_raw(wrap_add(wrap_add(most, kRounding), greater(above, 0)));
}

}  // namespace detail

/// The part of highlights_over() that takes private members of an Illumination.
struct HighlightsOver {
  /// Returns a lower bound of the half distance over a triangle, 30 fraction bits. That of N·H follows from
  /// highest_over(), that of R·V as follows.
  ///
  /// With N = sum l_i N_i / w, w^2 = 1 - sum l_i l_j s_ij, s_ij = |N_i - N_j|^2, and K = (1 + L·V) / 2, the
  /// half distance K - (N·L)(N·V) exceeds r where
  ///
  ///     sum l_i (h_i - r) - sum l_i l_j (m_ij - r s_ij) > 0,
  ///     m_ij = K s_ij - ((N_i - N_j)·L) ((N_i - N_j)·V)
  ///
  /// and h_i are the half distances of the vertices. With h the least of them the left side is at least
  /// h - r - sum l_i l_j (m_ij - r s_ij - h_i - h_j + 2h), and sum l_i l_j <= 1/3. So it is positive if r < h
  /// and r (3 - s_ij) < h_i + h_j + h - m_ij for all edges.
  template <class Light>
  [[nodiscard]] static constexpr std::int32_t nearest_in_triangle(
      const Light& lit, std::size_t light, const typename Light::Scalars& a, const typename Light::Scalars& b,
      const typename Light::Scalars& c, std::uint32_t ab, std::uint32_t ac, std::uint32_t bc) {
    if constexpr (Light::kModel == Highlight::kBlinn) {
      const std::size_t other = Light::highlight_index(light);
      const std::uint32_t widest = ab > ac ? (ab > bc ? ab : bc) : ac > bc ? ac : bc;
      return lit.highlight_distance({}, detail::highest_over(a[other], b[other], c[other], widest), light);
    }
    constexpr std::int32_t kRounding = std::int32_t{1} << (28 - 11);       // of factors with 14 fraction bits
    const std::int32_t most = lit.highlight_distance({}, {}, light) >> 2;  // K, 28 fraction bits
    struct Vertex {
      std::int32_t light;
      std::int32_t eye;
      std::int32_t distance;  // 28 fraction bits
    };
    const auto vertex = [&](const typename Light::Scalars& at) {
      const std::int32_t by_light = at[light].raw() >> 16;
      const std::int32_t by_eye = at[Light::highlight_index(light)].raw() >> 16;
      return Vertex{by_light, by_eye, wrap_sub(most - kRounding, wrap_mul(by_light, by_eye))};
    };
    const Vertex at_a = vertex(a);
    const Vertex at_b = vertex(b);
    const Vertex at_c = vertex(c);
    const auto lesser = [](std::int32_t p, std::int32_t q) { return p < q ? p : q; };
    const std::int32_t least = lesser(lesser(at_a.distance, at_b.distance), at_c.distance);
    const auto along = [most, least](const Vertex& p, const Vertex& q, std::uint32_t chord) {
      const auto s = static_cast<std::int32_t>(chord >> 14);
      const std::int32_t sum = wrap_add(wrap_add(p.distance, q.distance), least);
      const std::int32_t change = wrap_mul(p.light - q.light, p.eye - q.eye);
      const std::int32_t room = wrap_sub(wrap_add(sum, change), (most >> 14) * s);
      return wrap_mul(room >> 14, 10923 + ((s * 7282) >> 15)) >> 1;  // (1 + s/3) / 3 < 1 / (3 - s)
    };
    // Below 0 the bound need not be exact: the highlight is full there.
    std::int32_t nearest = least;
    if (nearest > 0) nearest = lesser(nearest, along(at_a, at_b, ab));
    if (nearest > 0) nearest = lesser(nearest, along(at_a, at_c, ac));
    if (nearest > 0) nearest = lesser(nearest, along(at_b, at_c, bc));
    return wrap_shl(nearest, 2);
  }

  /// The largest weight of a light in a channel, 15 fraction bits; that of a single light is in the
  /// coefficients.
  template <class Light>
  [[nodiscard]] static constexpr std::uint32_t largest_weight(const Light& lit, std::size_t light) {
    if constexpr (Light::kLights == 1) {
      return std::uint32_t{1} << 15;
    } else if constexpr (Light::kHasRamp) {
      return lit.weights[light];
    } else {
      return largest_channel(lit.weights[light]);
    }
  }

  template <class Light>
  [[nodiscard]] static constexpr HighlightBound find(const Light& lit, const typename Light::Scalars& a,
                                                     const typename Light::Scalars& b,
                                                     const typename Light::Scalars& c, std::uint32_t ab,
                                                     std::uint32_t ac, std::uint32_t bc) {
    HighlightBound bound{INT32_MAX, 0};
    std::uint32_t slopes = 0;  // 15 fraction bits, as the weights
    std::uint32_t weights = 0;
    for (std::size_t i = 0; i < Light::kLights; ++i) {
      const std::uint32_t weight = largest_weight(lit, i);
      weights += weight;
      if (a[i].raw() <= 0 && b[i].raw() <= 0 && c[i].raw() <= 0) continue;
      const std::int32_t nearest = nearest_in_triangle(lit, i, a, b, c, ab, ac, bc);
      if (nearest < bound.nearest) bound.nearest = nearest;
      if (nearest >= lit.power_.half_reach()) continue;
      slopes += lit.may_end(i, a, b, c)
                    ? weight
                    : (weight * detail::highlight_slope(lit.power(), lit.shininess(), nearest)) >> 15;
    }
    if constexpr (Light::kLights == 1) {
      bound.slope = slopes >= 32768 ? HighlightBound::kBrightest : static_cast<std::uint8_t>(slopes >> 11);
    } else {
      std::uint32_t relative = 0;
      for (std::uint32_t step = 8; step != 0; step >>= 1) {
        if ((slopes << 4) >= weights * (relative + step)) relative += step;
      }
      bound.slope = static_cast<std::uint8_t>(relative);
    }
    return bound;
  }
};

/// Bounds of the highlights of all normals of a triangle, by any number of lights. `a`, `b` and `c` are the
/// scalars of its vertices; `ab`, `ac`, `bc`: squared chords, 28 fraction bits, at most 1.
template <std::size_t Lights, Highlight Model, IlluminationFeatures Features, class Scalars>
[[nodiscard]] constexpr HighlightBound highlights_over(const Illumination<Lights, Model, Features>& lit,
                                                       const Scalars& a, const Scalars& b, const Scalars& c,
                                                       std::uint32_t ab, std::uint32_t ac, std::uint32_t bc) {
  return HighlightsOver::find(lit, a, b, c, ab, ac, bc);
}

/// False if no normal of a triangle has a highlight. Arguments as for Illumination::nearest_highlight_of().
template <std::size_t Lights, Highlight Model, IlluminationFeatures Features, class Scalars>
[[nodiscard]] ARCSPAN_INLINE constexpr bool may_shine(const Illumination<Lights, Model, Features>& lit,
                                                      const Scalars& a, const Scalars& b, const Scalars& c,
                                                      Cosine headroom) {
  for (std::size_t i = 0; i < Lights; ++i) {
    if (lit.nearest_highlight_of(i, a, b, c, headroom) < lit.power().half_reach()) return true;
  }
  return false;
}

}  // namespace arcspan
