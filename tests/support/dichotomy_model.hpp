// SPDX-License-Identifier: MIT
#pragma once

#include <tests/support/method_accuracy.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace arcspan::test {

inline constexpr double k45Degrees = 0.78539816339744831;

/// 1/sqrt(4 - s) by the polynomials of dichotomy.hpp, in double precision.
[[nodiscard]] inline double linear_root(double s) { return 0.5 + 0.0688625867 * s; }
[[nodiscard]] inline double quadratic_root(double s) { return 0.5 + s * (0.0620584825 + 0.0140394938 * s); }
[[nodiscard]] inline double cubic_root(double s) {
  return 0.5 + s * (0.0625262157 + s * (0.0114552316 + 0.0031711712 * s));
}
[[nodiscard]] inline double exact_root(double s) { return 1 / std::sqrt(4 - s); }
/// S3's own, in z = 2 - s.
[[nodiscard]] inline double printed_linear_root(double s) { return 0.64 - 0.07 * (2 - s); }
[[nodiscard]] inline double printed_quadratic_root(double s) {
  return 0.681 - 0.119 * (2 - s) + 0.014 * (2 - s) * (2 - s);
}

/// The dichotomy of a triangle's rows in double precision, by the same polynomial and the same segments.
/// `FullLast` gives a row's last segment full length.
template <double (*P)(double), int SegmentBits, bool FullLast = false>
class DichotomyModel {
 public:
  explicit DichotomyModel(const ShadedTriangle& triangle) : phong_(triangle), corner_(triangle.corner) {
    std::sort(corner_.begin(), corner_.end(),
              [](const auto& a, const auto& b) { return a.point.y < b.point.y; });
  }
  [[nodiscard]] Vec3 at(std::int64_t column, std::int64_t row) const {
    const std::int64_t y = 16 * row + 8;
    const bool upper = y < corner_[1].point.y;
    const std::int64_t a = column_at(corner_[0].point, corner_[2].point, y);
    const std::int64_t b = upper ? column_at(corner_[0].point, corner_[1].point, y)
                                 : column_at(corner_[1].point, corner_[2].point, y);
    const std::int64_t first = std::min(a, b);
    const std::int64_t base = column - (column - first) % kSegment;
    std::int64_t length = kSegment;
    while (!FullLast && length / 2 >= std::max(a, b) - 1 - base && length > 0) length /= 2;
    const Vec3 left = phong_.at(base, row);
    if (column == base) return left;
    const Vec3 right = phong_.at(base + length, row);
    if (angle_between(left, right) > k45Degrees) return phong_.at(column, row);
    return halved(left, right, 2 - 2 * dot(left, right), column - base, length);
  }

 private:
  static constexpr std::int64_t kSegment = 1 << SegmentBits;

  /// The first column whose centre is not left of an edge, exactly.
  [[nodiscard]] static std::int64_t column_at(const Point& top, const Point& bottom, std::int64_t y) {
    const std::int64_t height = bottom.y - top.y;
    const std::int64_t beyond = (top.x - 8) * height + (y - top.y) * (bottom.x - top.x);
    const std::int64_t unit = 16 * height;
    return beyond >= 0 ? (beyond + unit - 1) / unit : -(-beyond / unit);
  }
  [[nodiscard]] static Vec3 halved(Vec3 left, Vec3 right, double s, std::int64_t at, std::int64_t length) {
    if (at == 0) return left;
    if (at == length) return right;
    const Vec3 middle = P(s) * (left + right);
    const double half = 2 - (4 - s) * P(s);
    if (2 * at <= length) return halved(left, middle, half, at, length / 2);
    return halved(middle, right, half, at - length / 2, length / 2);
  }

  UnitLinearModel phong_;
  std::array<TriangleOracle::Corner, 3> corner_;
};

}  // namespace arcspan::test
