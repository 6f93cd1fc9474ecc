// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

/// The scenes of these tests. They use few methods and one sink, because each further combination compiles
/// the whole pipeline again.
namespace arcspan::test {

using SceneLighting = Illumination<2, Highlight::kBlinn>;
using SceneMethod = Arc<SceneLighting>;
using SceneMethods = MethodList<SceneMethod, Unlit>;
using Picture = hal::Framebuffer<Rgb888>;

[[nodiscard]] inline double to_double(WorldLength v) { return std::ldexp(v.raw(), -16); }
[[nodiscard]] inline WorldLength to_world(double v) {
  return WorldLength::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(v, 16))));
}
[[nodiscard]] inline WorldPoint to_point(Vec3 v) { return {to_world(v.x), to_world(v.y), to_world(v.z)}; }
[[nodiscard]] inline Vec3 to_vec3(const WorldPoint& p) {
  return {to_double(p.x), to_double(p.y), to_double(p.z)};
}

/// `v` turned by the integer rotation, in double precision.
[[nodiscard]] inline Vec3 turned(const Rotation& rotation, Vec3 v) {
  const auto row = [&](std::size_t i) {
    return std::ldexp(
        rotation.m[i][0].raw() * v.x + rotation.m[i][1].raw() * v.y + rotation.m[i][2].raw() * v.z, -30);
  };
  return {row(0), row(1), row(2)};
}

[[nodiscard]] inline Rotation random_rotation(Random& random) {
  const auto turn = [&] { return Turn{static_cast<std::uint16_t>(random.bits())}; };
  return rotation_of(EulerAngles{turn(), turn(), turn()});
}

/// A picture with its depth buffer, or a band of one.
struct Canvas {
  static constexpr std::int32_t kWidth = 96;
  static constexpr std::int32_t kHeight = 72;

  std::vector<Picture::Word> pixels;
  std::vector<std::uint16_t> depths;
  Picture picture;
  DepthBuffer depth;

  explicit Canvas(std::int32_t rows = kHeight)
      : pixels(Picture::words(kWidth, rows)),
        depths(DepthBuffer::words(kWidth, rows)),
        picture(pixels, kWidth, rows),
        depth(depths, kWidth, rows) {
    clear();
  }
  void clear() {
    picture.clear({10, 20, 30});
    depth.clear();
  }
  void move_to(std::int32_t row) {
    picture.move_to(row);
    depth.move_to(row);
    clear();
  }
};

inline constexpr SceneLight kSceneLights[] = {
    SceneLight::directional(arcspan::normalised(3, 4, 5), Coefficient::of(0.7)),
    SceneLight::point(WorldPoint::of(-4, 3, 2), WorldLength::of(6), Coefficient::of(0.8))};
inline constexpr LightList kLights{kSceneLights};

[[nodiscard]] constexpr Material matter(Coefficient red, Coefficient green, Coefficient blue) {
  constexpr Coefficient kHalf = Coefficient::of(0.5);
  constexpr Coefficient kLittle = Coefficient::of(0.1);
  return {{kLittle, kLittle, kLittle}, {red, green, blue}, {kHalf, kHalf, kHalf}, 24};
}
inline constexpr auto kCopper = PreparedMaterial<SceneMethod>::of(
    matter(Coefficient::of(0.8), Coefficient::of(0.4), Coefficient::of(0.2)), kLights);
inline constexpr auto kJade = PreparedMaterial<SceneMethod>::of(
    matter(Coefficient::of(0.2), Coefficient::of(0.7), Coefficient::of(0.4)), kLights);
inline constexpr PreparedMaterial<Unlit> kRed{Unlit::lighting({200, 30, 20})};

inline constexpr Viewport kScreen{Canvas::kWidth, Canvas::kHeight};
inline constexpr Lens kLens = Lens::field_of_view(Turn{10000}, WorldLength::of(0.5), WorldLength::of(100));

/// A picture in bands of `rows` rows, the last of which may reach beyond it.
template <class Memory>
[[nodiscard]] std::vector<Picture::Word> drawn_in_bands(const Scene& scene, Memory& memory,
                                                        std::int32_t rows) {
  REQUIRE(ok(prepare_scene(scene, memory)));
  std::vector<Picture::Word> all;
  Canvas band(rows);
  for (std::int32_t row = 0; row < Canvas::kHeight; row += rows) {
    band.move_to(row);
    REQUIRE(ok(draw_prepared_scene(memory, band.picture, band.depth).status));
    all.insert(all.end(), band.pixels.begin(), band.pixels.end());
  }
  return all;
}

}  // namespace arcspan::test
