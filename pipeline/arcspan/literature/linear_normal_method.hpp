// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/linear_normal.hpp>
#include <arcspan/literature/prepared_walker.hpp>
#include <arcspan/status.hpp>

namespace arcspan {

/// A shading method that interpolates the normal linearly on the screen: the common part of Phong and
/// ReflectionMap. `ColourOf::colour(lighting, normal)` gives the colour of a linear normal (LinearNormal).
template <class MethodLighting, class ColourOf>
struct LinearNormalMethod {
  using Lighting = MethodLighting;
  struct Face {};
  using Vertex = Direction;
  struct Prepared {
    NormalPlane normal;
    bool middle_left;

    constexpr void next_row() { normal.next_row(); }
    constexpr void enter_lower() { normal.enter_lower(middle_left); }
  };
  static constexpr bool kNeedsFaceNormal = false;

  [[nodiscard]] static Vertex shade_vertex(const Lighting&, const Direction& normal) { return normal; }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    return between_normalised(a, b, t);
  }

  template <class Method>
  static constexpr void prepare(const Lighting&, const TriangleFrame<Method>& frame, const Face&,
                                Prepared& prepared) {
    make_normal_plane(frame, frame.top->shade, frame.middle->shade, frame.bottom->shade, prepared.normal);
    prepared.middle_left = frame.middle_left;
  }

  struct Run {
    LinearNormal normal;
    LinearNormal step;

    [[nodiscard]] static constexpr Run of_row(const Prepared& prepared, const RowStart& start) {
      return {prepared.normal.at(start), prepared.normal.step()};
    }
    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
      return ColourOf::colour(lighting, normal);
    }
    constexpr void next() { normal.advance(step); }
  };
  using Walker = PreparedWalker<Prepared, Run>;

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return draw(Walker(prepared));
  }
};

}  // namespace arcspan
