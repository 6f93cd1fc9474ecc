// SPDX-License-Identifier: MIT
// Billboards: rectangles in double precision, with the texels that belong into them.
#include <arcspan/draw_billboards.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr Viewport kView{83, 58};
constexpr std::size_t kPixels = static_cast<std::size_t>(kView.width * kView.height);
constexpr std::uint16_t kEmpty = 0xFFFF;
using Sign = Textured<Unlit, DirectTexels<Alpha1Colour>>;
using Poster = Textured<Unlit, DirectTexels<Alpha1Colour>, TexelLight::kNone, TextureFilter::kBilinear,
                        TextureBorders::kOfTexture>;

/// 8×16 texels, each of which tells its place, all opaque but those of column 5.
constexpr auto kTexels = [] {
  std::array<std::uint16_t, 128> texels{};
  for (std::uint16_t i = 0; i < 128; ++i) {
    texels[i] = static_cast<std::uint16_t>(i << 6 | (i % 8 == 5 ? 0 : 0x20));
  }
  return texels;
}();
constexpr auto kTexture = Texture<DirectTexels<Alpha1Colour>>::of(kTexels, {3, 4, 1})
                              .with({TextureWrap::kClamp, TextureWrap::kClamp});

struct Picture {
  std::vector<std::uint16_t> pixels = std::vector<std::uint16_t>(kPixels, kEmpty);
  std::vector<std::uint16_t> depths = std::vector<std::uint16_t>(kPixels, DepthBuffer::kFarthest);
};

TestCamera camera_at(Vec3 translation, double focal) {
  TestCamera camera;
  camera.width = kView.width;
  camera.height = kView.height;
  camera.focal = focal;
  camera.translation = translation;
  return camera;
}

/// Draws a billboard at the origin in bands of `rows` rows.
template <class Method = Sign>
Picture drawn(const ClipTransform& transform, const BillboardSize& size, std::int32_t rows) {
  Picture picture;
  const typename Method::Lighting lighting(PackedRgb{}, kTexture);
  const ObjectPosition origin{};
  for (std::int32_t top = 0; top < kView.height; top += rows) {
    const std::int32_t count = std::min(rows, kView.height - top);
    const auto begin = static_cast<std::size_t>(top * kView.width);
    hal::Framebuffer<Rgb565> band(std::span(picture.pixels).subspan(begin), kView.width, count, top);
    DepthBuffer depth(std::span(picture.depths).subspan(begin), kView.width, count, top);
    REQUIRE(ok(draw_billboards<Method>({&origin, 1}, size, transform, lighting, band, depth)));
  }
  return picture;
}

}  // namespace

TEST_CASE("a billboard shows each texel where it belongs, up to the borders") {
  Random random(5);
  int with_pixels = 0;
  int cut = 0;
  for (int i = 0; i < share_of(3000); ++i) {
    const double distance = std::exp(random.real(std::log(20.0), std::log(60000.0)));
    const double focal = i % 2 == 0 ? 60 : 900;
    const double reach = distance * 60 / focal;
    const TestCamera camera =
        camera_at({random.real(-reach, reach), random.real(-reach, reach), -distance}, focal);
    BillboardSize size;
    size.unit = i % 3 == 0 ? BillboardSize::Unit::kPixel : BillboardSize::Unit::kObject;
    const double scale = size.unit == BillboardSize::Unit::kPixel ? 1 : distance / focal;
    const auto side = [&] {
      const double pixels = std::exp(random.real(0, std::log(3000.0)));
      return static_cast<std::uint16_t>(std::clamp(pixels * scale, 1.0, 65535.0));
    };
    size.width = side();
    size.height = side();
    const Picture picture = drawn(camera.transform(), size, kView.height);
    CHECK(picture.pixels == drawn(camera.transform(), size, 9).pixels);

    const bool in_pixels = size.unit == BillboardSize::Unit::kPixel;
    const double width = in_pixels ? std::min<double>(size.width, 2047) : size.width * focal / distance;
    const double height = in_pixels ? std::min<double>(size.height, 2047) : size.height * focal / distance;
    const double left = kView.width / 2.0 + camera.translation.x * focal / distance - width / 2;
    const double top = kView.height / 2.0 - camera.translation.y * focal / distance - height / 2;
    INFO("billboard " << i << ": " << width << " x " << height << " at " << left << ", " << top);
    if (width > 900 || height > 900) ++cut;
    const double near_x = 0.1 + width / 5000;
    const double near_y = 0.1 + height / 5000;
    int wrong = 0;
    int pixels = 0;
    for (std::int32_t y = 0; y < kView.height; ++y) {
      for (std::int32_t x = 0; x < kView.width; ++x) {
        const std::uint16_t found = picture.pixels[static_cast<std::size_t>(y * kView.width + x)];
        // The texels nearby: corners snap to a sixteenth of a pixel, and the texture ends 8/65536 of its
        // size before the borders.
        bool may_be_empty = false;
        bool right = false;
        for (const double dx : {-near_x, near_x}) {
          for (const double dy : {-near_y, near_y}) {
            const double u = (x + 0.5 + dx - left) / width;
            const double v = (y + 0.5 + dy - top) / height;
            const auto column = static_cast<int>(std::floor(8 * u));
            const auto row = static_cast<int>(std::floor(16 * v));
            if (u < 0 || v < 0 || u >= 1 || v >= 1 || column == 5) {
              may_be_empty = true;
            } else {
              const std::uint16_t texel = kTexels[static_cast<std::size_t>(8 * row + column)];
              right |= found == Alpha1Colour::rgb565(texel);
            }
          }
        }
        if (found != kEmpty) ++pixels;
        if (width > 4 && height > 4 && !(found == kEmpty ? may_be_empty : right)) ++wrong;
      }
    }
    if (pixels > 0) ++with_pixels;
    CHECK(wrong == 0);
  }
  CHECK(with_pixels > share_of(3000) / 3);
  CHECK(cut > share_of(3000) / 20);
}

TEST_CASE("a billboard has the depth of its middle") {
  const ClipTransform transform = camera_at({0, 0, -8000}, 60).transform();
  const ClipPosition middle = transform({});
  const std::uint16_t depth = project(middle, transform).z;
  const Picture picture = drawn(transform, {4000, 4000}, kView.height);
  int pixels = 0;
  for (std::size_t i = 0; i < kPixels; ++i) {
    if (picture.pixels[i] == kEmpty) {
      CHECK(picture.depths[i] == DepthBuffer::kFarthest);
    } else {
      CHECK(std::abs(picture.depths[i] - depth) <= 1);
      ++pixels;
    }
  }
  CHECK(pixels == 30 * 26);  // a column of texels is transparent
}

TEST_CASE("a clamped texture mixes no texels of opposite borders") {
  const ClipTransform transform = camera_at({0, 0, -8000}, 60).transform();
  const Picture picture = drawn<Poster>(transform, {40, 40, BillboardSize::Unit::kPixel}, kView.height);
  const auto pixel = [&](std::int32_t x, std::int32_t y) {
    return picture.pixels[static_cast<std::size_t>(y * kView.width + x)];
  };
  // The corners of columns 21...60 and rows 9...48.
  CHECK(pixel(21, 9) == Alpha1Colour::rgb565(kTexels[0]));
  CHECK(pixel(60, 9) == Alpha1Colour::rgb565(kTexels[7]));
  CHECK(pixel(21, 48) == Alpha1Colour::rgb565(kTexels[120]));
  CHECK(pixel(60, 48) == Alpha1Colour::rgb565(kTexels[127]));
}

TEST_CASE("a billboard is hidden by what is nearer") {
  const ClipTransform transform = camera_at({0, 0, -8000}, 60).transform();
  const std::uint16_t depth = project(transform({}), transform).z;
  const Sign::Lighting lighting(PackedRgb{}, kTexture);
  const ObjectPosition origin{};
  const auto visible = [&](std::int32_t surface) {
    Picture picture;
    std::fill(picture.depths.begin(), picture.depths.end(), static_cast<std::uint16_t>(surface));
    hal::Framebuffer<Rgb565> frame(picture.pixels, kView.width, kView.height);
    DepthBuffer buffer(picture.depths, kView.width, kView.height);
    REQUIRE(ok(draw_billboards<Sign>({&origin, 1}, {4000, 4000}, transform, lighting, frame, buffer)));
    return std::count(picture.pixels.begin(), picture.pixels.end(), kEmpty) < static_cast<int>(kPixels);
  };
  CHECK(visible(depth + 2));
  CHECK(!visible(depth - 2));
}

TEST_CASE("a billboard before the near plane or beyond the far plane is not drawn") {
  for (const double z : {0.0, 500.0, -15.0, -3001.0}) {
    TestCamera camera = camera_at({0, 0, z}, 60);
    camera.far_plane = 3000;
    const Picture picture = drawn(camera.transform(), {400, 400}, kView.height);
    CHECK(std::count(picture.pixels.begin(), picture.pixels.end(), kEmpty) == static_cast<int>(kPixels));
  }
}
