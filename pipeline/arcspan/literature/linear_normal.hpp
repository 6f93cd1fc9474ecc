// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/root.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/shading/method.hpp>

#include <cstdint>

namespace arcspan {

/// A cosine or component with 15 fraction bits as a linear attribute: saturated below 1 in magnitude, so that
/// any difference of two fits the 16 bits and sign of a LinearPlane.
[[nodiscard]] constexpr std::int32_t as_attribute(std::int32_t raw15) {
  return raw15 > 32767 ? 32767 : raw15 < -32767 ? -32767 : raw15;
}

/// sqrt(v) rounded to nearest, exact for every v.
[[nodiscard]] constexpr std::uint32_t nearest_root(std::uint32_t v) {
  const std::uint32_t root = integer_root(v);
  return root + static_cast<std::uint32_t>(v - root * root > root);
}

/// The unit vector along a (1 - t) + b t, t in 0...1. The linear methods cut edges with it.
[[nodiscard]] inline Direction between_normalised(const Direction& a, const Direction& b, Factor t) {
  const auto mix = [t](DirectionComponent from, DirectionComponent to) {
    return from.raw() + round_shift(wrap_mul(to.raw() - from.raw(), t.raw() >> 1), 14);
  };
  return normalised(mix(a.x, b.x), mix(a.y, b.y), mix(a.z, b.z));
}

/// A normal that is linear along a row, not of unit length. A Linear of a component with 15 fraction bits has
/// 27 fraction bits in all.
struct LinearNormal {
  Linear x;
  Linear y;
  Linear z;

  constexpr void advance(const LinearNormal& step) {
    x += step.x;
    y += step.y;
    z += step.z;
  }
};

/// A normal that is linear on the screen.
struct NormalPlane {
  LinearPlane x;
  LinearPlane y;
  LinearPlane z;

  [[nodiscard]] constexpr LinearNormal at(const RowStart& start) const {
    return {linear_at(x, start), linear_at(y, start), linear_at(z, start)};
  }
  [[nodiscard]] constexpr LinearNormal step() const { return {x.dx, y.dx, z.dx}; }
  constexpr void next_row() {
    x.next_row();
    y.next_row();
    z.next_row();
  }
  constexpr void enter_lower(bool middle_left) {
    x.enter_lower(middle_left);
    y.enter_lower(middle_left);
    z.enter_lower(middle_left);
  }
};

/// The normal that is linear on the screen and has these values at the vertices of a triangle.
template <class Method>
constexpr void make_normal_plane(const TriangleFrame<Method>& frame, const Direction& top,
                                 const Direction& middle, const Direction& bottom, NormalPlane& normal) {
  const auto make = [&frame](DirectionComponent a, DirectionComponent b, DirectionComponent c,
                             LinearPlane& plane) {
    make_linear_plane(frame, as_attribute(a.raw()), as_attribute(b.raw()), as_attribute(c.raw()), plane);
  };
  make(top.x, middle.x, bottom.x, normal.x);
  make(top.y, middle.y, bottom.y, normal.y);
  make(top.z, middle.z, bottom.z, normal.z);
}

}  // namespace arcspan
