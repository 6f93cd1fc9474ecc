// SPDX-License-Identifier: MIT
#include <arcspan/pixel/rgb565.hpp>

#include <arcspan_tools/bench/float_phong.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace arcspan::tools {
namespace {

constexpr std::uint16_t kFarthest = 0xFFFF;

float to_float(double value) { return static_cast<float>(value); }

float power(float base, std::int32_t exponent) {
  float result = 1;
  for (; exponent > 1; exponent >>= 1) {
    if ((exponent & 1) != 0) result *= base;
    base *= base;
  }
  return result * base;
}

/// The first pixel whose centre is at or beyond `edge`.
std::int32_t first_pixel(float edge) { return static_cast<std::int32_t>(std::ceil(edge - 0.5f)); }

unsigned level(float value) { return static_cast<unsigned>(std::min(value + 0.5f, 255.0f)); }

}  // namespace

FloatPhong::FloatPhong(const BenchScene& bench)
    : triangles_(bench.mesh.triangles),
      transformed_(bench.mesh.positions.size()),
      width_(bench.scene.size.width),
      height_(bench.scene.size.height),
      focal_(to_float(bench.focal)),
      eye_(to_float(bench.eye)),
      near_(to_float(bench.eye - 1.02)),
      far_(to_float(bench.eye + 1.02)),
      specular_(to_float(bench.scene.surface.specular.rgb.x * 255)),
      shininess_(bench.scene.surface.shininess),
      background_(Rgb565::encode(to_rgb8(bench.scene.background))) {
  const auto vector = [](Vec3 v) { return Vector{to_float(v.x), to_float(v.y), to_float(v.z)}; };
  for (const Vec3& p : bench.mesh.positions) positions_.push_back(vector(p));
  for (const Vec3& n : bench.mesh.normals) normals_.push_back(vector(n));
  const Surface& surface = bench.scene.surface;
  light_ = vector(normalised(bench.scene.lights[0].towards));
  ambient_ = vector(surface.colour * (surface.ambient.rgb.x * 255));
  diffuse_ = vector(surface.colour * (surface.diffuse.rgb.x * 255));
  const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  frame_.resize(pixels);
  depths_.resize(pixels);
  clear();
}

void FloatPhong::clear() {
  std::fill(frame_.begin(), frame_.end(), background_);
  std::fill(depths_.begin(), depths_.end(), kFarthest);
}

Image FloatPhong::image() const {
  Image image(width_, height_);
  for (std::size_t i = 0; i < frame_.size(); ++i) image.pixels[i] = Rgb565::decode(frame_[i]);
  return image;
}

void FloatPhong::draw() {
  const float slope = far_ * near_ / (far_ - near_);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const float distance = eye_ - positions_[i].z;
    const float scale = focal_ / distance;
    const float depth = 65535.0f * (far_ / (far_ - near_) - slope / distance);
    transformed_[i] = {{0.5f * static_cast<float>(width_) + positions_[i].x * scale,
                        0.5f * static_cast<float>(height_) - positions_[i].y * scale, depth},
                       normals_[i]};
  }
  for (const auto& t : triangles_) draw_triangle(transformed_[t[0]], transformed_[t[1]], transformed_[t[2]]);
}

void FloatPhong::draw_triangle(const Vertex& a, const Vertex& b, const Vertex& c) {
  const Vector u{b.position.x - a.position.x, b.position.y - a.position.y, 0};
  const Vector v{c.position.x - a.position.x, c.position.y - a.position.y, 0};
  const float area = u.x * v.y - v.x * u.y;
  if (!(area < 0)) return;
  const float inverse = 1 / area;
  const auto gradient_x = [&](float p, float q, float r) {
    return ((q - p) * v.y - (r - p) * u.y) * inverse;
  };
  const auto gradient_y = [&](float p, float q, float r) {
    return ((r - p) * u.x - (q - p) * v.x) * inverse;
  };
  const auto both = [&](const auto& gradient) {
    return Attributes{
        gradient(a.normal.x, b.normal.x, c.normal.x), gradient(a.normal.y, b.normal.y, c.normal.y),
        gradient(a.normal.z, b.normal.z, c.normal.z), gradient(a.position.z, b.position.z, c.position.z)};
  };
  Plane plane{{}, both(gradient_x), both(gradient_y)};
  const auto origin = [&](float value, float dx, float dy) {
    return value - dx * a.position.x - dy * a.position.y;
  };
  plane.at = {origin(a.normal.x, plane.dx.x, plane.dy.x), origin(a.normal.y, plane.dx.y, plane.dy.y),
              origin(a.normal.z, plane.dx.z, plane.dy.z),
              origin(a.position.z, plane.dx.depth, plane.dy.depth)};
  const Vertex* top = &a;
  const Vertex* middle = &b;
  const Vertex* bottom = &c;
  if (middle->position.y < top->position.y) std::swap(top, middle);
  if (bottom->position.y < middle->position.y) std::swap(middle, bottom);
  if (middle->position.y < top->position.y) std::swap(top, middle);
  draw_half(*top, *middle, *top, *bottom, plane);
  draw_half(*middle, *bottom, *top, *bottom, plane);
}

/// The rows of the edge from a to b, between it and the edge from c to d.
void FloatPhong::draw_half(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d,
                           const Plane& plane) {
  const std::int32_t first = std::max(first_pixel(a.position.y), 0);
  const std::int32_t last = std::min(first_pixel(b.position.y), height_);
  if (first >= last) return;
  const float slope = (b.position.x - a.position.x) / (b.position.y - a.position.y);
  const float other = (d.position.x - c.position.x) / (d.position.y - c.position.y);
  for (std::int32_t y = first; y < last; ++y) {
    const float centre = static_cast<float>(y) + 0.5f;
    const float p = a.position.x + slope * (centre - a.position.y);
    const float q = c.position.x + other * (centre - c.position.y);
    draw_row(y, std::max(first_pixel(std::min(p, q)), 0), std::min(first_pixel(std::max(p, q)), width_),
             plane);
  }
}

void FloatPhong::draw_row(std::int32_t y, std::int32_t first, std::int32_t last, const Plane& plane) {
  const float px = static_cast<float>(first) + 0.5f;
  const float py = static_cast<float>(y) + 0.5f;
  Attributes n{plane.at.x + plane.dx.x * px + plane.dy.x * py, plane.at.y + plane.dx.y * px + plane.dy.y * py,
               plane.at.z + plane.dx.z * px + plane.dy.z * py,
               plane.at.depth + plane.dx.depth * px + plane.dy.depth * py};
  const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
  std::uint16_t* depth = depths_.data() + row;
  std::uint16_t* frame = frame_.data() + row;
  for (std::int32_t x = first; x < last; ++x) {
    const auto pixel_depth = static_cast<std::uint16_t>(static_cast<std::int32_t>(n.depth));
    if (pixel_depth < depth[x]) {
      depth[x] = pixel_depth;
      frame[x] = colour(n);
    }
    n.x += plane.dx.x;
    n.y += plane.dx.y;
    n.z += plane.dx.z;
    n.depth += plane.dx.depth;
  }
}

/// S0 eq. 1; the eye looks along z.
[[gnu::always_inline]] inline std::uint16_t FloatPhong::colour(const Attributes& normal) const {
  const float scale = 1 / std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
  const float nl = scale * (normal.x * light_.x + normal.y * light_.y + normal.z * light_.z);
  const float nv = scale * normal.z;
  float diffuse = 0;
  float specular = 0;
  if (nl > 0) {
    diffuse = nl;
    const float rv = 2 * nl * nv - light_.z;
    if (rv > 0) specular = specular_ * power(rv, shininess_);
  }
  const unsigned r = level(ambient_.x + diffuse_.x * diffuse + specular);
  const unsigned g = level(ambient_.y + diffuse_.y * diffuse + specular);
  const unsigned b = level(ambient_.z + diffuse_.z * diffuse + specular);
  return static_cast<std::uint16_t>((r & 0xF8u) << 8 | (g & 0xFCu) << 3 | b >> 3);
}

}  // namespace arcspan::tools
