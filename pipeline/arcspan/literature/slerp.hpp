// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/prepared_walker.hpp>
#include <arcspan/literature/slerp_triangle.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

/// Direct spherical interpolation (S0 eq. 2, Shoemake), for comparison. Each pixel takes two sines from a
/// table, six products for the vector, then the products with L, H or V. Each row takes a root for its angle.
template <class Illumination>
struct Slerp : SlerpBase<Illumination, 0> {
  using Base = SlerpBase<Illumination, 0>;
  using typename Base::Lighting;
  using typename Base::Prepared;
  using typename Base::Vertex;

  [[nodiscard]] static Vertex shade_vertex(const Lighting&, const Direction& normal) {
    return Base::vertex_of(normal);
  }

  struct Run {
    Direction left;
    Direction right;
    SlerpArc arc;
    Angle32 phase;
    Angle32 step;

    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
      const SlerpArc::Weights w = arc.at(phase);
      const auto mix = [w](DirectionComponent a, DirectionComponent b) {
        return DirectionComponent::from_raw(
            round_shift(wrap_add(wrap_mul(a.raw(), w.a), wrap_mul(b.raw(), w.b)), 15));
      };
      return lighting.colour(
          lighting.scalars(Direction{mix(left.x, right.x), mix(left.y, right.y), mix(left.z, right.z)}));
    }
    constexpr void next() { phase += step; }

    [[nodiscard]] static constexpr Run of_row(const SlerpTriangle<Base::kCount>& triangle,
                                              const RowStart& start) {
      const SlerpRow<Base::kCount> row = triangle.row(start);
      return {direction(row.left), direction(row.right), row.arc, row.phase, row.step};
    }

    [[nodiscard]] static constexpr Direction direction(const SlerpValues<Base::kCount>& v) {
      return {convert<DirectionComponent>(v[0]), convert<DirectionComponent>(v[1]),
              convert<DirectionComponent>(v[2])};
    }
  };
  using Walker = PreparedWalker<SlerpTriangle<Base::kCount>, Run>;

  /// Returns the colour of the values that a vertex carries.
  [[nodiscard]] static constexpr PackedRgb colour_of(const Lighting& lighting,
                                                     const SlerpValues<Base::kCount>& values) {
    return lighting.colour(lighting.scalars(Run::direction(values)));
  }

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if (prepared.is_wide) return draw(literature::VeryWideWalker<Slerp, Base::kCount>(prepared.wide));
    return draw(Walker(prepared.narrow));
  }
};

}  // namespace arcspan
