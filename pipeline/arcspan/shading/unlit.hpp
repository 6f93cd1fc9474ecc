// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/shading/method.hpp>

#include <type_traits>

namespace arcspan {

/// One colour for the whole object, without light: signs, sprites, emitters.
struct Unlit {
  using Lighting = PackedRgb;
  struct Face {};
  struct Vertex {};
  struct Prepared {};
  using DrawsSmallTrianglesAs = Unlit;
  static constexpr bool kNeedsFaceNormal = false;

  [[nodiscard]] static constexpr Vertex shade_vertex(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static constexpr Vertex between(const Vertex&, const Vertex&, Factor) { return {}; }
  template <class Frame>
  static constexpr void prepare(const Lighting&, const Frame&, const Face&, Prepared&) {}

  /// The Lighting that draws in `colour`.
  [[nodiscard]] static constexpr Lighting lighting(Rgb8 colour) { return PackedRgb::of(colour); }

  struct Run {
    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const { return lighting; }
    constexpr void next() {}
  };

  /// The rows of a triangle, whatever its size.
  struct Walker {
    using Run = Unlit::Run;
    [[nodiscard]] constexpr Run row(const RowStart&) const { return {}; }
    [[nodiscard]] constexpr Run row(std::int32_t, std::int32_t, std::int32_t) const { return {}; }
    constexpr void next_row() {}
    constexpr void enter_lower() {}
  };

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared&, Draw&& draw) {
    return draw(Walker());
  }

  struct Small {};
  template <class Raster>
  [[nodiscard]] static constexpr bool prepare_small(const Lighting&, const Raster&, const Raster&,
                                                    const Raster&, const Face&, const SmallTriangle&,
                                                    Small&) {
    return true;
  }
  template <class Draw>
  [[nodiscard]] static constexpr Status walk_small(const Small&, Draw&& draw) {
    return draw(Walker());
  }
};

/// A method that draws a whole object in one colour: Unlit, with operations or without. Lines and points are
/// drawn by such methods.
template <class M>
concept OneColour = ShadingMethod<M> && std::is_empty_v<typename M::Vertex> &&
    std::is_empty_v<typename M::Face> && std::is_empty_v<typename M::Prepared> && !bool{M::kNeedsFaceNormal};

}  // namespace arcspan
