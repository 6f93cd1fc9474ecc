// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/shading/method.hpp>

#include <cstdint>

namespace arcspan {

/// Flat shading: one colour per triangle, from the full illumination of its face normal.
template <class Illumination>
struct Flat {
  using Lighting = Illumination;
  using Face = PackedRgb;
  struct Vertex {};
  using Prepared = PackedRgb;
  using DrawsSmallTrianglesAs = Flat;
  static constexpr std::int32_t kSmallSize = 16;
  static constexpr bool kNeedsFaceNormal = true;

  [[nodiscard]] static Vertex shade_vertex(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static Face shade_face(const Lighting& lighting, const Direction& normal) {
    return lighting.colour(lighting.scalars(normal));
  }
  [[nodiscard]] static constexpr Vertex between(const Vertex&, const Vertex&, Factor) { return {}; }
  template <class Frame>
  static constexpr void prepare(const Lighting&, const Frame&, const Face& face, Prepared& prepared) {
    prepared = face;
  }

  struct Run {
    PackedRgb value;
    [[nodiscard]] constexpr PackedRgb colour(const Lighting&) const { return value; }
    constexpr void next() {}
  };

  /// The rows of a triangle, whatever its size.
  struct Walker {
    using Run = Flat::Run;
    PackedRgb value;
    [[nodiscard]] constexpr Run row(const RowStart&) const { return {value}; }
    [[nodiscard]] constexpr Run row(std::int32_t, std::int32_t, std::int32_t) const { return {value}; }
    constexpr void next_row() {}
    constexpr void enter_lower() {}
  };

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return draw(Walker{prepared});
  }

  using Small = PackedRgb;
  template <class Raster>
  [[nodiscard]] static constexpr bool prepare_small(const Lighting&, const Raster&, const Raster&,
                                                    const Raster&, const Face& face, const SmallTriangle&,
                                                    Small& part) {
    part = face;
    return true;
  }
  template <class Draw>
  [[nodiscard]] static constexpr Status walk_small(const Small& part, Draw&& draw) {
    return draw(Walker{part});
  }
};

}  // namespace arcspan
