// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/triangulate.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace arcspan::tools {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct Point {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point&, const Point&) = default;
};

/// Twice the area of a triangle, positive if it runs counter-clockwise.
double area(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon seen along the axis that is nearest to its normal, counter-clockwise.
std::vector<Point> projected(std::span<const Vec3> polygon) {
  Vec3 normal;  // Newell's: exact for plane polygons, a mean for others
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    normal = normal + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  const double x = std::fabs(normal.x);
  const double y = std::fabs(normal.y);
  const double z = std::fabs(normal.z);
  std::vector<Point> points;
  for (const Vec3& corner : polygon) {
    const Vec3 p = corner - polygon[0];
    if (z >= x && z >= y) {
      points.push_back({p.x, normal.z < 0 ? -p.y : p.y});
    } else if (y >= x) {
      points.push_back({p.z, normal.y < 0 ? -p.x : p.x});
    } else {
      points.push_back({p.y, normal.x < 0 ? -p.z : p.z});
    }
  }
  return points;
}

/// A corner is an ear if it is convex and no other corner lies in the triangle with its two neighbours, which
/// can then be cut off. Of the others only those that are not convex have to be looked at, and cutting an ear
/// off changes no corners but its neighbours.
class EarClipping {
 public:
  explicit EarClipping(std::vector<Point> points) : points_(std::move(points)) {
    const auto size = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t i = 0; i < size; ++i) {
      previous_.push_back((i + size - 1) % size);
      next_.push_back((i + 1) % size);
    }
    for (std::uint32_t i = 0; i < size; ++i) {
      if (!is_convex(i)) reflex_.push_back(i);
    }
    for (std::uint32_t i = 0; i < size; ++i) ear_.push_back(is_ear(i));
  }

  std::vector<Triangle> triangles() {
    std::vector<Triangle> all;
    std::uint32_t at = 0;
    for (std::size_t left = points_.size(); left > 3; --left) {
      at = chosen_from(at, left);
      all.push_back({previous_[at], at, next_[at]});
      cut_off(at);
      at = next_[at];
    }
    all.push_back({previous_[at], at, next_[at]});
    return all;
  }

 private:
  [[nodiscard]] double area_at(std::uint32_t i) const {
    return area(points_[previous_[i]], points_[i], points_[next_[i]]);
  }
  [[nodiscard]] bool is_convex(std::uint32_t i) const { return area_at(i) > 0; }

  [[nodiscard]] bool is_ear(std::uint32_t i) const {
    if (!is_convex(i)) return false;
    const Point& a = points_[previous_[i]];
    const Point& b = points_[i];
    const Point& c = points_[next_[i]];
    return std::none_of(reflex_.begin(), reflex_.end(), [&](std::uint32_t other) {
      const Point& p = points_[other];
      if (p == a || p == b || p == c) return false;
      return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
    });
  }

  /// The first ear from `at` on. A polygon that crosses itself may have none: then the corner of the largest
  /// triangle.
  [[nodiscard]] std::uint32_t chosen_from(std::uint32_t at, std::size_t left) const {
    std::uint32_t largest = at;
    for (std::size_t i = 0; i < left; ++i, at = next_[at]) {
      if (ear_[at]) return at;
      if (area_at(at) > area_at(largest)) largest = at;
    }
    return largest;
  }

  void cut_off(std::uint32_t i) {
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
    std::erase(reflex_, i);
    for (const std::uint32_t neighbour : {previous_[i], next_[i]}) {
      if (is_convex(neighbour)) std::erase(reflex_, neighbour);
    }
    for (const std::uint32_t neighbour : {previous_[i], next_[i]}) ear_[neighbour] = is_ear(neighbour);
  }

  std::vector<Point> points_;
  std::vector<std::uint32_t> previous_;
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> reflex_;  ///< those that are not convex
  std::vector<bool> ear_;
};

}  // namespace

std::vector<Triangle> triangulated(std::span<const Vec3> polygon) {
  if (polygon.size() == 3) return {{0, 1, 2}};
  std::vector<Point> points = projected(polygon);
  if (polygon.size() > 4) return EarClipping(std::move(points)).triangles();
  // A quad is divided at its corner that is not convex, or at the first.
  std::uint32_t first = 0;
  for (std::uint32_t i = 0; i < 4; ++i) {
    if (area(points[(i + 3) % 4], points[i], points[(i + 1) % 4]) < 0) first = i;
  }
  return {{first, (first + 1) % 4, (first + 2) % 4}, {first, (first + 2) % 4, (first + 3) % 4}};
}

}  // namespace arcspan::tools
