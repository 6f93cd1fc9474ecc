// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/textured/textured.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace arcspan::test {

/// True if the vertices of a textured method have a level of light.
template <class Method>
inline constexpr bool kHasLevel = requires(typename Method::Vertex vertex) {
  vertex.level;
};

/// A triangle on the screen with texture points and distances, and the same in double precision.
template <class Method>
struct MappedTriangle {
  std::array<RasterVertex<Method>, 3> vertices{};

  struct Point {
    double u;
    double v;
    double level;  ///< of light, linear on the screen
  };
  /// u, v and the level at the centre of a pixel, as the vertices determine them.
  [[nodiscard]] Point at(std::int32_t column, std::int32_t row) const {
    const auto x = [this](std::size_t i) { return double{vertices[i].position.x * 1.0}; };
    const auto y = [this](std::size_t i) { return double{vertices[i].position.y * 1.0}; };
    const double px = column * 16 + 8;
    const double py = row * 16 + 8;
    const double area = (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
    const double b = ((px - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (py - y(0))) / area;
    const double c = ((x(1) - x(0)) * (py - y(0)) - (px - x(0)) * (y(1) - y(0))) / area;
    const std::array<double, 3> weight{1 - b - c, b, c};
    double over = 0;
    Point sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      const double w = weight[i] * vertices[i].near_over_w.value;
      over += w;
      sum.u += w * vertices[i].shade.point.u / 65536;
      sum.v += w * vertices[i].shade.point.v / 65536;
      if constexpr (kHasLevel<Method>) sum.level += weight[i] * vertices[i].shade.level / 1024;
    }
    return {sum.u / over, sum.v / over, sum.level};
  }
};

/// A triangle of a picture of `size` pixels whose nearest vertex is at most `ratio` times as near as its
/// farthest, and that shows up to `range` repetitions.
template <class Method>
MappedTriangle<Method> random_triangle(Random& random, std::int32_t size, double ratio, double range) {
  MappedTriangle<Method> triangle;
  const double farthest = 1 / random.decades(1, ratio);
  std::array<double, 3> nearness{1, farthest, random.decades(farthest, 1)};
  std::swap(nearness[0], nearness[static_cast<std::size_t>(random.integer(0, 2))]);
  const double scale = random.decades(1e5, 5e8);
  const double u = random.real(-4, 4);
  const double v = random.real(-4, 4);
  for (std::size_t i = 0; i < 3; ++i) {
    RasterVertex<Method>& vertex = triangle.vertices[i];
    vertex.position = {static_cast<std::int16_t>(random.integer(-8 * size, 8 * size)),
                       static_cast<std::int16_t>(random.integer(-8 * size, 8 * size)), 1000};
    vertex.shade.point = {static_cast<std::int32_t>((u + random.real(-range, range) / 2) * 65536),
                          static_cast<std::int32_t>((v + random.real(-range, range) / 2) * 65536)};
    vertex.near_over_w.value = static_cast<std::int32_t>(nearness[i] * scale);
    if constexpr (kHasLevel<Method>) {
      // Black and white are the levels that rounding errors might leave.
      vertex.shade.level = std::clamp(random.integer(-30000, 95280), 0, 65280);
    }
  }
  return triangle;
}

/// Maps a texture on the plane of a triangle, turned by a random angle, so that texels have the same size
/// everywhere, as most models have them. The vertices are up to `range` repetitions from the first one.
template <class Method>
void map_plane(Random& random, double range, MappedTriangle<Method>& triangle) {
  using Complex = std::complex<double>;
  // In space, before a camera of 240 pixels focal length: w, and x and y as one number.
  std::array<double, 3> w{};
  std::array<Complex, 3> xy{};
  for (std::size_t i = 0; i < 3; ++i) {
    const RasterVertex<Method>& vertex = triangle.vertices[i];
    w[i] = 1e6 / vertex.near_over_w.value;
    xy[i] = Complex(vertex.position.x, vertex.position.y) * (w[i] / (16 * 240));
  }
  // In the plane: the first side, and the second one relative to its direction.
  const auto product = [&](std::size_t i, std::size_t j) {
    return std::real(std::conj(xy[i] - xy[0]) * (xy[j] - xy[0])) + (w[i] - w[0]) * (w[j] - w[0]);
  };
  const double side = std::sqrt(product(1, 1));
  if (side == 0) return;  // it has no area
  const double along = product(1, 2) / side;
  std::array<Complex, 3> at{0, side, {along, std::sqrt(std::max(0.0, product(2, 2) - along * along))}};
  const Complex turn =
      std::polar(range / std::max(std::abs(at[1]), std::abs(at[2])), random.real(-3.1416, 3.1416));
  for (std::size_t i = 0; i < 3; ++i) {
    at[i] *= turn * 65536.0;
    triangle.vertices[i].shade.point = {static_cast<std::int32_t>(at[i].real()),
                                        static_cast<std::int32_t>(at[i].imag())};
  }
}

/// Calls `visit(column, row, pixel)` for every pixel of a small triangle. Does nothing if the method does not
/// draw it as one.
template <class Method, class Visit>
void for_each_small_pixel(const MappedTriangle<Method>& mapped, const typename Method::Lighting& lighting,
                          std::int32_t size, Visit visit) {
  SortedVertices<Method> vertices{&mapped.vertices[0], &mapped.vertices[1], &mapped.vertices[2], false};
  const std::int32_t area =
      doubled_area(vertices.top->position, vertices.middle->position, vertices.bottom->position);
  if (area == 0 || !is_small(vertices)) return;
  vertices.middle_left = area < 0;
  detail::sort_by_height(vertices);
  SmallTriangle triangle;
  const auto& [top, middle, bottom, middle_left] = vertices;
  if (!is_small(vertices) || !cover_small_triangle(top->position, middle->position, bottom->position,
                                                   middle_left, {-size, size}, triangle)) {
    return;
  }
  prepare_small_triangle(top->position, middle->position, bottom->position, triangle);
  typename Method::Small small;
  if (!Method::prepare_small(lighting, *top, *middle, *bottom, {}, triangle, small)) return;
  const Status status = Method::walk_small(small, [&](const auto& rows) {
    for (std::int32_t row = 0; row < triangle.rows; ++row) {
      const SmallSpan span = triangle.spans[row];
      if (span.count <= 0) continue;
      auto pixel = rows.row(0, triangle.coordinate(triangle.of_middle(span.first, row)),
                            triangle.coordinate(triangle.of_bottom(span.first, row)));
      for (std::int32_t x = 0; x < span.count; ++x, pixel.next())
        visit(span.first + x, triangle.row + row, pixel);
    }
    return Status::kOk;
  });
  REQUIRE(status == Status::kOk);
}

/// Calls `visit(column, row, pixel)` for every pixel of a triangle, and again for one that is drawn as a
/// small one.
template <class Method, class Visit>
void for_each_pixel(const MappedTriangle<Method>& triangle, const typename Method::Lighting& lighting,
                    std::int32_t size, Visit visit) {
  if constexpr (DrawsSmallTriangles<Method>) for_each_small_pixel(triangle, lighting, size, visit);
  TriangleCommand<Method> command;
  const auto& [a, b, c] = triangle.vertices;
  if (!prepare_triangle<Method>(lighting, a, b, c, {}, RowRange{-size, size}, command)) return;
  command.move_columns(size);  // columns of a picture are not negative
  const Status status = Method::walk(command.shade, [&](auto walker) {
    for (std::int32_t row = command.first_row; row < command.end_row; ++row) {
      if (row == command.middle_row) {
        (command.middle_left ? command.left : command.right) = command.lower;
        walker.enter_lower();
      }
      const std::int32_t end = command.right.column();
      std::int32_t column = command.left.column();
      if (column < end) {
        auto run = walker.row(row_start(command.unit, command.left, command.right, 0, column));
        while (column < end) {
          std::int32_t count = end - column;
          count = run.enter(lighting, count);
          for (; count > 0; --count, ++column, run.next()) visit(column - size, row, run);
        }
      }
      command.left.advance();
      command.right.advance();
      walker.next_row();
    }
    return Status::kOk;
  });
  REQUIRE(status == Status::kOk);
}

}  // namespace arcspan::test
