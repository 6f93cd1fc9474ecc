// SPDX-License-Identifier: MIT
// Texels under light against double precision, for every channel and every level of light.
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/textured/texel_light.hpp>
#include <arcspan/shading/textured/texel_sampling.hpp>
#include <arcspan/shading/textured/texture_row.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

using namespace arcspan;

namespace {

/// Light of a level of 8 bits as shading passes it on.
PackedRgb grey_light(std::uint32_t level) { return PackedRgb::grey(4 * level + 2); }

/// A texel under light of which nothing is looked up.
template <TexelLight Colours>
LitTexel<Colours> lit_texel(std::uint16_t texel, const PixelLight& light) {
  using Lit = LitTexel<Colours>;
  return {texel, light, Lit::factor_of(light.diffuse), Lit::shine_of(light.highlight)};
}

/// The statistics of errors, in 8-bit steps.
struct Errors {
  double sum = 0;
  double worst = 0;
  int count = 0;

  void add(double error) {
    sum += error;
    worst = std::max(worst, std::abs(error));
    ++count;
  }
  [[nodiscard]] double mean() const { return sum / count; }
};

}  // namespace

TEST_CASE("a lit texel has no bias, and is within a step of its format", "[textures]") {
  Errors red;
  Errors green;
  Errors deep;
  Errors coloured;
  for (std::uint32_t texel = 0; texel < 64; ++texel) {
    for (std::uint32_t level = 0; level < 256; ++level) {
      const double share = level / 255.0;
      const PackedRgb light = grey_light(level);
      const auto pixel = static_cast<std::uint16_t>(((texel >> 1) << 11) | (texel << 5) | (texel >> 1));
      const auto grey = lit_texel<TexelLight::kGrey>(pixel, {light, {}});
      const auto any = lit_texel<TexelLight::kColoured>(pixel, {light, {}});
      red.add(255 / 31.0 * ((grey.rgb565() >> 11) - (texel >> 1) * share));
      green.add(255 / 63.0 * ((grey.rgb565() >> 5 & 63) - texel * share));
      coloured.add(255 / 63.0 * ((any.rgb565() >> 5 & 63) - texel * share));
      deep.add(grey.packed().rgb8().g - texel * share * 255 / 63);
    }
  }
  CHECK(std::abs(red.mean()) <= 0.5);
  CHECK(std::abs(green.mean()) <= 0.5);
  CHECK(std::abs(coloured.mean()) <= 0.5);
  CHECK(std::abs(deep.mean()) <= 0.5);
  // Half a step of the format by rounding, and half a level of light.
  CHECK(red.worst <= 0.75 * 255 / 31);
  CHECK(green.worst <= 255 / 63.0);
  CHECK(coloured.worst <= 255 / 63.0);
  CHECK(deep.worst <= 1.5);
}

TEST_CASE("every channel of a lit texel is its product with the level, rounded", "[textures]") {
  for (std::uint32_t value = 0; value < 65536; value += 5) {
    for (std::uint32_t level = 0; level <= 64; ++level) {
      const std::uint32_t lit = detail::joined_wide(detail::lit_pixel(value, detail::light_factor(level)));
      const auto rounded = [level](std::uint32_t channel) { return (channel * level + 32) >> 6; };
      const std::uint32_t wanted =
          (rounded(value >> 11) << 11) | (rounded(value >> 5 & 63) << 5) | rounded(value & 31);
      if (lit != wanted) REQUIRE(std::pair(value, level) == std::pair(lit, wanted));
    }
  }
}

TEST_CASE("full light keeps every texel, no light leaves nothing, highlights are added and saturate",
          "[textures]") {
  for (std::uint32_t value = 0; value < 65536; value += 7) {
    const auto texel = static_cast<std::uint16_t>(value);
    const PackedRgb full = grey_light(255);
    const PackedRgb none = grey_light(0);
    constexpr auto kGrey = TexelLight::kGrey;
    constexpr auto kColoured = TexelLight::kColoured;
    REQUIRE(lit_texel<kGrey>(texel, {full, {}}).rgb565() == texel);
    REQUIRE(lit_texel<kColoured>(texel, {full, {}}).rgb565() == texel);
    REQUIRE(Rgb565::encode(lit_texel<kGrey>(texel, {full, {}}).packed()) == texel);
    REQUIRE(lit_texel<kGrey>(texel, {none, {}}).rgb565() == 0);
    REQUIRE(lit_texel<kColoured>(texel, {none, {}}).rgb565() == 0);
    const PackedRgb white = PackedRgb::grey(1020);
    REQUIRE(lit_texel<kGrey>(texel, {full, white}).rgb565() == 0xFFFF);
    const PackedRgb half = PackedRgb::grey(512);
    const std::uint16_t shining = lit_texel<kGrey>(texel, {full, half}).rgb565();
    REQUIRE((shining >> 11) == std::min<std::uint32_t>(31, (value >> 11) + 16));
    REQUIRE((shining >> 5 & 63) == std::min<std::uint32_t>(63, (value >> 5 & 63) + 32));
    REQUIRE((shining & 31) == std::min<std::uint32_t>(31, (value & 31) + 16));
  }
}

TEST_CASE("four texels are mixed by their distances, across the borders of the texture too", "[textures]") {
  test::Random random(31);
  std::array<std::uint16_t, 64> words{};
  for (std::uint16_t& word : words) word = static_cast<std::uint16_t>(random.bits());
  TextureTriangle triangle{};
  triangle.set({3, 3, 1}, 0);
  TexelSteps steps(triangle);
  Errors errors;
  for (int i = 0; i < 20000; ++i) {
    const auto u = static_cast<std::uint32_t>(random.bits());
    const auto v = static_cast<std::uint32_t>(random.bits());
    steps.start(u, v);
    const double x = std::ldexp(u, -29);  // in texels, of which this method shows four
    const double y = std::ldexp(v, -29);
    const auto column = static_cast<std::uint32_t>(x);
    const auto row = static_cast<std::uint32_t>(y);
    const auto green = [&](std::uint32_t right, std::uint32_t down) {
      return words[((row + down) & 7) * 8 + ((column + right) & 7)] >> 5 & 63;
    };
    const double to_right = x - column;
    const double down = y - row;
    const double upper = green(0, 0) * (1 - to_right) + green(1, 0) * to_right;
    const double lower = green(0, 1) * (1 - to_right) + green(1, 1) * to_right;
    const SampledTexel shown = bilinear_texel<DirectTexels<>>(words.data(), nullptr, steps);
    errors.add((shown.rgb565 >> 5 & 63) - (upper * (1 - down) + lower * down));
    REQUIRE(shown.opacity == 16);
  }
  // A 32nd is cut off each fraction, and three mixtures are rounded.
  CHECK(errors.worst <= 4);
  CHECK(std::abs(errors.mean()) <= 0.3);
}

TEST_CASE("coloured light tints texels", "[textures]") {
  const PackedRgb orange = PackedRgb::of(1022, 512, 2);
  const std::uint16_t lit = lit_texel<TexelLight::kColoured>(0xFFFF, {orange, {}}).rgb565();
  CHECK((lit >> 11) == 31);
  CHECK((lit >> 5 & 63) == 32);
  CHECK((lit & 31) == 0);
}
