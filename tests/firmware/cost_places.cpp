// SPDX-License-Identifier: MIT
#include <arcspan/vertex/rotation.hpp>

#include <tests/firmware/cost_places.hpp>
#include <tests/frames/integer_shapes.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {
namespace {

constexpr TextureScale kScale{10};

struct Point {
  std::int32_t x;
  std::int32_t y;
  std::int32_t z;
};

/// A mesh of rectangles and discs, made at run time.
class Builder {
 public:
  /// A rectangle from `corner` along `across` and `down`, of columns x rows of two triangles each. The
  /// texture repeats `repeats` times in each of them.
  void rectangle(Point corner, Point across, Point down, Point normal, std::int32_t columns,
                 std::int32_t rows, std::int32_t repeats) {
    const std::size_t first = vertices_;
    const std::int32_t step = repeats << kScale.fraction_bits;
    for (std::int32_t r = 0; r <= rows; ++r) {
      for (std::int32_t c = 0; c <= columns; ++c) {
        const auto at = [&](std::int32_t Point::*axis) {
          return corner.*axis + across.*axis * c / columns + down.*axis * r / rows;
        };
        vertex({at(&Point::x), at(&Point::y), at(&Point::z)}, normal, c * step, r * step);
      }
    }
    const auto width = static_cast<std::size_t>(columns) + 1;
    for (std::size_t r = 0; r < static_cast<std::size_t>(rows); ++r) {
      for (std::size_t c = 0; c < static_cast<std::size_t>(columns); ++c) {
        const std::size_t a = first + r * width + c;
        triangle(a, a + width, a + 1);
        triangle(a + 1, a + width, a + width + 1);
      }
    }
  }
  /// A disc of triangles in the plane z = middle.z, with the texture once on it.
  void disc(Point middle, std::int32_t radius, std::int32_t triangles) {
    const std::size_t first = vertices_;
    constexpr std::int32_t kHalf = 1 << (kScale.fraction_bits - 1);
    vertex(middle, {0, 0, 1}, kHalf, kHalf);
    for (std::int32_t i = 0; i < triangles; ++i) {
      const Turn turn{static_cast<std::uint16_t>(i * 65536 / triangles)};
      const std::int32_t x = cosine(turn).raw() >> 16;  // 14 fraction bits
      const std::int32_t y = sine(turn).raw() >> 16;
      vertex({middle.x + ((x * radius) >> 14), middle.y + ((y * radius) >> 14), middle.z}, {0, 0, 1},
             kHalf + ((x * kHalf) >> 14), kHalf - ((y * kHalf) >> 14));
    }
    const auto count = static_cast<std::size_t>(triangles);
    for (std::size_t i = 0; i < count; ++i) triangle(first, first + 1 + i, first + 1 + (i + 1) % count);
  }
  [[nodiscard]] bool view(MeshView& mesh) const {
    return vertices_ <= kMost && indices_ <= 3 * kMost &&
           ok(MeshView::make(std::span(positions_.data(), vertices_), std::span(normals_.data(), vertices_),
                             std::span(index_.data(), indices_), mesh)) &&
           ok(mesh.attach(std::span(points_.data(), vertices_), kScale));
  }
  void clear() { vertices_ = indices_ = 0; }

 private:
  static constexpr std::size_t kMost = 512;

  void vertex(Point at, Point normal, std::int32_t u, std::int32_t v) {
    if (vertices_ < kMost) {
      positions_[vertices_] = {static_cast<std::int16_t>(at.x), static_cast<std::int16_t>(at.y),
                               static_cast<std::int16_t>(at.z)};
      normals_[vertices_] = pack_normal(normal.x << 14, normal.y << 14, normal.z << 14);
      points_[vertices_] = {static_cast<std::int16_t>(u), static_cast<std::int16_t>(v)};
    }
    ++vertices_;
  }
  void triangle(std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t index : {a, b, c}) {
      if (indices_ < index_.size()) index_[indices_] = static_cast<std::uint16_t>(index);
      ++indices_;
    }
  }

  std::array<ObjectPosition, kMost> positions_{};
  std::array<PackedNormal, kMost> normals_{};
  std::array<TexturePoint, kMost> points_{};
  std::array<std::uint16_t, 3 * kMost> index_{};
  std::size_t vertices_ = 0;
  std::size_t indices_ = 0;
};

/// The memory of one place at a time.
[[gnu::section(".bss.frame")]] Builder builder;

/// A crate on the floor: its front, its right side and its top.
void add_crate(std::int32_t x, std::int32_t z) {
  constexpr std::int32_t kSide = 2500;
  constexpr std::int32_t kFloor = -4000;
  const std::int32_t top = kFloor + kSide;
  builder.rectangle({x, top, z}, {kSide, 0, 0}, {0, -kSide, 0}, {0, 0, 1}, 1, 1, 1);
  builder.rectangle({x + kSide, top, z}, {0, 0, -kSide}, {0, -kSide, 0}, {1, 0, 0}, 1, 1, 1);
  builder.rectangle({x, top, z}, {0, 0, -kSide}, {0, -kSide, 0}, {-1, 0, 0}, 1, 1, 1);
  builder.rectangle({x, top, z - kSide}, {kSide, 0, 0}, {0, 0, kSide}, {0, 1, 0}, 1, 1, 1);
}

bool set_camera(const Placement& placement, PixelLength focal, CostPlace& place) {
  return builder.view(place.mesh) &&
         ok(ClipTransform::make(placement, {focal, ObjectLength::of(300), ObjectLength::of(60000)},
                                {320, 240}, place.transform));
}

}  // namespace

bool make_room(CostPlace& place) {
  builder.clear();
  builder.rectangle({-8000, -4000, -30000}, {16000, 0, 0}, {0, 0, 30000}, {0, 1, 0}, 8, 15, 1);
  builder.rectangle({-8000, 6000, -30000}, {16000, 0, 0}, {0, -10000, 0}, {0, 0, 1}, 8, 5, 1);
  builder.rectangle({-8000, 6000, 0}, {0, 0, -30000}, {0, -10000, 0}, {1, 0, 0}, 8, 2, 2);
  builder.rectangle({8000, 6000, -30000}, {0, 0, 30000}, {0, -10000, 0}, {-1, 0, 0}, 8, 2, 2);
  add_crate(-5000, -9000);
  add_crate(1500, -7000);
  add_crate(2500, -15000);
  add_crate(-2000, -22000);
  return set_camera({Rotation::identity(), {}}, PixelLength::of(200), place);
}

bool make_dashboard(CostPlace& place) {
  builder.clear();
  builder.rectangle({-12000, 7000, -400}, {24000, 0, 0}, {0, -14000, 0}, {0, 0, 1}, 6, 3, 1);
  for (const std::int32_t x : {-7600, 0, 7600}) {
    builder.disc({x, 900, -200}, 3500, 28);
    builder.rectangle({x - 200, 900, 0}, {400, 0, 0}, {1800, 2600, 0}, {0, 0, 1}, 1, 1, 1);
  }
  for (std::int32_t i = 0; i < 6; ++i) {
    builder.rectangle({-9500 + 3400 * i, -4200, -200}, {2000, 0, 0}, {0, -1400, 0}, {0, 0, 1}, 1, 1, 1);
  }
  Placement placement{Rotation::about_x({3641}), {}};  // 20 degrees
  placement.translation[2] = ObjectLength::of(-24000);
  return set_camera(placement, PixelLength::of(300), place);
}

bool make_square(std::int32_t depth, CostPlace& place) {
  const auto z = static_cast<std::int16_t>(depth);
  const auto minus = static_cast<std::int16_t>(-depth);
  static std::array<ObjectPosition, 4> corners;
  corners = {{{-8000, -8000, minus}, {8000, -8000, z}, {8000, 8000, z}, {-8000, 8000, minus}}};
  static constexpr std::array<PackedNormal, 4> kNormals{};
  static constexpr std::array<std::uint16_t, 6> kIndices{0, 1, 2, 0, 2, 3};
  static constexpr std::array<TexturePoint, 4> kCorners{{{0, 4096}, {4096, 4096}, {4096, 0}, {0, 0}}};
  Placement placement{Rotation::identity(), {}};
  placement.translation[2] = ObjectLength::of(-24000);
  return ok(MeshView::make(corners, kNormals, kIndices, place.mesh)) &&
         ok(place.mesh.attach(kCorners, TextureScale{12})) &&
         ok(ClipTransform::make(placement,
                                {PixelLength::of(300), ObjectLength::of(1000), ObjectLength::of(60000)},
                                {320, 240}, place.transform));
}

}  // namespace arcspan
