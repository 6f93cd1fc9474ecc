// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Bounds of the light over a triangle, by which shading methods choose a path.
namespace arcspan {

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
ARCSPAN_INLINE constexpr std::int32_t Illumination<Lights, Model, Features>::nearest_highlight(
    const Scalars& a, const Scalars& b, const Scalars& c, Cosine headroom) const {
  std::int32_t nearest = INT32_MAX;
  for (std::size_t i = 0; i < Lights; ++i) {
    const std::int32_t distance = nearest_highlight_of(i, a, b, c, headroom);
    if (distance < nearest) nearest = distance;
  }
  return nearest;
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

/// Returns a lower bound of the half distance over a triangle, 30 fraction bits. That of N·H follows from
/// highest_over(), that of R·V as follows.
///
/// With N = sum l_i N_i / w, w^2 = 1 - sum l_i l_j s_ij, s_ij = |N_i - N_j|^2, and K = (1 + L·V) / 2, the
/// half distance K - (N·L)(N·V) exceeds r where
///
///     sum l_i (h_i - r) - sum l_i l_j (m_ij - r s_ij) > 0,   m_ij = K s_ij - ((N_i - N_j)·L) ((N_i - N_j)·V)
///
/// and h_i are the half distances of the vertices. With h the least of them the left side is at least
/// h - r - sum l_i l_j (m_ij - r s_ij - h_i - h_j + 2h), and sum l_i l_j <= 1/3. So it is positive if r < h
/// and r (3 - s_ij) < h_i + h_j + h - m_ij for all edges.
template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr std::int32_t Illumination<Lights, Model, Features>::nearest_in_triangle(
    std::size_t light, std::int32_t reach, const Scalars& a, const Scalars& b, const Scalars& c,
    std::uint32_t ab, std::uint32_t ac, std::uint32_t bc) const {
  if constexpr (Model == Highlight::kBlinn) {
    const std::size_t other = highlight_index(light);
    const std::uint32_t widest = ab > ac ? (ab > bc ? ab : bc) : ac > bc ? ac : bc;
    return highlight_distance({}, detail::highest_over(a[other], b[other], c[other], widest), light);
  }
  constexpr std::int32_t kRounding = std::int32_t{1} << (28 - 11);  // of factors with 14 fraction bits
  const std::int32_t most = half_one_plus_light_eye_[light] >> 2;   // K, 28 fraction bits
  struct Vertex {
    std::int32_t light;
    std::int32_t eye;
    std::int32_t distance;  // 28 fraction bits
  };
  const auto vertex = [&](const Scalars& at) {
    const std::int32_t by_light = at[light].raw() >> 16;
    const std::int32_t by_eye = at[highlight_index(light)].raw() >> 16;
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
  // Most triangles that a highlight reaches are found by their vertices.
  const std::int32_t within = reach >> 2;
  std::int32_t nearest = least;
  if (nearest > within) nearest = lesser(nearest, along(at_a, at_b, ab));
  if (nearest > within) nearest = lesser(nearest, along(at_a, at_c, ac));
  if (nearest > within) nearest = lesser(nearest, along(at_b, at_c, bc));
  return wrap_shl(nearest, 2);
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr std::uint32_t Illumination<Lights, Model, Features>::largest_weight(std::size_t light) const {
  if constexpr (kWeighsChannels) {
    return largest_channel(weights_[light]);
  } else {
    return highlight_weight(light);
  }
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr HighlightBound Illumination<Lights, Model, Features>::highlights_over(
    const Scalars& a, const Scalars& b, const Scalars& c, std::uint32_t ab, std::uint32_t ac,
    std::uint32_t bc) const {
  HighlightBound bound{INT32_MAX, 0};
  std::uint32_t slopes = 0;  // 15 fraction bits, as the weights
  std::uint32_t weights = 0;
  for (std::size_t i = 0; i < Lights; ++i) {
    const std::uint32_t weight = largest_weight(i);
    weights += weight;
    if (a[i].raw() <= 0 && b[i].raw() <= 0 && c[i].raw() <= 0) continue;
    const std::int32_t nearest = nearest_in_triangle(i, 0, a, b, c, ab, ac, bc);
    if (nearest < bound.nearest) bound.nearest = nearest;
    if (nearest >= power_.half_reach()) continue;
    slopes += may_end(i, a, b, c) ? weight : (weight * highlight_slope(nearest)) >> 15;
  }
  if constexpr (Lights == 1) {
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

}  // namespace arcspan
