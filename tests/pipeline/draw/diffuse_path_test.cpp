// SPDX-License-Identifier: MIT
// Leaving the highlight's scalars out where no highlight is within reach must not change a pixel; by two
// lights, only by rounding.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/arc/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/random.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

using namespace arcspan;

namespace {

constexpr std::int32_t kSize = 160;
constexpr std::int32_t kRadius = 16384;
// Small triangles carry N·L alone with a bit less, because it is for wider normals too.
constexpr DrawFeatures kFeatures{
    .clips = false, .two_sided = false, .caches = false, .planes = false, .small_triangles = false};

/// Never leaves a scalar out.
template <class Light>
struct Cautious : Light {
  using Scalars = typename Light::Scalars;
  [[nodiscard]] constexpr bool may_shine(const Scalars&, const Scalars&, const Scalars&, Cosine) const {
    return true;
  }
};

template <class Light>
std::vector<std::uint16_t> picture(const MeshView& mesh, std::int32_t shininess, const Direction& towards) {
  Placement placement{Rotation::about_x({4551}) * Rotation::about_y({3000}), {}};
  placement.translation[2] = ObjectLength::of(-4 * kRadius);
  ClipTransform transform;
  REQUIRE(ok(ClipTransform::make(placement,
                                 {PixelLength::of(280), ObjectLength::of(32768), ObjectLength::of(98304)},
                                 {kSize, kSize}, transform)));
  constexpr Coefficient kHalf = Coefficient::of(0.5);
  const Material material{{kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, shininess};
  std::array<DirectionalLight, Light::kLights> lights{};
  lights[0].towards = placement.rotation.to_object(towards);
  if constexpr (Light::kLights > 1) lights[1].towards = placement.rotation.to_object(normalised(-2, 1, 1));
  Light light;
  REQUIRE(ok(Light::make(material, lights, placement.rotation.to_object(normalised(0, 0, 1)), light)));
  std::vector<std::uint16_t> memory(hal::Framebuffer<Rgb565>::words(kSize, kSize));
  hal::Framebuffer<Rgb565> frame(memory, kSize, kSize);
  frame.clear({0, 0, 0});
  const DrawResult result = draw_mesh<Arc<Light>, kFeatures>(mesh, transform, light, frame, NoDepth{});
  REQUIRE(ok(result.status));
  REQUIRE(result.left_out == 0);
  return memory;
}

struct Difference {
  int pixels = 0;  ///< that differ
  int most = 0;    ///< of a channel, in steps of the format
};

/// Draws spheres so fine that their triangles are quadratic patches even with sharp highlights, with and
/// without scalars left out.
template <class Light>
Difference difference() {
  test::Random random(3);
  const test::TestMesh sphere = test::make_sphere(32, 64, kRadius, 0, random);
  const MeshView mesh = sphere.view();
  Difference found;
  for (const std::int32_t shininess : {1, 4, 16, 64, 256}) {
    for (const Direction& towards : {normalised(1, 2, 3), normalised(-3, 1, 0), normalised(1, 1, -2)}) {
      const auto some = picture<Light>(mesh, shininess, towards);
      const auto all = picture<Cautious<Light>>(mesh, shininess, towards);
      for (std::size_t i = 0; i < some.size(); ++i) {
        if (some[i] == all[i]) continue;
        ++found.pixels;
        for (const auto& [shift, mask] : {std::pair{0, 31}, {5, 63}, {11, 31}}) {
          const int steps = std::abs(((some[i] >> shift) & mask) - ((all[i] >> shift) & mask));
          found.most = std::max(found.most, steps);
        }
      }
    }
  }
  return found;
}

}  // namespace

TEST_CASE("triangles out of the highlight's reach look the same without its scalar") {
  CHECK(difference<Illumination<1, Highlight::kBlinn>>().pixels == 0);
  CHECK(difference<Illumination<1, Highlight::kPhong>>().pixels == 0);
}

// A light's horizon runs through some triangles, where N·L of every light is carried. Elsewhere that is their
// mean, which is rounded once instead of twice.
TEST_CASE("by two lights, triangles out of the reach of highlights look the same but for rounding") {
  const auto check = [](const Difference& found) {
    CHECK(found.pixels < 100);  // of some 240,000
    CHECK(found.most <= 1);
  };
  check(difference<Illumination<2, Highlight::kBlinn>>());
  check(difference<Illumination<2, Highlight::kPhong>>());
}
