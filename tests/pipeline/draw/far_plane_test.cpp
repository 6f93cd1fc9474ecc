// SPDX-License-Identifier: MIT
// Triangles across the far plane are drawn up to it, with the depths that they have without it.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/shading/unlit.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <cmath>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kWidth = 80;
constexpr std::int32_t kHeight = 60;

struct Picture {
  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(kWidth * kHeight);
  std::vector<std::uint16_t> depths = std::vector<std::uint16_t>(kWidth * kHeight, DepthBuffer::kFarthest);
};

Picture drawn(const TestMesh& mesh, const TestCamera& camera) {
  Picture picture;
  hal::Framebuffer<Gray8> frame(picture.pixels, kWidth, kHeight);
  DepthBuffer depth(picture.depths, kWidth, kHeight);
  const DrawResult result =
      draw_mesh<Unlit>(mesh.view(), camera.transform(), Unlit::lighting({255, 255, 255}), frame, depth);
  REQUIRE(ok(result.status));
  return picture;
}

/// How many of the nine pixels around one in the middle of a picture are drawn.
int drawn_around(const Picture& picture, std::int32_t x, std::int32_t y) {
  int count = 0;
  for (std::int32_t j = y - 1; j <= y + 1; ++j) {
    for (std::int32_t i = x - 1; i <= x + 1; ++i) {
      count += picture.pixels[static_cast<std::size_t>(j * kWidth + i)] != 0 ? 1 : 0;
    }
  }
  return count;
}

/// 1 / w at pixel centres, linear on the screen: of the plane through three points in view space.
struct InverseDistance {
  Vec3 normal;
  double offset;
  double focal;

  [[nodiscard]] double at(double x, double y) const {
    const Vec3 ray{(x + 0.5 - kWidth / 2.0) / focal, -(y + 0.5 - kHeight / 2.0) / focal, -1};
    return dot(normal, ray) / offset;
  }
};

}  // namespace

TEST_CASE("triangles across the far plane are drawn up to it, with right depths") {
  Random random(211);
  int with_both = 0;
  int vanished = 0;
  for (int i = 0; i < share_of(3000); ++i) {
    TestCamera camera;
    camera.width = kWidth;
    camera.height = kHeight;
    camera.focal = random.decades(40, 400);
    camera.near_plane = random.integer(50, 500);
    const double reach = random.decades(2000, 30000);
    TestMesh mesh;
    Vec3 corners[3];
    for (Vec3& corner : corners) {
      const double away = random.decades(camera.near_plane, reach);
      const double aside = away * kWidth / camera.focal;
      corner = {std::round(random.real(-aside, aside)), std::round(random.real(-aside, aside)),
                -std::round(away)};
      corner.x = std::clamp(corner.x, -32767.0, 32767.0);
      corner.y = std::clamp(corner.y, -32767.0, 32767.0);
    }
    if (dot(cross(corners[1] - corners[0], corners[2] - corners[0]), corners[0]) > 0) {
      std::swap(corners[1], corners[2]);  // shows its front
    }
    for (const Vec3& corner : corners) (void)mesh.add(corner, {0, 0, 1});
    mesh.triangle(0, 1, 2);
    const Picture whole = drawn(mesh, camera);
    camera.far_plane = std::round(random.decades(camera.near_plane + 1, reach));
    const Picture cut = drawn(mesh, camera);

    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const InverseDistance inverse{normal, dot(normal, corners[0]), camera.focal};
    const double scale =
        65023 * camera.far_plane / (camera.far_plane - camera.near_plane) * camera.near_plane;
    // Corners snap to sixteenths of a pixel, and each new one is off by as much.
    const double per_pixel =
        std::abs(inverse.at(1, 0) - inverse.at(0, 0)) + std::abs(inverse.at(0, 1) - inverse.at(0, 0));
    int before = 0;
    int beyond = 0;
    INFO("triangle " << i << ", far plane " << camera.far_plane);
    for (std::int32_t y = 1; y < kHeight - 1; ++y) {
      for (std::int32_t x = 1; x < kWidth - 1; ++x) {
        const auto at = static_cast<std::size_t>(y * kWidth + x);
        if (drawn_around(whole, x, y) < 9) continue;  // edges of the rest are off by a sixteenth of a pixel
        const double steps_before = (inverse.at(x, y) - 1 / camera.far_plane) / per_pixel;  // pixels
        if (std::abs(steps_before) < 0.25) continue;
        ++(steps_before > 0 ? before : beyond);
        INFO("column " << x << ", row " << y);
        REQUIRE((cut.pixels[at] != 0) == (steps_before > 0));
        if (steps_before < 0) continue;
        const double exact = 256 + scale * (1 / camera.near_plane - inverse.at(x, y));
        REQUIRE(std::abs(cut.depths[at] - exact) < 3 + scale * per_pixel / 4);
      }
    }
    if (before > 0 && beyond > 0) ++with_both;
    if (before == 0 && beyond > 0) ++vanished;
  }
  CHECK(with_both > share_of(300));
  CHECK(vanished > share_of(100));
}
