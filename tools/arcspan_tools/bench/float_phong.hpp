// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/bench/bench_scene.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace arcspan::tools {

/// What to compare with: classic Phong shading as one writes it for a processor with fast floating point, of
/// the same scene with the same fill rule, depth and pixel format. Normals are interpolated linearly on the
/// screen and normalised by a root and a division, the power goes by squaring.
class FloatPhong {
 public:
  explicit FloatPhong(const BenchScene& bench);

  void clear();
  void draw();
  [[nodiscard]] Image image() const;

 private:
  struct Vector {
    float x;
    float y;
    float z;
  };
  /// On the screen: x, y in pixels, z a 16-bit depth.
  struct Vertex {
    Vector position;
    Vector normal;
  };
  /// Normal and depth at a pixel's centre, or what they change by from one to the next.
  struct Attributes {
    float x;
    float y;
    float z;
    float depth;
  };
  /// Value at the origin of the screen, and gradients.
  struct Plane {
    Attributes at;
    Attributes dx;
    Attributes dy;
  };

  void draw_triangle(const Vertex& a, const Vertex& b, const Vertex& c);
  void draw_half(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d, const Plane& plane);
  void draw_row(std::int32_t y, std::int32_t first, std::int32_t last, const Plane& plane);
  [[nodiscard]] std::uint16_t colour(const Attributes& normal) const;

  std::vector<Vector> positions_;
  std::vector<Vector> normals_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Vertex> transformed_;
  std::vector<std::uint16_t> frame_;
  std::vector<std::uint16_t> depths_;
  std::int32_t width_;
  std::int32_t height_;
  float focal_;
  float eye_;
  float near_;
  float far_;
  Vector light_{};
  Vector ambient_{};
  Vector diffuse_{};
  float specular_;
  std::int32_t shininess_;
  std::uint16_t background_;
};

}  // namespace arcspan::tools
