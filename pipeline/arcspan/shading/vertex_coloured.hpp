// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/shading/gouraud.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Gouraud shading with the colours of the mesh's vertices: the illumination at a vertex times its colour is
/// interpolated. The material is usually white; its highlights take the colour too.
template <class Illumination>
struct VertexColoured : Gouraud<Illumination> {
  using typename Gouraud<Illumination>::Vertex;
  using DrawsSmallTrianglesAs = VertexColoured;

  /// Multiplies the illumination by the vertex' colour (TakesVertexData).
  static constexpr void set_vertex_data(const MeshView& mesh, std::size_t i, Vertex& vertex) {
    const Rgb8 colour = mesh.colour(i);
    const auto times = [](std::int32_t light, std::uint32_t level) {
      const std::uint32_t product = static_cast<std::uint32_t>(light) * level;  // below 2^24
      // 1/255 by 32-bit products: v/256 + v/256^2, rounded up where it counts.
      const std::uint32_t rounded = product + 128;
      return static_cast<std::int32_t>((rounded + (rounded >> 8) + (rounded >> 16)) >> 8);
    };
    vertex = {times(vertex.r, colour.r), times(vertex.g, colour.g), times(vertex.b, colour.b)};
  }
};

/// An illumination without light: every colour is the surface's own.
struct FullLight {
  struct Scalars {};
  [[nodiscard]] constexpr Scalars scalars(const Direction&) const { return {}; }
  [[nodiscard]] constexpr DeepColour deep_colour(Scalars) const { return {65280, 65280, 65280}; }
};

/// The colours of the mesh's vertices, interpolated, without light.
using UnlitVertexColoured = VertexColoured<FullLight>;

}  // namespace arcspan
