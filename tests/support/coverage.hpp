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
  /// The interior is where the edge function is positive.
  struct Edge {
    std::int64_t side = -1;     ///< the edge function at a pixel's centre
    std::int64_t step = 0;      ///< what it changes by to the next column
    bool has_its_line = false;  ///< pixels whose centres lie on the edge belong to it
  };

 public:
  CoverageReference(Point a, Point b, Point c) : corner_{a, b, c} {
    area_ = edge(a, b, c);
    if (area_ < 0) {
      corner_[1] = c;
      corner_[2] = b;
    }
  }

  /// The pixels of a row, one after another.
  class Row {
   public:
    /// Is the centre of this pixel covered? Goes on to the next one.
    [[nodiscard]] bool next() {
      bool is_covered = true;
      for (Edge& e : edge_) {
        is_covered = is_covered && (e.side > 0 || (e.side == 0 && e.has_its_line));
        e.side += e.step;
      }
      return is_covered;
    }

   private:
    friend CoverageReference;
    Edge edge_[3];
  };

  /// The row from pixel (column, row) on. Pixel (0, 0) has its centre at (8, 8) sixteenths.
  [[nodiscard]] Row row_from(std::int64_t column, std::int64_t row) const {
    Row pixels;
    if (area_ == 0) return pixels;
    for (int i = 0; i < 3; ++i) {
      const Point p = corner_[i];
      const Point q = corner_[(i + 1) % 3];
      // An edge that runs upwards (y points down) has the interior on its right, and a horizontal one that
      // runs to the right has it below.
      pixels.edge_[i] = {edge(p, q, {16 * column + 8, 16 * row + 8}), -16 * (q.y - p.y),
                         q.y < p.y || (q.y == p.y && q.x > p.x)};
    }
    return pixels;
  }

 private:
  [[nodiscard]] static std::int64_t edge(Point p, Point q, Point at) {
    return (q.x - p.x) * (at.y - p.y) - (q.y - p.y) * (at.x - p.x);
  }

  Point corner_[3];
  std::int64_t area_ = 0;
};

}  // namespace arcspan::test
