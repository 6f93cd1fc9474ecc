// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <tests/support/method_accuracy.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/run_list.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

/// How far `Arc` is from classic Phong shading in double precision, pixel by pixel.
namespace arcspan::test {

/// An illumination of one light that writes down the pixels it colours.
template <Highlight Model>
struct RecordedLight : Illumination<1, Model> {
  using Base = Illumination<1, Model>;
  using Scalars = typename Base::Scalars;
  struct Pixel {
    Cosine light;
    double highlight;  ///< in 8-bit steps
  };

  [[nodiscard]] PackedRgb surface_colour(const Scalars& scalars) const {
    const PackedRgb highlight = Base::surface_light(scalars).highlight;
    pixels->push_back({scalars[0], static_cast<double>(highlight.lanes & 1023u) / 4});
    return {};
  }
  [[nodiscard]] PixelLight surface_light(const Scalars& scalars) const {
    return {surface_colour(scalars), {}};
  }
  [[nodiscard]] PackedRgb diffuse_colour(Cosine scalar) const {
    pixels->push_back({scalar, 0});
    return {};
  }

  std::vector<Pixel>* pixels = nullptr;
};

/// A triangle on the screen with the light that falls on it. Normals are as long as their vertices have them.
struct SurfaceCase {
  std::array<Point, 3> points{};
  std::array<Direction, 3> normals{};
  Direction to_light;
  Direction to_eye;
  std::int32_t shininess = 16;
  std::int32_t tolerance = 0;
  bool by_commands = false;  ///< not by the raster for small triangles
  Rect window{0, 0, 2048, 2048};

  [[nodiscard]] std::string text() const {
    char line[300];
    std::snprintf(
        line, sizeof line,
        "points (%lld %lld) (%lld %lld) (%lld %lld), normals (%d %d %d) (%d %d %d) (%d %d %d), light (%d %d "
        "%d), eye (%d %d %d), n %d, tolerance %d, %s",
        static_cast<long long>(points[0].x), static_cast<long long>(points[0].y),
        static_cast<long long>(points[1].x), static_cast<long long>(points[1].y),
        static_cast<long long>(points[2].x), static_cast<long long>(points[2].y), normals[0].x.raw(),
        normals[0].y.raw(), normals[0].z.raw(), normals[1].x.raw(), normals[1].y.raw(), normals[1].z.raw(),
        normals[2].x.raw(), normals[2].y.raw(), normals[2].z.raw(), to_light.x.raw(), to_light.y.raw(),
        to_light.z.raw(), to_eye.x.raw(), to_eye.y.raw(), to_eye.z.raw(), shininess, tolerance,
        by_commands ? "command" : "any raster");
    return line;
  }
};

/// Counts errors in bins of 1/64 of an 8-bit step.
class ErrorBins {
 public:
  void add(double error) { ++bins_[std::min(static_cast<std::size_t>(error * 64), bins_.size() - 1)]; }
  /// Returns the error that 99.9 % of all errors do not exceed.
  [[nodiscard]] double nearly_all() const {
    std::uint64_t count = 0;
    for (const std::uint64_t bin : bins_) count += bin;
    std::uint64_t beyond = 0;
    std::size_t bin = bins_.size();
    while (bin > 0 && (beyond + bins_[bin - 1]) * 1000 <= count) beyond += bins_[--bin];
    return static_cast<double>(bin) / 64;
  }

 private:
  std::vector<std::uint64_t> bins_ = std::vector<std::uint64_t>(256 * 64);
};

/// The errors of many pixels in 8-bit steps, and how many exceed the limits.
struct SurfaceErrors {
  double light_limit = 0.2;  ///< 99.9 % of the pixels may be off by no more
  double highlight_limit = 3;
  std::uint64_t pixels = 0;
  std::uint64_t light_beyond = 0;
  std::uint64_t highlight_beyond = 0;
  double light = 0;
  double highlight = 0;
  ErrorBins light_bins;
  ErrorBins highlight_bins;
  std::string light_case;
  std::string highlight_case;
  std::uint64_t missing = 0;  ///< pixels that were not recorded

  [[nodiscard]] double light_share() const { return share(light_beyond); }
  [[nodiscard]] double highlight_share() const { return share(highlight_beyond); }

 private:
  [[nodiscard]] double share(std::uint64_t part) const {
    return pixels == 0 ? 0 : static_cast<double>(part) / static_cast<double>(pixels);
  }
};

/// Draws triangles by `Arc` and compares their pixels with Phong's.
template <Highlight Model>
class SurfaceMeasurement {
 public:
  using Light = RecordedLight<Model>;
  using Method = Arc<Light>;
  using Vertex = RasterVertex<Method>;

  SurfaceErrors errors;
  double most_light = 0;  ///< the largest magnitude of N·L
  /// White light, diffuse and specular.
  Material material{.ambient = {},
                    .diffuse = {Coefficient::of(1.0), Coefficient::of(1.0), Coefficient::of(1.0)},
                    .specular = {Coefficient::of(1.0), Coefficient::of(1.0), Coefficient::of(1.0)}};

  /// Sets up the light of a case and returns its vertices.
  [[nodiscard]] std::array<Vertex, 3> set_up(const SurfaceCase& c) {
    material.shininess = c.shininess;
    if (!ok(Light::Base::make(material, {DirectionalLight{c.to_light}}, c.to_eye, light_))) ++errors.missing;
    if (!ok(light_.set_tolerance(c.tolerance))) ++errors.missing;
    light_.pixels = &pixels_;
    std::array<Vertex, 3> v;
    for (std::size_t i = 0; i < 3; ++i) {
      v[i].position = {static_cast<std::int16_t>(c.points[i].x), static_cast<std::int16_t>(c.points[i].y),
                       1000};
      v[i].shade = Method::shade_vertex(light_, c.normals[i]);
    }
    return v;
  }
  void measure(const SurfaceCase& c) {
    const std::array<Vertex, 3> v = set_up(c);
    const auto normal = [&](std::size_t i) { return to_vec3(c.normals[i]); };
    compare(c, v, {normal(0), normal(1), normal(2)});
  }

  /// Draws the vertices, whose linear normals are `normals`, with the light of the last set_up().
  void compare(const SurfaceCase& c, const std::array<Vertex, 3>& v, const std::array<Vec3, 3>& normals) {
    pixels_.clear();
    runs_.runs.clear();
    RasterStage<Method, RunList> stage(runs_, kPicture, kPicture, light_);
    stage.clip_to(c.window);
    if (c.by_commands) stage.leave_out_small_triangles();
    stage.draw(v[0], v[1], v[2]);
    ShadedTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.corner[i] = {{v[i].position.x, v[i].position.y}, normals[i]};
    }
    const UnitLinearModel model(triangle);
    const Vec3 light = to_vec3(c.to_light);
    const Vec3 eye = to_vec3(c.to_eye);
    const Vec3 half = to_vec3(half_way(c.to_light, c.to_eye));
    std::size_t next = 0;
    for (const Span& run : runs_.runs) {
      for (std::int32_t x = run.x; x < run.x + run.count; ++x) {
        if (next == pixels_.size()) {
          ++errors.missing;
          return;
        }
        const Vec3 n = model.at(x - kPicture / 2, run.y - kPicture / 2);
        const double cosine =
            Model == Highlight::kBlinn ? dot(n, half) : 2 * dot(n, light) * dot(n, eye) - dot(light, eye);
        add(c, pixels_[next++], dot(n, light), cosine);
      }
    }
    errors.missing += pixels_.size() - next;
  }
  [[nodiscard]] const Light& light() const { return light_; }

  static constexpr std::int32_t kPicture = 2048;

 private:
  void add(const SurfaceCase& c, const typename Light::Pixel& pixel, double light, double cosine) {
    const double of_light =
        255 * std::abs(std::clamp(to_double(pixel.light), 0.0, 1.0) - std::clamp(light, 0.0, 1.0));
    const double highlight = 255 * std::pow(std::clamp(cosine, 0.0, 1.0), c.shininess);
    double of_highlight = std::abs(pixel.highlight - (light > 0 ? highlight : 0));
    // Highlights end abruptly at N·L = 0, where either side is right.
    if (std::abs(light) < 1.0 / 255)
      of_highlight = std::min(pixel.highlight, std::abs(pixel.highlight - highlight));
    most_light = std::max(most_light, std::abs(to_double(pixel.light)));
    ++errors.pixels;
    errors.light_bins.add(of_light);
    errors.highlight_bins.add(of_highlight);
    if (of_light > errors.light_limit) ++errors.light_beyond;
    if (of_highlight > errors.highlight_limit) ++errors.highlight_beyond;
    if (of_light > errors.light) {
      errors.light = of_light;
      errors.light_case = c.text();
    }
    if (of_highlight > errors.highlight) {
      errors.highlight = of_highlight;
      errors.highlight_case = c.text();
    }
  }

  Light light_;
  RunList runs_{Rect{0, 0, kPicture, kPicture}};
  std::vector<typename Light::Pixel> pixels_;
};

/// The shapes of random_surface().
struct SurfaceShapes {
  double smallest = 3;  ///< pixels, uniform in their logarithm
  double largest = 1000;
  double from_degrees = 0;  ///< the widest angle between two normals
  double to_degrees = 60;
  double slivers = 0.25;  ///< the share of triangles 1/16...1 pixel thin
};

/// A triangle with a light of random direction; most highlights are put where the triangle is.
[[nodiscard]] inline SurfaceCase random_surface(Random& random, const SurfaceShapes& shapes) {
  SurfaceCase c;
  const double angle = random.real(shapes.from_degrees, shapes.to_degrees);
  const Vec3 middle = random_unit(random);
  double widest = 0;
  std::array<Vec3, 3> normals;
  do {
    for (Vec3& n : normals) n = tilted(random, middle, radians(random.real(0, 0.58) * angle));
    widest = degrees(std::max({angle_between(normals[0], normals[1]), angle_between(normals[1], normals[2]),
                               angle_between(normals[2], normals[0])}));
  } while (widest > angle || widest < 0.7 * angle);
  for (std::size_t i = 0; i < 3; ++i) c.normals[i] = detail::packed(normals[i]);

  const double size = random.decades(shapes.smallest, shapes.largest);
  const double turn = random.real(0, 2 * std::numbers::pi);
  const double thin =
      random.chance(shapes.slivers) ? random.decades(1.0 / 16, 1.5) : random.decades(0.1, 1) * size;
  const bool upright = random.chance(0.3);
  const double dx = upright ? std::round(std::cos(turn)) : std::cos(turn);
  const double dy = upright ? std::round(std::sin(turn)) : std::sin(turn);
  const double norm = std::hypot(dx, dy);
  const double room = 1000 - size;
  const double x = random.real(-room, room);
  const double y = random.real(-room, room);
  const double along[3] = {-size / 2, random.real(-size / 2, size / 2), size / 2};
  const double across[3] = {random.real(0, 0.1) * thin, thin, random.real(0, 0.1) * thin};
  double left = 2048;
  double top = 2048;
  double right = 0;
  double bottom = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double px = x + (along[i] * dx - across[i] * dy) / norm;
    const double py = y + (along[i] * dy + across[i] * dx) / norm;
    c.points[i] = {std::llround(16 * px), std::llround(16 * py)};
    left = std::min(left, px + 1024);
    right = std::max(right, px + 1024);
    top = std::min(top, py + 1024);
    bottom = std::max(bottom, py + 1024);
  }
  // Large triangles are compared in a few whole rows, or in a small square, to save time.
  if (size > 60 && thin > 4) {
    const auto row = static_cast<std::int32_t>(random.real(top, bottom));
    const auto column = static_cast<std::int32_t>(random.real(left, right));
    c.window = random.chance(0.5) ? Rect{0, row, 2048, row + 4} : Rect{column, row, column + 40, row + 40};
    c.window.bottom = std::min(c.window.bottom, 2048);
    c.window.right = std::min(c.window.right, 2048);
  }
  const Vec3 near = normalised(normals[0] + random.unit() * normals[1] + random.unit() * normals[2]);
  Vec3 light = random_unit(random);
  Vec3 eye = random_unit(random);
  if (random.chance(0.7)) {
    const Vec3 half = tilted(random, near, radians(random.real(0, 20)));
    eye = tilted(random, half, radians(random.real(0, 70)));
    light = 2 * dot(half, eye) * half - eye;
  }
  c.to_light = to_direction(light);
  c.to_eye = to_direction(eye);
  if (dot(light, eye) < -0.85) c.to_eye = c.to_light;  // opposite ones have no direction half-way
  c.by_commands = random.chance(0.3);
  return c;
}

}  // namespace arcspan::test
