// SPDX-License-Identifier: MIT
// Where texels are shown: against double precision, over random triangles.
#include <arcspan/clip/clip_polygon.hpp>
#include <arcspan/shading/grey_gouraud.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/texture/mapped_triangle.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;
using Plain = Textured<Unlit, DirectTexels<>>;
using Lit = Textured<GreyGouraud<Illumination<1, Highlight::kBlinn>>, DirectTexels<>>;  // one word for all

namespace {

template <class Method>
typename Method::Lighting lighting_of(unsigned width_bits, unsigned height_bits, std::uint8_t levels = 1) {
  static const std::vector<std::uint16_t> kWords(2u << 20);
  typename Method::Lighting lighting;
  REQUIRE(ok(Texture<DirectTexels<>>::make(
      kWords, {static_cast<std::uint8_t>(width_bits), static_cast<std::uint8_t>(height_bits), levels},
      lighting.texture)));
  return lighting;
}

/// The distance of a fraction of a repetition from `wanted`, in texels of 2^bits.
double texels_off(std::uint32_t shown, double wanted, unsigned bits) {
  const double repetitions = std::ldexp(shown, -32) - wanted;
  return std::abs(repetitions - std::round(repetitions)) * (1 << bits);
}

/// The largest errors over random triangles.
struct Errors {
  double texels = 0;
  double levels = 0;  ///< where the level is in one word with u and v
};
template <class Method>
Errors largest_errors(std::uint64_t seed, int count, std::int32_t size, double ratio, double texels,
                      unsigned width, unsigned height) {
  Random random(seed);
  const typename Method::Lighting lighting = lighting_of<Method>(width, height);
  Errors worst;
  for (int i = 0; i < count; ++i) {
    const double range = random.real(1, texels) / (1 << std::max(width, height));
    const MappedTriangle<Method> triangle = random_triangle<Method>(random, size, ratio, range);
    for_each_pixel(triangle, lighting, size, [&](std::int32_t x, std::int32_t y, const auto& run) {
      const auto [u, v, level] = triangle.at(x, y);
      const TexelSteps& steps = run.steps();
      worst.texels =
          std::max({worst.texels, texels_off(steps.u(), u, width), texels_off(steps.v(), v, height)});
      if constexpr (std::same_as<std::remove_cvref_t<decltype(run.mapping)>,
                                 LinearTexture<TexelSteps, true>>) {
        worst.levels = std::max(worst.levels, std::abs((steps.light_factor() >> 25) - level));
      }
    });
  }
  return worst;
}

/// The level of `texture` that a run shows.
template <class Run>
unsigned level_of(const Run& run, const Texture<DirectTexels<>>& texture) {
  unsigned level = 0;
  while (texture.at(texture.size().texels(level)) != run.words) ++level;
  return level;
}

/// The level of a pixel in double precision: log2 of the longest step over the texture, in texels, that a
/// step of one pixel in any direction makes.
template <class Method>
double level_wanted(const MappedTriangle<Method>& triangle, std::int32_t x, std::int32_t y,
                    const TextureSize& size) {
  const auto texels = [&](std::int32_t column, std::int32_t row) {
    const auto point = triangle.at(column, row);
    return std::pair(std::ldexp(point.u, size.width_bits), std::ldexp(point.v, size.height_bits));
  };
  // The change per pixel, from the pixels at both sides.
  const auto [left_u, left_v] = texels(x - 1, y);
  const auto [right_u, right_v] = texels(x + 1, y);
  const auto [upper_u, upper_v] = texels(x, y - 1);
  const auto [lower_u, lower_v] = texels(x, y + 1);
  const double across = std::hypot(right_u - left_u, right_v - left_v) / 2;
  const double down = std::hypot(lower_u - upper_u, lower_v - upper_v) / 2;
  const double squares = across * across + down * down;
  const double area =
      ((right_u - left_u) * (lower_v - upper_v) - (right_v - left_v) * (lower_u - upper_u)) / 4;
  const double rest = std::sqrt(std::max(0.0, squares * squares - 4 * area * area));
  return std::clamp(std::log2((squares + rest) / 2) / 2, 0.0, size.levels - 1.0);
}

}  // namespace

TEST_CASE("with mip levels, every piece of a row shows the level of its pixels, within half a texel of it") {
  constexpr unsigned kBits = 9;
  Random random(31);
  const Plain::Lighting lighting = lighting_of<Plain>(kBits, kBits, kBits + 1);
  const TextureSize& size = lighting.texture.size();
  int pixels = 0;
  int wrong = 0;
  int changes = 0;  // of the level within a row
  int beyond = 0;   // the end of the level
  double worst = 0;
  for (int i = 0; i < test::share_of(300); ++i) {
    MappedTriangle<Plain> triangle = random_triangle<Plain>(random, 240, 8, 0);
    map_plane(random, random.decades(100, 8000) / (1 << kBits), triangle);
    std::pair<std::int32_t, unsigned> last{INT32_MIN, 0};
    for_each_pixel(triangle, lighting, 240, [&](std::int32_t x, std::int32_t y, const auto& run) {
      const unsigned level = level_of(run, lighting.texture);
      const auto point = triangle.at(x, y);
      worst = std::max({worst, texels_off(run.steps().u(), point.u, kBits - level),
                        texels_off(run.steps().v(), point.v, kBits - level)});
      ++pixels;
      wrong += std::abs(level - level_wanted(triangle, x, y, size)) > 0.75 ? 1 : 0;
      changes += last.first == y && last.second != level ? 1 : 0;
      beyond += run.steps().index() >> (2 * (kBits - level)) != 0 ? 1 : 0;
      last = {y, level};
    });
  }
  CAPTURE(pixels, wrong, changes, beyond, worst);
  CHECK(changes > pixels / 1000);
  CHECK(beyond == 0);
  CHECK(wrong < pixels / 200);
  CHECK(worst <= 0.5);
}

// Where a row has one pixel, no step is used but by the choice of the level.
TEST_CASE("slivers show the mip level of their pixels, however narrow they are") {
  constexpr unsigned kBits = 8;
  Random random(33);
  const Plain::Lighting lighting = lighting_of<Plain>(kBits, kBits, kBits + 1);
  int pixels = 0;
  int wrong = 0;
  for (int i = 0; i < test::share_of(60000); ++i) {
    MappedTriangle<Plain> triangle = random_triangle<Plain>(random, 3, 1, 0);
    map_plane(random, random.real(2, 24) / (1 << kBits), triangle);
    for_each_small_pixel(triangle, lighting, 3, [&](std::int32_t x, std::int32_t y, const auto& run) {
      const double wanted = level_wanted(triangle, x, y, lighting.texture.size());
      ++pixels;
      wrong += std::abs(level_of(run, lighting.texture) - wanted) > 0.75 ? 1 : 0;
    });
  }
  CAPTURE(pixels, wrong);
  CHECK(pixels > test::share_of(30000));
  CHECK(wrong == 0);
}

TEST_CASE("the mip level of a floor follows its length, or its width where the texture is denser along it") {
  constexpr unsigned kBits = 9;
  const Plain::Lighting lighting = lighting_of<Plain>(kBits, kBits, kBits + 1);
  const TextureSize& size = lighting.texture.size();
  for (const std::int32_t repetitions : {1, 30}) {
    MappedTriangle<Plain> floor;
    floor.vertices[0].position = {-1600, 1600, 1000};
    floor.vertices[1].position = {0, -1600, 1000};
    floor.vertices[2].position = {1600, 1600, 1000};
    floor.vertices[1].shade.point = {repetitions * 32768, 65536};
    floor.vertices[2].shade.point = {repetitions * 65536, 0};
    for (RasterVertex<Plain>& vertex : floor.vertices) vertex.near_over_w.value = 8'000'000;
    floor.vertices[1].near_over_w.value = 2'000'000;
    int pixels = 0;
    int wrong = 0;
    for_each_pixel(floor, lighting, 240, [&](std::int32_t x, std::int32_t y, const auto& run) {
      ++pixels;
      wrong += std::abs(level_of(run, lighting.texture) - level_wanted(floor, x, y, size)) > 0.75 ? 1 : 0;
    });
    CAPTURE(repetitions, pixels, wrong);
    CHECK(pixels > 10000);
    CHECK(wrong == 0);
  }
}

TEST_CASE("no pixel shows a point of the texture more than half a texel away") {
  const int count = test::share_of(300);
  const auto texels = [](const Errors& errors) { return errors.texels; };
  // Most are mapped linearly.
  CHECK(texels(largest_errors<Plain>(1, count, 240, 1.05, 100, 7, 7)) <= 0.5);
  CHECK(texels(largest_errors<Plain>(2, count, 240, 2, 256, 7, 7)) <= 0.5);
  CHECK(texels(largest_errors<Plain>(3, count, 240, 8, 256, 6, 8)) <= 0.5);
  CHECK(texels(largest_errors<Plain>(4, count, 240, 40, 1000, 8, 5)) <= 0.5);
  CHECK(texels(largest_errors<Plain>(5, count, 240, 4, 2000, 10, 10)) <= 0.5);
  // Small ones, and slivers of a pixel.
  CHECK(texels(largest_errors<Plain>(6, 10 * count, 30, 4, 200, 7, 7)) <= 0.5);
  CHECK(texels(largest_errors<Plain>(7, count / 4, 1000, 3, 500, 7, 7)) <= 0.5);
  CHECK(texels(largest_errors<Plain>(8, count / 4, 1000, 1, 1000, 10, 3)) <= 0.5);
}

/// Returns the largest distance in pixels between where texels are shown and where they should be.
template <class ForEachPixel>
double pixels_off(const MappedTriangle<Plain>& triangle, unsigned bits, ForEachPixel&& for_each) {
  double worst = 0;
  for_each([&](std::int32_t x, std::int32_t y, const auto& run) {
    const auto [u, v, level] = triangle.at(x, y);
    const auto right = triangle.at(x + 1, y);
    const auto below = triangle.at(x, y + 1);
    const auto check = [&](std::uint32_t shown, double wanted, double to_right, double to_below) {
      const double per_pixel = std::hypot(to_right - wanted, to_below - wanted) * (1 << bits);
      worst = std::max(worst, texels_off(shown, wanted, bits) / per_pixel);
    };
    check(run.steps().u(), u, right.u, below.u);
    check(run.steps().v(), v, right.v, below.v);
  });
  return worst;
}

TEST_CASE("where texels are larger than pixels, none is shown more than two pixels away") {
  constexpr unsigned kBits = 3;
  Random random(10);
  const Plain::Lighting lighting = lighting_of<Plain>(kBits, kBits);
  for (const double ratio : {1.3, 2., 8., 40.}) {
    double worst = 0;
    double small = 0;
    for (int i = 0; i < test::share_of(200); ++i) {
      const MappedTriangle<Plain> large = random_triangle<Plain>(random, 240, ratio, 1);
      worst = std::max(worst, pixels_off(large, kBits,
                                         [&](auto&& check) { for_each_pixel(large, lighting, 240, check); }));
      const MappedTriangle<Plain> few = random_triangle<Plain>(random, 30, ratio, 0.25);
      small = std::max(small, pixels_off(few, kBits, [&](auto&& check) {
                         for_each_small_pixel(few, lighting, 30, check);
                       }));
    }
    CAPTURE(ratio);
    CHECK(worst <= 2);
    CHECK(small <= 2);
  }
}

TEST_CASE("a cut edge keeps the texture where it is, however many texels it spans") {
  Random random(9);
  const WRange planes{1 << 12, 1 << 30};
  std::int32_t worst = 0;  // in 65536ths of a repetition, 64 of which are a texel of 1024
  int cuts = 0;
  for (int i = 0; i < test::share_of(20000); ++i) {
    ClipPolygon<Plain> polygon;
    // A large floor, on which u and v are proportional to x and w: 64 repetitions in both directions.
    for (std::size_t k = 0; k < 3; ++k) {
      const auto any = [&] { return static_cast<std::int32_t>(random.integer(-32768, 32767)) * 8192; };
      polygon[k].position = {any(), random.integer(1 << 13, 1 << 20), any()};
      polygon[k].shade.point = {polygon[k].position.x >> 7, polygon[k].position.w >> 7};
    }
    clip_polygon(polygon, planes);
    for (std::size_t k = 0; k < polygon.count(); ++k) {
      const auto& [position, shade] = polygon[k];
      worst = std::max(
          {worst, std::abs(shade.point.u - (position.x >> 7)), std::abs(shade.point.v - (position.w >> 7))});
      ++cuts;
    }
  }
  CHECK(cuts > test::share_of(10000));
  CHECK(worst <= 4);
}

TEST_CASE("where one side of a texture repeats often, the other one is as exact as without") {
  constexpr unsigned kWidth = 4;
  constexpr unsigned kHeight = 10;
  Random random(61);
  const Plain::Lighting lighting = lighting_of<Plain>(kWidth, kHeight);
  double worst = 0;
  for (int i = 0; i < test::share_of(400); ++i) {
    const double ratio = i % 2 == 0 ? 1 : random.decades(1, 300);
    MappedTriangle<Plain> triangle = random_triangle<Plain>(random, 240, ratio, random.decades(10, 400));
    for (RasterVertex<Plain>& vertex : triangle.vertices) vertex.shade.point.v >>= 10;
    for_each_pixel(triangle, lighting, 240, [&](std::int32_t x, std::int32_t y, const auto& run) {
      const auto point = triangle.at(x, y);
      worst = std::max({worst, texels_off(run.steps().u(), point.u, kWidth),
                        texels_off(run.steps().v(), point.v, kHeight)});
    });
  }
  CHECK(worst <= 0.5);
}

/// A triangle whose pixels may be more than half a repetition apart.
MappedTriangle<Plain> repeating_triangle(Random& random, std::int32_t extent, double ratio) {
  MappedTriangle<Plain> triangle = random_triangle<Plain>(random, extent, ratio, 0);
  map_plane(random, extent * random.decades(0.1, 4), triangle);
  return triangle;
}

/// Counts the pixels of a triangle, and those whose mip level is not the one that is wanted.
class LevelCounts {
 public:
  explicit LevelCounts(const Plain::Lighting& lighting) : texture_(lighting.texture) {}
  [[nodiscard]] auto of(const MappedTriangle<Plain>& triangle) {
    return [&](std::int32_t x, std::int32_t y, const auto& run) {
      ++pixels;
      const double off = level_of(run, texture_) - level_wanted(triangle, x, y, texture_.size());
      wrong += std::abs(off) > 0.75 ? 1 : 0;
    };
  }
  int pixels = 0;
  int wrong = 0;

 private:
  const decltype(Plain::Lighting::texture)& texture_;
};

TEST_CASE("where pixels are more than half a repetition apart, their mip level is that of the others") {
  constexpr unsigned kBits = 4;
  Random random(62);
  const Plain::Lighting lighting = lighting_of<Plain>(kBits, kBits, kBits + 1);
  LevelCounts large(lighting);
  for (int i = 0; i < test::share_of(300); ++i) {
    const MappedTriangle<Plain> triangle = repeating_triangle(random, 240, i % 2 == 0 ? 1 : 8);
    for_each_pixel(triangle, lighting, 240, large.of(triangle));
  }
  CAPTURE(large.pixels, large.wrong);
  CHECK(large.wrong < large.pixels / 1000);
  LevelCounts small(lighting);
  for (int i = 0; i < test::share_of(6000); ++i) {
    const MappedTriangle<Plain> triangle = repeating_triangle(random, 12, 1);
    for_each_small_pixel(triangle, lighting, 12, small.of(triangle));
  }
  CAPTURE(small.pixels, small.wrong);
  CHECK(small.pixels > test::share_of(10000));
  CHECK(small.wrong < small.pixels / 1000);
}

TEST_CASE(
    "a level of light that is stepped together with u and v is rounded, and leaves them where they are") {
  const int count = test::share_of(300);
  const auto check = [](const Errors& errors) {
    CHECK(errors.texels <= 0.5);
    CHECK(errors.levels > 0.4);  // there are such triangles
    CHECK(errors.levels <= 0.7);
  };
  check(largest_errors<Lit>(11, count, 240, 1.05, 100, 7, 7));
  check(largest_errors<Lit>(12, count, 240, 1, 1000, 10, 10));
  check(largest_errors<Lit>(13, 10 * count, 12, 1.1, 20, 3, 8));
  check(largest_errors<Lit>(14, count / 2, 700, 1, 500, 7, 7));
}

TEST_CASE(
    "a texture point of any value is mapped without undefined behaviour, and its pixels stay in the level") {
  Random random(8);
  const Lit::Lighting lighting = lighting_of<Lit>(10, 3, 4);
  for (int i = 0; i < test::share_of(2000); ++i) {
    MappedTriangle<Lit> triangle = random_triangle<Lit>(random, 40, 1000, 1);
    for (RasterVertex<Lit>& vertex : triangle.vertices) {
      const auto any = [&] { return static_cast<std::int32_t>(random.integer(-32768, 32767)) * 4096; };
      vertex.shade.point = {any(), any()};
      if (random.chance(0.1)) vertex.near_over_w.value = random.integer(0, 3);
    }
    for_each_pixel(triangle, lighting, 40, [&](std::int32_t, std::int32_t, const auto& run) {
      REQUIRE(run.steps().index() < 1u << 13);
    });
  }
}

TEST_CASE("a mip level of one texel is its own neighbour") {
  TextureTriangle triangle{};
  for (int height_bits = 0; height_bits <= 2; ++height_bits) {
    triangle.set({0, static_cast<std::uint8_t>(height_bits), 1}, 0);
    TexelSteps steps(triangle);
    steps.start(0x12345678, 0x87654321);
    const std::uint32_t row = 0x87654321u >> 16 >> (16 - height_bits);
    CHECK(steps.index() == row);
    CHECK(steps.to_right(row) == 0);
    CHECK(steps.below(row) == ((row + 1) & triangle.mask));
  }
}

TEST_CASE(
    "a triangle shows the mip level whose texels are nearest to the longer sides of its pixels in size") {
  using Method = Plain;
  const Method::Lighting lighting = lighting_of<Method>(8, 8, 6);
  // A right angle of some pixels at the same distance everywhere, `repetitions` of 256 texels long.
  const auto level = [&](double repetitions, std::int16_t pixels = 64, double stretch_down = 1) {
    MappedTriangle<Method> triangle;
    const auto length = static_cast<std::int32_t>(repetitions * 65536);
    const auto down = static_cast<std::int32_t>(repetitions * stretch_down * 65536);
    triangle.vertices = {
        RasterVertex<Method>{{0, 0, 0}, {{}, {0, 0}}, {1 << 28}},
        RasterVertex<Method>{{0, static_cast<std::int16_t>(16 * pixels), 0}, {{}, {0, down}}, {1 << 28}},
        RasterVertex<Method>{{static_cast<std::int16_t>(16 * pixels), 0, 0}, {{}, {length, 0}}, {1 << 28}}};
    TriangleCommand<Method> command;
    REQUIRE(prepare_triangle<Method>(lighting, triangle.vertices[0], triangle.vertices[1],
                                     triangle.vertices[2], {}, RowRange{-100, 100}, command));
    const unsigned bits = command.shade.texture.width_bits;
    REQUIRE(command.shade.texture.first == lighting.texture.size().texels(8 - bits));
    return 8 - bits;
  };
  CHECK(level(0.01) == 0);
  CHECK(level(0.25) == 0);  // a texel a pixel
  CHECK(level(0.33) == 0);
  CHECK(level(0.38) == 1);  // 1.5 texels
  CHECK(level(0.5) == 1);
  CHECK(level(1) == 2);
  CHECK(level(4) == 4);
  CHECK(level(100) == 5);      // there is no smaller one
  CHECK(level(0.04, 4) == 1);  // 2.6 texels, on a triangle as small as those of fine meshes
  CHECK(level(0.01, 1) == 1);
  CHECK(level(0.25, 64, 8) == 3);  // as a floor towards the horizon
  CHECK(level(2, 64, 0.125) == 3);
}
