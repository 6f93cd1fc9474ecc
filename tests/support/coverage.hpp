// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace arcspan::test {

/// A point in 16ths of a pixel.
struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// Exact coverage of pixel centres by the top-left rule, from the edge equations in 64-bit integers.
class CoverageReference {
 public:
  CoverageReference(Point a, Point b, Point c) : corner_{a, b, c} {
    area_ = edge(a, b, c);
    if (area_ < 0) {
      corner_[1] = c;
      corner_[2] = b;
    }
  }

  /// Is the centre of pixel (column, row) covered? Pixel (0, 0) has its centre at (8, 8) sixteenths.
  [[nodiscard]] bool operator()(std::int64_t column, std::int64_t row) const {
    if (area_ == 0) return false;
    const Point centre{16 * column + 8, 16 * row + 8};
    return inside(corner_[0], corner_[1], centre) && inside(corner_[1], corner_[2], centre) &&
           inside(corner_[2], corner_[0], centre);
  }

 private:
  [[nodiscard]] static std::int64_t edge(Point p, Point q, Point at) {
    return (q.x - p.x) * (at.y - p.y) - (q.y - p.y) * (at.x - p.x);
  }
  /// The interior is where the edge function is positive. Then an edge that runs upwards (y points down) has
  /// the interior on its right, and a horizontal one that runs to the right has it below.
  [[nodiscard]] static bool inside(Point p, Point q, Point at) {
    const std::int64_t side = edge(p, q, at);
    if (side != 0) return side > 0;
    return q.y < p.y || (q.y == p.y && q.x > p.x);
  }

  Point corner_[3];
  std::int64_t area_ = 0;
};

}  // namespace arcspan::test
