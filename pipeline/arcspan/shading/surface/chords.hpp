// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A vertex as `Arc` interpolates it: a normal M and scalars that are linear in it.
///
/// Normals of a mesh have length 1. Where a clip plane cuts an edge, M is the point of
/// the chord between the two normals, which is shorter. It is not normalised, so that the normal stays linear
/// along the edge; `deficit` is what is missing.
template <std::size_t Count>
struct SurfaceVertex {
  Normal normal;
  std::uint16_t deficit;  ///< 1 - |M|^2, 16 fraction bits; 0 if the vertex is one of the mesh
  std::array<Cosine, Count> scalars;
};

/// Squared chords |M_i - M_j|^2 between the normals at the ends of a triangle's edges, 28 fraction bits. The
/// vertices of a triangle are sorted by height.
struct NormalChords {
  std::uint32_t top_middle;
  std::uint32_t top_bottom;
  std::uint32_t middle_bottom;

  [[nodiscard]] constexpr std::uint32_t widest() const {
    const std::uint32_t of_top = top_middle > top_bottom ? top_middle : top_bottom;
    return of_top > middle_bottom ? of_top : middle_bottom;
  }
  [[nodiscard]] constexpr std::uint32_t sum() const { return top_middle + top_bottom + middle_bottom; }
};

/// Returns the vertex at the fraction t, 0...1, of the chord from a to b. At 1/2 the result does not depend
/// on the order of a and b.
template <std::size_t Count>
[[nodiscard]] ARCSPAN_COLD constexpr SurfaceVertex<Count> on_chord(const SurfaceVertex<Count>& a,
                                                                   const SurfaceVertex<Count>& b, Factor t) {
  const auto mix = [t](std::int64_t from, std::int64_t to) {
    return static_cast<std::int32_t>(from + (((to - from) * t.raw() + (1 << 14)) >> 15));
  };
  const auto component = [&mix](NormalComponent from, NormalComponent to) {
    return NormalComponent::from_raw(static_cast<std::int16_t>(mix(from.raw(), to.raw())));
  };
  SurfaceVertex<Count> vertex;
  vertex.normal = {component(a.normal.x, b.normal.x), component(a.normal.y, b.normal.y),
                   component(a.normal.z, b.normal.z)};
  // |M|^2 = (1 - t) |A|^2 + t |B|^2 - t (1 - t) |A - B|^2
  const auto fraction = static_cast<std::uint32_t>(t.raw());
  const std::uint32_t product = (fraction * (32768u - fraction)) >> 15;  // at most 2^13
  const std::uint32_t of_chord = (product * (squared_chord(a.normal, b.normal) >> 12)) >> 15;
  const std::uint32_t deficit = static_cast<std::uint32_t>(mix(a.deficit, b.deficit)) + of_chord;
  vertex.deficit = static_cast<std::uint16_t>(deficit < 65535u ? deficit : 65535u);
  for (std::size_t i = 0; i < Count; ++i) {
    vertex.scalars[i] = Cosine::from_raw(mix(a.scalars[i].raw(), b.scalars[i].raw()));
  }
  return vertex;
}

}  // namespace arcspan
