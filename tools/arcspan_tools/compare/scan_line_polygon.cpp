// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/scan_line_polygon.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace arcspan::tools {
namespace {

/// A point of a row: where it is, and what is interpolated there.
struct RowPoint {
  double x = 0;
  Vec3 normal;
  double intensity = 0;
};

RowPoint between(const RowPoint& a, const RowPoint& b, double t) {
  return {a.x + t * (b.x - a.x), a.normal + (b.normal - a.normal) * t,
          a.intensity + t * (b.intensity - a.intensity)};
}

RowPoint at_corner(const PolygonCorner& corner) { return {corner.x, corner.normal, corner.normal.z}; }

/// Where the edges of the polygon cross the row at height y, from left to right.
std::vector<RowPoint> crossings(const Quadrilateral& polygon, double y) {
  std::vector<RowPoint> points;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PolygonCorner& a = polygon[i];
    const PolygonCorner& b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= y) == (b.y <= y)) continue;
    points.push_back(between(at_corner(a), at_corner(b), (y - a.y) / (b.y - a.y)));
  }
  std::sort(points.begin(), points.end(), [](const RowPoint& a, const RowPoint& b) { return a.x < b.x; });
  return points;
}

}  // namespace

Quadrilateral concave_polygon() {
  const Vec3 bright{0, 0, 1};
  const Vec3 dark{std::sqrt(0.75), 0, 0.5};
  return {{{0, 0.9, bright}, {-1, -0.8, bright}, {0, 0.1, dark}, {1, -0.8, bright}}};
}

Image draw_by_scan_lines(const Quadrilateral& polygon, ScanLineKind kind, double diffuse, double scale,
                         std::int32_t width, std::int32_t height) {
  Image image(width, height);
  for (std::int32_t row = 0; row < height; ++row) {
    const std::vector<RowPoint> points = crossings(polygon, (height / 2.0 - row - 0.5) / scale);
    for (std::int32_t column = 0; column < width; ++column) {
      const double x = (column + 0.5 - width / 2.0) / scale;
      for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        if (x < points[i].x || x >= points[i + 1].x) continue;
        const RowPoint p =
            between(points[i], points[i + 1], (x - points[i].x) / (points[i + 1].x - points[i].x));
        const double level = kind == ScanLineKind::kGouraud ? p.intensity : normalised(p.normal).z;
        const auto step = static_cast<std::uint8_t>(std::lround(255 * diffuse * level));
        image.at(column, row) = {step, step, step};
      }
    }
  }
  return image;
}

}  // namespace arcspan::tools
