// SPDX-License-Identifier: MIT
// Colours that are interpolated along segments of rows.
#include <arcspan/literature/colour_segment.hpp>
#include <arcspan/literature/phong_segment.hpp>
#include <arcspan/literature/segment.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/illumination_oracle.hpp>
#include <tests/support/test_share.hpp>
#include <tests/support/triangle_picture.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kSize = 64;

std::uint32_t random_level(Random& random) {
  return random.chance(0.2) ? (random.chance(0.5) ? 0u : 1023u)
                            : static_cast<std::uint32_t>(random.integer(0, 1023));
}

Material random_material(Random& random) {
  const auto share = [&random](double most) {
    return Coefficient::from_raw(static_cast<std::int32_t>(random.real(0, most) * 32768));
  };
  const auto channels = [&share](double most) {
    ChannelCoefficients c;
    c.r = share(most);
    c.g = share(most);
    c.b = share(most);
    return c;
  };
  Material material;
  material.ambient = channels(0.3);
  material.diffuse = channels(1);
  material.specular = channels(1);
  material.shininess = static_cast<std::int32_t>(random.decades(1, 256));
  return material;
}

template <class Lit>
Lit random_light(Random& random, const Direction& near) {
  std::array<DirectionalLight, Lit::kLights> lights;
  const Vec3 normal = to_vec3(near);
  for (DirectionalLight& light : lights) {
    light.towards = to_direction(tilted(random, normal, random.real(0, 1.8)));
    light.strength = Coefficient::from_raw(static_cast<std::int32_t>(32768 / Lit::kLights));
  }
  const Vec3 eye = tilted(random, normal, random.real(0, 1.2));
  Lit lit;
  const Material material = random_material(random);
  REQUIRE(ok(Lit::make(material, lights, to_direction(eye), lit)));
  return lit;
}

}  // namespace

TEST_CASE("a colour segment is exact at both ends and rounds down between") {
  Random random(1);
  for (int i = 0; i < share_of(20000); ++i) {
    const int bits = static_cast<int>(random.integer(0, ColourSegment::kFraction));
    std::array<std::uint32_t, 3> from{};
    std::array<std::uint32_t, 3> to{};
    for (std::uint32_t& c : from) c = random_level(random);
    for (std::uint32_t& c : to) c = random_level(random);
    ColourSegment colour = ColourSegment::of(PackedRgb::of(from[0], from[1], from[2]));
    const ColourSegment end = ColourSegment::of(PackedRgb::of(to[0], to[1], to[2]));
    const ColourSegment step = colour.step_to(end, bits);
    for (std::uint32_t k = 0; k <= 1u << bits; ++k) {
      const auto level = [&](std::size_t c) { return (from[c] * ((1u << bits) - k) + to[c] * k) >> bits; };
      const PackedRgb expected = PackedRgb::of(level(0), level(1), level(2));
      REQUIRE(colour.packed().lanes == expected.lanes);
      REQUIRE(Rgb565::encode(colour) == Rgb565::encode(expected));
      colour.advance(step);
    }
  }
}

TEST_CASE("a patch's stride is its single steps, to the last bit") {
  Random random(2);
  for (int i = 0; i < share_of(5000); ++i) {
    const auto any = [&random](int down) {
      return Cosine::from_raw(static_cast<std::int32_t>(random.bits()) >> down);
    };
    literature::SecondDifferenceRun<1> single;
    single.of[0] = {any(2), any(random.integer(6, 20)), any(random.integer(10, 20))};
    literature::SecondDifferenceRun<1> stride = single;
    const int bits = static_cast<int>(random.integer(0, 4));
    stride.stride(bits);
    for (int k = 0; k < 5; ++k) {
      REQUIRE(stride.scalars() == single.scalars());
      stride.next();
      for (int n = 0; n < 1 << bits; ++n) single.next();
    }
  }
}

TEST_CASE(
    "segments begin with the colour of their first pixel, and their error falls with the square of their "
    "length") {
  using Lit = Illumination<1, Highlight::kPhong>;
  Random random(4);
  std::array<double, kMostSegmentBits + 1> squares{};
  for (int i = 0; i < 300; ++i) {
    const ScreenTriangle triangle = random_screen_triangle(random, kSize, 30);
    const Lit lit = random_light<Lit>(random, triangle.normals[0]);
    const TrianglePicture exact = picture_of<Arc<Lit>>(triangle, lit, kSize);
    for (int bits = 1; bits <= kMostSegmentBits; ++bits) {
      SegmentedIllumination<Lit> lighting(lit);
      REQUIRE(ok(lighting.set_segment_bits(bits)));
      const TrianglePicture near = picture_of<Segment<Lit>>(triangle, lighting, kSize);
      for (std::int32_t y = 0; y < kSize; ++y) {
        bool first = true;
        for (std::int32_t x = 0; x < kSize; ++x) {
          const Rgb8 colour = exact.frame.pixel(x, y);
          if (colour == Rgb8{}) continue;
          const int off = difference(colour, near.frame.pixel(x, y));
          if (first) REQUIRE(off <= 2);  // Arc interpolates otherwise
          first = false;
          squares[static_cast<std::size_t>(bits)] += off * off;
        }
      }
    }
  }
  for (int bits = 2; bits <= kMostSegmentBits; ++bits) {
    CAPTURE(bits, squares[static_cast<std::size_t>(bits)], squares[static_cast<std::size_t>(bits - 1)]);
    // The longest do not fit many rows.
    CHECK(squares[static_cast<std::size_t>(bits)] >
          (bits == kMostSegmentBits ? 1.4 : 2) * squares[static_cast<std::size_t>(bits - 1)]);
  }
}

TEST_CASE("adaptive segments are as long as an error of 1/64 allows") {
  using arcspan::literature::adaptive_segment_bits;
  const Normal up{NormalComponent::of(0.0), NormalComponent::of(0.0), NormalComponent::of(1.0)};
  const auto bits = [&up](double radians_per_pixel, int exponent) {
    const auto step = Linear::from_raw(static_cast<std::int32_t>(std::ldexp(radians_per_pixel, 27)));
    return adaptive_segment_bits((1u << 25) / static_cast<std::uint32_t>(exponent), {step, {}, {}}, up, up,
                                 up);
  };
  // psi^2 n/8 = 1/64 at psi = 0.354 / sqrt(n).
  CHECK(bits(0, 64) == 4);
  CHECK(bits(0.353 / 16, 1) == 4);
  CHECK(bits(0.355 / 16, 1) == 3);
  CHECK(bits(0.353 / 8 / 16, 64) == 4);
  CHECK(bits(0.355 / 8 / 2, 64) == 0);
  CHECK(bits(15, 1) == 0);
  using Lit = Illumination<1, Highlight::kBlinn>;
  Random random(6);
  int longer = 0;
  for (int i = 0; i < 200; ++i) {
    const ScreenTriangle triangle = random_screen_triangle(random, kSize, 40);
    const Lit lit = random_light<Lit>(random, triangle.normals[0]);
    // At N·L = 0 highlights end abruptly, within a segment too.
    const bool lit_throughout =
        std::all_of(triangle.normals.begin(), triangle.normals.end(),
                    [&lit](const Direction& normal) { return lit.scalars(normal)[0] > Cosine::of(0.2); });
    if (!lit_throughout) continue;
    const TrianglePicture exact = picture_of<Phong<Lit>>(triangle, lit, kSize);
    SegmentedIllumination<Lit> adaptive(lit);
    REQUIRE(ok(adaptive.set_adaptive_segments(static_cast<std::int32_t>(lit.shininess()))));
    const TrianglePicture near = picture_of<PhongSegment<Lit>>(triangle, adaptive, kSize);
    int most = 0;
    for (std::int32_t y = 0; y < kSize; ++y) {
      for (std::int32_t x = 0; x < kSize; ++x) {
        const int off = difference(exact.frame.pixel(x, y), near.frame.pixel(x, y));
        most = std::max(most, off);
      }
    }
    CAPTURE(i, lit.shininess(), most);
    CHECK(most <=
          14);  // 255/64 each of diffuse light and highlight; more in segments that leave the triangle
    if (most > 1) ++longer;
  }
  CHECK(longer > 10);
}

TEST_CASE("settings out of range are refused and change nothing") {
  using Lit = Illumination<1, Highlight::kBlinn>;
  Random random(5);
  const Lit lit = random_light<Lit>(random, to_direction(Vec3{0, 0, 1}));
  SegmentedIllumination<Lit> segments(lit);
  CHECK(segments.set_segment_bits(0) == Status::kInvalidArgument);
  CHECK(segments.set_segment_bits(kMostSegmentBits + 1) == Status::kInvalidArgument);
  CHECK(segments.bits == 2);
  CHECK(segments.set_adaptive_segments(0) == Status::kInvalidArgument);
  CHECK(segments.set_adaptive_segments(257) == Status::kInvalidArgument);
  CHECK(segments.widest == 0);
}
