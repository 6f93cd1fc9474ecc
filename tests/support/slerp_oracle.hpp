// SPDX-License-Identifier: MIT
#pragma once

#include <tests/support/coverage.hpp>
#include <tests/support/vec3.hpp>

#include <algorithm>

namespace arcspan::test {

/// S0 eq. 2, the definition: the unit vector at the fraction t of the great circle from a to b.
class Slerp {
 public:
  Slerp(Vec3 a, Vec3 b) : a_(a), b_(b), angle_(angle_between(a, b)), sine_(std::sin(angle_)) {}

  [[nodiscard]] Vec3 operator()(double t) const {
    if (angle_ < 1e-9) return normalised((1 - t) * a_ + t * b_);
    return (std::sin((1 - t) * angle_) / sine_) * a_ + (std::sin(t * angle_) / sine_) * b_;
  }

 private:
  Vec3 a_;
  Vec3 b_;
  double angle_;
  double sine_;
};

/// Bilinear SLERP over a triangle on the screen: along the edges by the row centre's exact fraction, then
/// along the row by the pixel centre's exact fraction.
class TriangleOracle {
 public:
  struct Corner {
    Point point;
    Vec3 normal;
  };
  /// One row: the ends on the left and right edge.
  struct Row {
    double left = 0;
    double right = 0;
    Slerp arc;

    /// The normal at the centre of a pixel in this row.
    [[nodiscard]] Vec3 at(std::int64_t column) const {
      return arc((16.0 * static_cast<double>(column) + 8 - left) / (right - left));
    }
  };

  TriangleOracle(Corner a, Corner b, Corner c) : corner_{a, b, c} {
    std::sort(corner_, corner_ + 3, [](const Corner& p, const Corner& q) { return p.point.y < q.point.y; });
  }

  /// The row whose centre is at 16 row + 8, which must be in top ... bottom - 1.
  [[nodiscard]] Row row(std::int64_t row) const {
    const auto y = static_cast<double>(16 * row + 8);
    const bool upper = 16 * row + 8 < corner_[1].point.y;
    const End far = end(corner_[0], corner_[2], y);
    const End near = upper ? end(corner_[0], corner_[1], y) : end(corner_[1], corner_[2], y);
    if (far.x <= near.x) return {far.x, near.x, Slerp(far.normal, near.normal)};
    return {near.x, far.x, Slerp(near.normal, far.normal)};
  }

 private:
  struct End {
    double x;
    Vec3 normal;
  };
  [[nodiscard]] static End end(const Corner& top, const Corner& bottom, double y) {
    const double t =
        (y - static_cast<double>(top.point.y)) / static_cast<double>(bottom.point.y - top.point.y);
    const auto x0 = static_cast<double>(top.point.x);
    return {x0 + t * (static_cast<double>(bottom.point.x) - x0), Slerp(top.normal, bottom.normal)(t)};
  }

  Corner corner_[3];
};

}  // namespace arcspan::test
