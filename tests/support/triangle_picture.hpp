// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb888.hpp>

#include <tests/support/method_accuracy.hpp>
#include <tests/support/raster_stage.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

namespace arcspan::test {

/// A triangle on the screen with a normal per corner.
struct ScreenTriangle {
  std::array<RasterPosition, 3> points{};
  std::array<Direction, 3> normals{};
};

/// Returns a triangle somewhere in a picture of `size` by `size` pixels, its normals at most `degrees` apart.
[[nodiscard]] inline ScreenTriangle random_screen_triangle(Random& random, std::int32_t size,
                                                           double degrees) {
  ScreenTriangle triangle;
  const Vec3 middle = random_unit(random);
  const std::int32_t reach = (size / 2) << Subpixel::kFraction;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.points[i].x = static_cast<std::int16_t>(random.integer(-reach, reach));
    triangle.points[i].y = static_cast<std::int16_t>(random.integer(-reach, reach));
    triangle.points[i].z = 1000;
    triangle.normals[i] = detail::packed(tilted(random, middle, radians(random.real(0, degrees)) / 2));
  }
  return triangle;
}

/// A square picture, black where nothing is drawn.
struct TrianglePicture {
  explicit TrianglePicture(std::int32_t size)
      : memory(hal::Framebuffer<Rgb888>::words(size, size)), frame(memory, size, size) {}
  std::vector<Rgb888::Word> memory;
  hal::Framebuffer<Rgb888> frame;
};

template <class Method>
[[nodiscard]] TrianglePicture picture_of(const ScreenTriangle& triangle,
                                         const typename Method::Lighting& lighting, std::int32_t size) {
  TrianglePicture picture(size);
  RasterStage<Method, hal::Framebuffer<Rgb888>> stage(picture.frame, size, size, lighting);
  const auto vertex = [&](std::size_t i) {
    return RasterVertex<Method>{triangle.points[i], Method::shade_vertex(lighting, triangle.normals[i])};
  };
  stage.draw(vertex(0), vertex(1), vertex(2), {});
  return picture;
}

/// Returns the largest difference of a channel, in 8-bit steps.
[[nodiscard]] inline int difference(Rgb8 a, Rgb8 b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}
[[nodiscard]] inline int most_different(const TrianglePicture& a, const TrianglePicture& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.memory.size(); ++i) {
    most = std::max(most, difference(Rgb888::decode(a.memory[i]), Rgb888::decode(b.memory[i])));
  }
  return most;
}

}  // namespace arcspan::test
