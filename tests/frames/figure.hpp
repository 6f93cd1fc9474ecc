// SPDX-License-Identifier: MIT
#pragma once

#include <tests/frames/integer_shapes.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// A standing figure like the characters of games: limbs of small triangles, normals far apart around a limb
/// and close along it. Made by the compiler, as the other shapes.
namespace arcspan::scenes {

/// An ellipsoid about a vertical axis, leaning sideways.
struct Limb {
  std::int32_t x;  ///< of the middle, object units
  std::int32_t y;
  std::int32_t z;
  std::int32_t width;   ///< half the size across, object units
  std::int32_t height;  ///< half the size along the axis
  std::uint32_t lean;   ///< about z: 2^32 is a whole turn
};

inline constexpr std::array<Limb, 11> kLimbs{{{0, 12600, 0, 2100, 2500, 0},  // head
                                              {0, 5900, 0, 3000, 4900, 0},   // trunk
                                              {0, 300, 0, 2700, 2300, 0},    // hips
                                              {-3700, 6300, 300, 1000, 3300, 0xF5000000u},
                                              {3700, 6300, -300, 1000, 3300, 0x0B000000u},
                                              {-5000, 1700, 900, 850, 3100, 0xFB000000u},
                                              {5000, 1700, -900, 850, 3100, 0x05000000u},
                                              {-1500, -3700, 700, 1400, 4300, 0xFE000000u},
                                              {1500, -3700, -700, 1400, 4300, 0x02000000u},
                                              {-1900, -10800, 900, 1100, 4200, 0},
                                              {1900, -10800, -900, 1100, 4200, 0}}};

/// 10 vertices around each limb and 21 rings along it: 420 triangles for each.
consteval auto make_figure() {
  constexpr std::uint32_t kSectors = 10;
  constexpr std::uint32_t kStacks = 22;
  constexpr std::size_t kVertices = kSectors * (kStacks - 1) + 2;
  constexpr std::size_t kTriangles = 2 * kSectors * (kStacks - 1);
  constexpr auto kSphere = make_sphere<kSectors, kStacks>();
  Shape<kLimbs.size() * kVertices, kLimbs.size() * kTriangles> figure{};
  for (std::size_t i = 0; i < kLimbs.size(); ++i) {
    const Limb& limb = kLimbs[i];
    const std::int64_t sine = sine30(limb.lean);
    const std::int64_t cosine = cosine30(limb.lean);
    for (std::size_t v = 0; v < kVertices; ++v) {
      const ObjectPosition& p = kSphere.positions[v];  // kRadius = 2^14 units
      const auto place = [&](std::int64_t x, std::int64_t y) {
        return std::array<std::int64_t, 2>{x * cosine - y * sine, x * sine + y * cosine};
      };
      const auto at = place(std::int64_t{p.x} * limb.width, std::int64_t{p.y} * limb.height);  // 44 bits
      figure.vertex(i * kVertices + v, (at[0] >> 28) + (std::int64_t{limb.x} << 16),
                    (at[1] >> 28) + (std::int64_t{limb.y} << 16),
                    (std::int64_t{p.z} * limb.width * 4) + (std::int64_t{limb.z} << 16));
      // The normal of an ellipsoid: coordinates divided by the squared half sizes.
      const auto normal = place(std::int64_t{p.x} * limb.height, std::int64_t{p.y} * limb.width);
      figure.normals[i * kVertices + v] =
          packed(normal[0] >> 30, normal[1] >> 30, std::int64_t{p.z} * limb.height);
    }
    for (std::size_t t = 0; t < 3 * kTriangles; ++t) {
      figure.indices[3 * i * kTriangles + t] = static_cast<std::uint16_t>(i * kVertices + kSphere.indices[t]);
    }
  }
  return figure;
}

}  // namespace arcspan::scenes
