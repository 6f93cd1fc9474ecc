// SPDX-License-Identifier: MIT
// What is shown beyond the borders of a texture, for each sampler, against double precision.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/with_operation.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/texture/mapped_triangle.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/misuse_recorder.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

template <TextureFilter Filter>
using Bordered = Textured<Unlit, DirectTexels<>, TexelLight::kNone, Filter, TextureBorders::kOfTexture>;

constexpr TextureSize kSmall{6, 4, 1};
constexpr TextureSize kLarge{10, 10, 1};

template <class Method>
typename Method::Lighting bordered_texture(const TextureSize& size, const TextureSampler& sampler) {
  static const std::vector<std::uint16_t> kWords(kLarge.texels(1));
  Texture<DirectTexels<>> texture;
  REQUIRE(ok(Texture<DirectTexels<>>::make(kWords, size, texture)));
  typename Method::Lighting lighting;
  lighting.set(texture.with(sampler));
  return lighting;
}

/// u or v along one axis, in texels.
struct Axis {
  TextureWrap wrap;
  double texels;
  bool bilinear;

  /// Where the colour is that belongs to a place, from the middle of the first texel to that of the last one
  /// unless the texture repeats.
  [[nodiscard]] double right(double place) const {
    if (wrap == TextureWrap::kRepeat) return place - texels * std::floor(place / texels);
    if (wrap == TextureWrap::kMirror) {
      place -= 2 * texels * std::floor(place / (2 * texels));
      place = std::min(place, 2 * texels - place);
    }
    return std::clamp(place, 0.5, texels - 0.5);
  }
  /// Where the colour is that is shown: a texel, mixed with the one at the distance `step` by `fraction` of
  /// 32. Infinity if the sampler does not mix these.
  [[nodiscard]] double shown(std::int32_t texel, std::int32_t step, std::uint32_t fraction) const {
    if (texel < 0 || texel >= texels || texel + step < 0 || texel + step >= texels) return INFINITY;
    if (!bilinear) return texel + 0.5;
    const bool at_border = texel == 0 || texel + 1 == texels;
    if (wrap == TextureWrap::kRepeat && step == 1 - texels) step = 1;
    const bool is_right = step == 1 || (step == 0 && at_border && wrap != TextureWrap::kRepeat) ||
                          (step == -1 && wrap == TextureWrap::kMirror);
    if (!is_right) return INFINITY;
    return texel + 0.5 + step * (fraction / 32.0);
  }
  /// The distance of both, beyond the half texel or the 32nd by which what can be shown is apart.
  [[nodiscard]] double off(double right, double shown) const {
    const double distance = std::abs(right - shown);
    const bool around = wrap == TextureWrap::kRepeat && distance > texels / 2;
    return (around ? texels - distance : distance) - (bilinear ? 1.0 / 32 : 0.5);
  }
};

/// How a set of random triangles is drawn.
struct Case {
  std::uint64_t seed;
  int count;
  std::int32_t size;  ///< of the picture
  double ratio;       ///< of distances
  double range;       ///< repetitions
  TextureSize texture = kSmall;
};

/// The largest Axis::off() of all pixels, in texels.
template <TextureFilter Filter>
double largest_distance(const Case& c, TextureWrap u_wrap, TextureWrap v_wrap) {
  using Method = Bordered<Filter>;
  Random random(c.seed);
  const auto lighting = bordered_texture<Method>(c.texture, {u_wrap, v_wrap, Filter});
  constexpr bool kMixes = Filter == TextureFilter::kBilinear;
  const Axis columns{u_wrap, std::ldexp(1, c.texture.width_bits), kMixes};
  const Axis rows{v_wrap, std::ldexp(1, c.texture.height_bits), kMixes};
  double worst = 0;
  std::size_t within = 0;
  std::size_t beyond = 0;
  for (int i = 0; i < c.count; ++i) {
    const auto triangle = random_triangle<Method>(random, c.size, c.ratio, random.real(0.01, c.range));
    for_each_pixel(triangle, lighting, c.size, [&](std::int32_t x, std::int32_t y, const auto& run) {
      const BorderSteps& steps = run.steps();
      const auto at = triangle.at(x, y);
      const BorderSteps::Around square = steps.around();
      const auto here = static_cast<std::int32_t>(steps.index());
      if (square.index() != steps.index()) worst = INFINITY;
      const std::int32_t column = here & ((1 << c.texture.width_bits) - 1);
      const auto right = static_cast<std::int32_t>(square.to_right(0));
      const std::int32_t down = static_cast<std::int32_t>(square.below(0)) - here;
      if (down % (1 << c.texture.width_bits) != 0) worst = INFINITY;
      worst = std::max({worst,
                        columns.off(columns.right(at.u * columns.texels),
                                    columns.shown(column, right, steps.fraction_right())),
                        rows.off(rows.right(at.v * rows.texels),
                                 rows.shown(here >> c.texture.width_bits, down / (1 << c.texture.width_bits),
                                            steps.fraction_below()))});
      for (const double place : {at.u, at.v}) (place >= 0 && place < 1 ? within : beyond) += 1;
    });
  }
  if (share_of(100) == 100) {  // a few triangles may lie on one side of the border
    CHECK(within > beyond / 60);
    CHECK(beyond > within / 20);
  }
  return worst;
}

/// What is reported where a cube with a sampler is drawn.
template <class Method>
std::vector<std::string> misuse_of(const TextureSampler& sampler) {
  const TestMesh cube = make_smooth_cube(1000);
  const std::vector<TexturePoint> points(cube.positions.size());
  MeshView mesh = cube.view();
  REQUIRE(ok(mesh.attach(points, TextureScale{12})));
  TestCamera camera;
  camera.translation = {0, 0, -5000};
  std::vector<std::uint16_t> memory(hal::Framebuffer<Rgb565>::words(camera.width, camera.height));
  hal::Framebuffer<Rgb565> frame(memory, camera.width, camera.height);
  const auto lighting = bordered_texture<Method>(kSmall, sampler);
  MisuseRecorder recorder;
  REQUIRE(ok(draw_mesh<Method>(mesh, camera.transform(), lighting, frame, NoDepth{}).status));
  return recorder.take();
}

}  // namespace

TEST_CASE("each axis of a texture shows what its sampler says beyond the borders") {
  const TextureWrap u = GENERATE(TextureWrap::kRepeat, TextureWrap::kClamp, TextureWrap::kMirror);
  const TextureWrap v = GENERATE(TextureWrap::kRepeat, TextureWrap::kClamp, TextureWrap::kMirror);
  CAPTURE(static_cast<int>(u), static_cast<int>(v));
  const int count = share_of(200);
  const Case linear{1, count, 150, 1.0001, 8};
  const Case perspective{2, count, 150, 8, 8};
  const Case small{3, 8 * count, 2, 2, 3};
  const Case fine{7, count / 8, 500, 1, 2, kLarge};
  CHECK(largest_distance<TextureFilter::kNearest>(linear, u, v) < 0.1);
  CHECK(largest_distance<TextureFilter::kNearest>(perspective, u, v) < 0.5);
  CHECK(largest_distance<TextureFilter::kNearest>(small, u, v) < 0.6);
  CHECK(largest_distance<TextureFilter::kNearest>(fine, u, v) < 0.2);
  CHECK(largest_distance<TextureFilter::kBilinear>(linear, u, v) < 0.1);
  CHECK(largest_distance<TextureFilter::kBilinear>(perspective, u, v) < 0.5);
  CHECK(largest_distance<TextureFilter::kBilinear>(small, u, v) < 0.6);
}

TEST_CASE("points far beyond a texture stay within it") {
  using Method = Bordered<TextureFilter::kBilinear>;
  const TextureWrap wrap = GENERATE(TextureWrap::kRepeat, TextureWrap::kClamp, TextureWrap::kMirror);
  const auto lighting = bordered_texture<Method>(kSmall, {wrap, wrap});
  Random random(6);
  for (int i = 0; i < share_of(1000); ++i) {
    auto triangle = random_triangle<Method>(random, 40, 100, 1);
    for (auto& vertex : triangle.vertices) {
      const std::int32_t most = (std::int32_t{1} << 27) - 1;
      vertex.shade.point = {random.integer(-most, most), random.integer(-most, most)};
    }
    for_each_pixel(triangle, lighting, 40, [&](std::int32_t, std::int32_t, const auto& run) {
      const BorderSteps::Around square = run.steps().around();
      const std::uint32_t here = square.index();
      const std::uint32_t right = square.to_right(here);
      const std::uint32_t below = square.below(here);
      for (const std::uint32_t texel : {run.steps().index(), here, here + right, below, below + right}) {
        if (texel >= kSmall.texels(1)) FAIL("a texel outside of the texture");
      }
    });
  }
}

TEST_CASE("builds with checks report a texture whose borders its method does not show") {
  using Plain = Textured<Unlit, DirectTexels<>>;
  const TextureSampler clamped{TextureWrap::kRepeat, TextureWrap::kClamp};
  const std::vector<std::string> misuse{
      "draw: a texture that does not repeat was given to a method of TextureBorders::kRepeat"};
  CHECK(misuse_of<Plain>({TextureWrap::kMirror, TextureWrap::kRepeat}) ==
        (kIsChecked ? misuse : std::vector<std::string>{}));
  CHECK(misuse_of<WithOperation<Plain, ScreenDoor>>(clamped).size() == (kIsChecked ? 1 : 0));
  CHECK(misuse_of<Plain>({}).empty());
  CHECK(misuse_of<Bordered<TextureFilter::kNearest>>(clamped).empty());
}

TEST_CASE("the sampler of a texture takes no memory") {
  STATIC_REQUIRE(sizeof(TextureSampler) == 1);
  struct WithoutSampler {
    const void* words;
    const void* palette;
    std::uint32_t size;
  };
  STATIC_REQUIRE(sizeof(Texture<DirectTexels<>>) == sizeof(WithoutSampler));
}
