// SPDX-License-Identifier: MIT
// Lights of a C interface that is compiled for several grey ones.
#include <arcspan.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

extern "C" {
extern const arcspan_model ball;
}

namespace {

constexpr std::uint16_t kSide = 32;
constexpr arcspan_shares kWhiteShares = {32768, 32768, 32768};

/// A ball, and a view of it.
struct LitBall {
  std::vector<unsigned char> scene_memory, view_memory;
  arcspan_scene* scene = nullptr;
  arcspan_view* view = nullptr;

  LitBall() {
    const arcspan_scene_limits limits{1, 0};
    scene_memory.resize(arcspan_scene_bytes(&limits));
    REQUIRE(arcspan_scene_make(scene_memory.data(), scene_memory.size(), &limits, &scene) == ARCSPAN_OK);
    REQUIRE(arcspan_add_model(scene, &ball, nullptr) == ARCSPAN_OK);
    const arcspan_view_limits view_limits = arcspan_limits_of(scene, 1);
    view_memory.resize(arcspan_view_bytes(&view_limits));
    REQUIRE(arcspan_view_make(view_memory.data(), view_memory.size(), &view_limits, scene, &view) ==
            ARCSPAN_OK);
    const arcspan_lens lens{kSide, kSide, ARCSPAN_DEGREES(45), 0, ARCSPAN_LENGTH(1), ARCSPAN_LENGTH(8)};
    REQUIRE(arcspan_set_camera(view, &lens, {0, 0, ARCSPAN_LENGTH(3)}, {0, 0, 0}, {0, 0, 0}) == ARCSPAN_OK);
  }
  std::vector<std::uint16_t> drawn() {
    std::vector<std::uint16_t> pixels(kSide * kSide), depths(kSide * kSide);
    const arcspan_rgb black{0, 0, 0};
    const arcspan_target target{pixels.data(),        2 * pixels.size(), 2 * kSide,     ARCSPAN_RGB565,
                                {0, 0, kSide, kSide}, depths.data(),     depths.size(), &black};
    REQUIRE(arcspan_prepare(view) == ARCSPAN_OK);
    REQUIRE(arcspan_draw(view, &target) == ARCSPAN_OK);
    return pixels;
  }
};

TEST_CASE("where several lights are compiled without colours, a single coloured one is refused, too") {
  LitBall scene;
  const arcspan_light white{{1, 1, 1}, 0, 32768, kWhiteShares};
  REQUIRE(arcspan_set_lights(scene.scene, &white, 1, kWhiteShares) == ARCSPAN_OK);
  const auto expected = scene.drawn();
  CHECK(*std::max_element(expected.begin(), expected.end()) > 0);
  const arcspan_light red{{1, 1, 1}, 0, 32768, {32768, 0, 0}};
  const arcspan_light both[] = {white, red};
  CHECK(arcspan_set_lights(scene.scene, &red, 1, kWhiteShares) == ARCSPAN_UNSUPPORTED);
  CHECK(arcspan_set_lights(scene.scene, both, 2, kWhiteShares) == ARCSPAN_UNSUPPORTED);
  const arcspan_light yellow{{1, 1, 1}, 0, 32768, {32768, 32768, 0}};
  CHECK(arcspan_set_lights(scene.scene, &yellow, 1, kWhiteShares) == ARCSPAN_UNSUPPORTED);
  CHECK(scene.drawn() == expected);
  const arcspan_light grey{{1, 1, 1}, 0, 16384, {16384, 16384, 16384}};
  CHECK(arcspan_set_lights(scene.scene, &grey, 1, kWhiteShares) == ARCSPAN_OK);
  CHECK(scene.drawn() != expected);
}

TEST_CASE("opacity that is not compiled is refused") {
  LitBall scene;
  const auto expected = scene.drawn();
  CHECK(arcspan_set_opacity(scene.scene, 99, ARCSPAN_SHARE(0.5)) == ARCSPAN_UNSUPPORTED);
  CHECK(scene.drawn() == expected);
}

TEST_CASE("a scene has as many lights as it was last given") {
  LitBall scene;
  const arcspan_light lights[] = {{{1, 1, 1}, 0, 32768, kWhiteShares}, {{-1, 0, 1}, 0, 16384, kWhiteShares}};
  REQUIRE(arcspan_set_lights(scene.scene, lights, 1, kWhiteShares) == ARCSPAN_OK);
  const auto by_one = scene.drawn();
  REQUIRE(arcspan_set_lights(scene.scene, lights, 2, kWhiteShares) == ARCSPAN_OK);
  CHECK(scene.drawn() != by_one);
  REQUIRE(arcspan_set_lights(scene.scene, lights, 1, kWhiteShares) == ARCSPAN_OK);
  CHECK(scene.drawn() == by_one);
  REQUIRE(arcspan_set_lights(scene.scene, lights, 0, kWhiteShares) == ARCSPAN_OK);
  CHECK(scene.drawn() != by_one);
  const arcspan_light in_origin{{0, 0, 0}, 65536, 32768, kWhiteShares};
  CHECK(arcspan_set_lights(scene.scene, &in_origin, 1, kWhiteShares) == ARCSPAN_OK);
}

}  // namespace
