// SPDX-License-Identifier: MIT
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/environment_map.hpp>

#include <catch2/catch.hpp>
#include <tests/frames/integer_shapes.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

using namespace arcspan;
using hal::Framebuffer;

namespace {

/// 32×32 texels that say where they are: red the column, blue the row.
Texture<DirectTexels<>> places() {
  static const std::vector<std::uint16_t> kWords = [] {
    std::vector<std::uint16_t> words;
    for (std::uint32_t i = 0; i < 1024; ++i)
      words.push_back(static_cast<std::uint16_t>((i & 31) << 11 | 0x400 | i >> 5));
    return words;
  }();
  Texture<DirectTexels<>> texture;
  REQUIRE(ok(Texture<DirectTexels<>>::make(kWords, {5, 5, 1}, texture)));
  return texture;
}

}  // namespace

TEST_CASE("a sphere shows the picture of its environment where its normals point, however it is turned") {
  constexpr std::int32_t kSize = 160;
  constexpr double kDistance = 4;  // radii
  static const auto kSphere = scenes::make_sphere<32, 16>();
  MeshView mesh;
  REQUIRE(ok(kSphere.view(mesh)));
  for (const std::uint16_t turn : std::initializer_list<std::uint16_t>{0, 9000, 40000}) {
    Placement placement{Rotation::about_x({turn}) * Rotation::about_y({5000}), {}};
    placement.translation[2] = ObjectLength::of(-kDistance * scenes::kRadius);
    ClipTransform transform;
    constexpr double kFocal = 270;
    REQUIRE(ok(ClipTransform::make(placement,
                                   {PixelLength::of(kFocal), ObjectLength::of(2.0 * scenes::kRadius),
                                    ObjectLength::of(6.0 * scenes::kRadius)},
                                   {kSize, kSize}, transform)));
    std::vector<std::uint16_t> words(Framebuffer<Rgb565>::words(kSize, kSize));
    Framebuffer<Rgb565> frame(words, kSize, kSize);
    const EnvironmentMap<DirectTexels<>> chrome(places(), placement.rotation);
    REQUIRE(
        draw_mesh<Arc<EnvironmentMap<DirectTexels<>>>>(mesh, transform, chrome, frame, NoDepth{}).status ==
        Status::kOk);
    double worst = 0;
    double sum = 0;
    int count = 0;
    for (std::int32_t y = 0; y < kSize; ++y) {
      for (std::int32_t x = 0; x < kSize; ++x) {
        // The point of the unit sphere that the ray of this pixel meets first.
        const double dx = (x + 0.5 - kSize / 2) / kFocal;
        const double dy = -(y + 0.5 - kSize / 2) / kFocal;
        const double square = dx * dx + dy * dy + 1;
        const double root = kDistance * kDistance - square * (kDistance * kDistance - 1);
        if (root < 0.15) continue;  // near the silhouette, where the mesh has corners
        const double t = (kDistance - std::sqrt(root)) / square;
        const std::uint32_t pixel = words[static_cast<std::size_t>(y * kSize + x)];
        const double column = (t * dx + 1) * 16 - 0.5;
        const double row = (1 - t * dy) * 16 - 0.5;
        const double off = std::max(std::abs((pixel >> 11) - column), std::abs((pixel & 31) - row));
        worst = std::max(worst, off);
        sum += off;
        ++count;
      }
    }
    REQUIRE(count > 8000);
    CHECK(worst <= 1.5);  // half a texel by rounding, and the mesh is no sphere
    CHECK(sum / count <= 0.4);
  }
}
