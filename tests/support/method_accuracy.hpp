// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/packed_normal.hpp>

#include <tests/support/accuracy.hpp>
#include <tests/support/probed_methods.hpp>
#include <tests/support/slerp_oracle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace arcspan::test {

/// A triangle with normals as a method gets it: the packed ones, not those they were made from.
struct ShadedTriangle {
  std::array<TriangleOracle::Corner, 3> corner;
};

/// Double model of the linear methods: the normal by barycentric coordinates, not of unit length.
class LinearNormalModel {
 public:
  explicit LinearNormalModel(const ShadedTriangle& triangle) : t_(triangle) {}
  [[nodiscard]] Vec3 at(std::int64_t column, std::int64_t row) const {
    const auto x = static_cast<double>(16 * column + 8);
    const auto y = static_cast<double>(16 * row + 8);
    Vec3 sum;
    double area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& p = t_.corner[(i + 1) % 3].point;
      const Point& q = t_.corner[(i + 2) % 3].point;
      const double weight = static_cast<double>(q.x - p.x) * (y - static_cast<double>(p.y)) -
                            static_cast<double>(q.y - p.y) * (x - static_cast<double>(p.x));
      sum = sum + weight * t_.corner[i].normal;
      area += weight;
    }
    return (1 / area) * sum;
  }

 private:
  ShadedTriangle t_;
};

/// Phong, Duff: linear, then divided by the length.
struct UnitLinearModel : LinearNormalModel {
  using LinearNormalModel::LinearNormalModel;
  [[nodiscard]] Vec3 at(std::int64_t column, std::int64_t row) const {
    return normalised(LinearNormalModel::at(column, row));
  }
};

/// Lyon: linear, then times 1 - e/2 + 3/8 e^2 with e = N·N - 1.
struct TaylorModel : LinearNormalModel {
  using LinearNormalModel::LinearNormalModel;
  [[nodiscard]] Vec3 at(std::int64_t column, std::int64_t row) const {
    const Vec3 n = LinearNormalModel::at(column, row);
    const double e = dot(n, n) - 1;
    return (1 - e / 2 + 0.375 * e * e) * n;
  }
};

/// Bilinear SLERP, S0 eq. 2. Pixels are asked for row by row, so that a row's ends are computed once.
class SlerpModel {
 public:
  explicit SlerpModel(const ShadedTriangle& t) : oracle_(t.corner[0], t.corner[1], t.corner[2]) {}
  [[nodiscard]] Vec3 at(std::int64_t column, std::int64_t row) const {
    if (!last_ || last_number_ != row) last_ = oracle_.row(last_number_ = row);
    return last_->at(column);
  }

 private:
  TriangleOracle oracle_;
  mutable std::optional<TriangleOracle::Row> last_;
  mutable std::int64_t last_number_ = 0;
};

struct MethodTask {
  double from_degrees = 0;  ///< between two normals of a triangle, at most and at least for its widest pair
  double to_degrees = 0;
  double smallest = 1;  ///< pixels
  double largest = 120;
  int triangles = 0;
  std::uint64_t seed = 1;
};

struct MethodFigures {
  ErrorFigure normal_light;
  ErrorFigure normal_half;
  ErrorFigure slivers;  ///< N·L in triangles less than a pixel thin, where 16 bits of a distance say little
  std::uint64_t missing = 0;
};

namespace detail {

[[nodiscard]] inline Direction packed(Vec3 n) {
  const auto big = [](double v) { return static_cast<std::int32_t>(std::lround(v * (1 << 28))); };
  return unpack_normal(pack_normal(big(n.x), big(n.y), big(n.z)));
}

/// Three normals whose widest pair is `angle` apart or nearly so; none zero, points in sixteenths of a pixel.
[[nodiscard]] inline ShadedTriangle random_triangle(Random& random, double angle, double size) {
  ShadedTriangle t;
  const Vec3 middle = random_unit(random);
  const double x = random.real(-800, 800);
  const double y = random.real(-800, 800);
  double widest = 0;
  do {
    for (auto& corner : t.corner) corner.normal = tilted(random, middle, random.real(0, 0.58) * angle);
    widest = std::max({angle_between(t.corner[0].normal, t.corner[1].normal),
                       angle_between(t.corner[1].normal, t.corner[2].normal),
                       angle_between(t.corner[2].normal, t.corner[0].normal)});
  } while (widest > angle || widest < 0.7 * angle);
  for (auto& corner : t.corner) {
    const auto snapped = [](double v) { return std::clamp<std::int64_t>(std::llround(v), -4096, 4095); };
    corner.point = {snapped(x + 16 * random.real(-size, size)), snapped(y + 16 * random.real(-size, size))};
  }
  return t;
}

/// Smallest height in pixels.
[[nodiscard]] inline double thickness(const ShadedTriangle& t) {
  const auto side = [&t](std::size_t i, std::size_t k) {
    const Point& p = t.corner[i].point;
    const Point& q = t.corner[k].point;
    return Vec3{static_cast<double>(q.x - p.x) / 16, static_cast<double>(q.y - p.y) / 16, 0};
  };
  const double area = length(cross(side(0, 1), side(0, 2)));
  return area / std::max({length(side(0, 1)), length(side(1, 2)), length(side(2, 0)), 1e-9});
}

}  // namespace detail

/// Draws random triangles by a probed method and compares N·L and N·H of every pixel with `Model`, which gets
/// the very normals that the method gets: what is measured is the method's own integer arithmetic.
template <class Model>
[[nodiscard]] MethodFigures measure_method(DrawProbed draw, const MethodTask& task) {
  constexpr std::int32_t kPicture = 512;
  Random random(task.seed);
  MethodFigures figures;
  std::vector<ProbeSample> samples;
  RunList runs({0, 0, kPicture, kPicture});
  Probe::Blinn blinn;
  Probe::Phong phong;
  for (int i = 0; i < task.triangles; ++i) {
    const double angle = radians(random.real(task.from_degrees, task.to_degrees));
    ShadedTriangle triangle =
        detail::random_triangle(random, angle, random.decades(task.smallest, task.largest));
    samples.clear();
    runs.runs.clear();
    Probe probe;
    probe.samples = &samples;
    probe.matt = &blinn;
    probe.blinn = &blinn;
    probe.phong = &phong;
    for (Direction& axis : probe.axes) axis = to_direction(random_unit(random));
    ProbedTriangle probed;
    for (std::size_t k = 0; k < 3; ++k) {
      auto& corner = triangle.corner[k];
      probed.normals[k] = detail::packed(corner.normal);
      corner.normal = normalised(to_vec3(probed.normals[k]));
      probed.points[k].x = static_cast<std::int16_t>(corner.point.x);
      probed.points[k].y = static_cast<std::int16_t>(corner.point.y);
    }
    draw(probed, probe, runs);
    const Model model(triangle);
    const bool thin = detail::thickness(triangle) < 1;
    std::size_t next = 0;
    for (const Span& run : runs.runs) {
      for (std::int32_t x = run.x; x < run.x + run.count; ++x) {
        if (next == samples.size()) {
          ++figures.missing;
          break;
        }
        const ProbeSample& sample = samples[next++];
        const Vec3 normal = model.at(x - kPicture / 2, run.y - kPicture / 2);
        const double light = to_double(sample.scalars[0]) - dot(normal, to_vec3(probe.axes[0]));
        if (thin) {
          figures.slivers.add(light);
          continue;
        }
        figures.normal_light.add(light);
        figures.normal_half.add(to_double(sample.scalars[1]) - dot(normal, to_vec3(probe.axes[1])));
      }
    }
    figures.missing += samples.size() - next;
  }
  return figures;
}

}  // namespace arcspan::test
