// SPDX-License-Identifier: MIT
// Textures that do not repeat: the texels along the border are shown beyond it, against double precision.
#include <catch2/catch.hpp>
#include <tests/pipeline/texture/mapped_triangle.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

template <TextureFilter Filter>
using Clamped = Textured<Unlit, DirectTexels<>, TexelLight::kNone, Filter, TextureWrap::kClamp>;

constexpr TextureSize kSmall{6, 4, 1};
constexpr TextureSize kLarge{10, 10, 1};

template <class Method>
typename Method::Lighting clamped_texture(const TextureSize& size) {
  static const std::vector<std::uint16_t> kWords(kLarge.texels(1));
  typename Method::Lighting lighting;
  REQUIRE(ok(Texture<DirectTexels<>>::make(kWords, size, lighting.texture)));
  return lighting;
}

/// How far the texel or the mixture of texels that is shown is from the right one, in texels.
struct Shown {
  double column;
  double row;
};
template <TextureFilter Filter>
Shown shown_by(const ClampedSteps& steps, const TextureSize& size) {
  const std::uint32_t index = steps.index();
  const std::uint32_t column = index & ((1u << size.width_bits) - 1);
  const std::uint32_t row = index >> size.width_bits;
  REQUIRE(row < 1u << size.height_bits);
  if (Filter == TextureFilter::kNearest) return {column + 0.5, row + 0.5};
  const std::uint32_t right = index + steps.to_right(index);
  const std::uint32_t below = steps.below(index);
  REQUIRE((right == index || (right == index + 1 && column + 1 < 1u << size.width_bits)));
  REQUIRE((below == index || (below == index + (1u << size.width_bits) && row + 1 < 1u << size.height_bits)));
  // The middles of texels are their places.
  return {column + 0.5 + (right != index ? steps.fraction_right() / 32.0 : 0),
          row + 0.5 + (below != index ? steps.fraction_below() / 32.0 : 0)};
}

/// The largest distance of what is shown from the right place in the texture, beyond the half texel or the
/// 32nd by which texels are apart.
template <TextureFilter Filter>
double largest_distance(std::uint64_t seed, int count, std::int32_t size, double ratio, double range,
                        const TextureSize& texture = kSmall) {
  using Method = Clamped<Filter>;
  Random random(seed);
  const auto lighting = clamped_texture<Method>(texture);
  const double step = Filter == TextureFilter::kNearest ? 0.5 : 1.0 / 32;
  double worst = 0;
  std::size_t within = 0;
  std::size_t beyond = 0;
  const auto along = [&](double place, double shown, unsigned bits) {
    const double texels = 1 << bits;
    const double right = std::clamp(place * texels, 0.5, texels - 0.5);
    (right == place * texels ? within : beyond) += 1;
    worst = std::max(worst, std::abs(shown - right) - step);
  };
  for (int i = 0; i < count; ++i) {
    const auto triangle = random_triangle<Method>(random, size, ratio, random.real(0.01, range));
    for_each_pixel(triangle, lighting, size, [&](std::int32_t x, std::int32_t y, const auto& run) {
      const auto [u, v, level] = triangle.at(x, y);
      const Shown shown = shown_by<Filter>(run.steps(), texture);
      along(u, shown.column, texture.width_bits);
      along(v, shown.row, texture.height_bits);
    });
  }
  CHECK(within > 0);
  CHECK(beyond > 0);
  if (share_of(100) == 100) {  // a few triangles may lie on one side of the border
    CHECK(within > beyond / 60);
    CHECK(beyond > within / 20);
  }
  return worst;
}

}  // namespace

TEST_CASE("beyond its borders a clamped texture shows the texels along them") {
  const int count = share_of(1000);
  CHECK(largest_distance<TextureFilter::kNearest>(1, count, 150, 1.0001, 8) < 0.1);
  CHECK(largest_distance<TextureFilter::kNearest>(2, count, 150, 8, 8) < 0.5);
  CHECK(largest_distance<TextureFilter::kNearest>(3, count, 2, 2, 3) < 0.6);
  CHECK(largest_distance<TextureFilter::kNearest>(7, count / 8, 500, 1, 2, kLarge) < 0.2);
  CHECK(largest_distance<TextureFilter::kBilinear>(4, count, 150, 1.0001, 8) < 0.1);
  CHECK(largest_distance<TextureFilter::kBilinear>(5, count, 150, 8, 8) < 0.5);
}

TEST_CASE("points far beyond a clamped texture stay within it") {
  using Method = Clamped<TextureFilter::kNearest>;
  const auto lighting = clamped_texture<Method>(kSmall);
  Random random(6);
  for (int i = 0; i < share_of(3000); ++i) {
    auto triangle = random_triangle<Method>(random, 40, 100, 1);
    for (auto& vertex : triangle.vertices) {
      const std::int32_t most = (std::int32_t{1} << 27) - 1;
      vertex.shade.point = {random.integer(-most, most), random.integer(-most, most)};
    }
    for_each_pixel(triangle, lighting, 40, [&](std::int32_t, std::int32_t, const auto& run) {
      if (run.steps().index() >= kSmall.texels(1)) FAIL("a texel outside of the texture");
    });
  }
}
