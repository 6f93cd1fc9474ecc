// SPDX-License-Identifier: MIT
// Outlines that are smoothed from C without memory for gaps.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/smooth_outlines.hpp>

#include <arcspan.h>
#include <arcspan_c/view.hpp>
#include <catch2/catch.hpp>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace arcspan;

namespace {

constexpr std::int32_t kMarkedSide = 64;

/// A ball, whose outlines may be smoothed.
struct BallView {
  std::vector<std::uint32_t> model;
  std::vector<unsigned char> scene_memory, view_memory, outline_memory;
  arcspan_scene* scene = nullptr;
  arcspan_view* view = nullptr;
  std::vector<std::uint16_t> pixels = std::vector<std::uint16_t>(kMarkedSide * kMarkedSide);
  std::vector<std::uint16_t> depths = pixels;

  BallView() {
    std::ifstream file(ARCSPAN_C_BINARIES "outlined-ball.bin", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    REQUIRE(!bytes.empty());
    model.resize(bytes.size() / 4 + 1);
    std::memcpy(model.data(), bytes.data(), bytes.size());
    const arcspan_scene_limits limits{1, 1};
    scene_memory.resize(arcspan_scene_bytes(&limits));
    REQUIRE(arcspan_scene_make(scene_memory.data(), scene_memory.size(), &limits, &scene) == ARCSPAN_OK);
    REQUIRE(arcspan_add_binary(scene, model.data(), bytes.size(), nullptr, nullptr) == ARCSPAN_OK);
    const arcspan_view_limits of_view = arcspan_limits_of(scene, 0);
    view_memory.resize(arcspan_view_bytes(&of_view));
    REQUIRE(arcspan_view_make(view_memory.data(), view_memory.size(), &of_view, scene, &view) == ARCSPAN_OK);
    const arcspan_lens lens = {kMarkedSide, kMarkedSide,       ARCSPAN_DEGREES(44),
                               0,           ARCSPAN_LENGTH(1), ARCSPAN_LENGTH(9)};
    REQUIRE(arcspan_set_camera(view, &lens, {0, 0, ARCSPAN_LENGTH(4)}, {0, 0, 0}, {0, 0, 0}) == ARCSPAN_OK);
  }
  void smooth() {
    const arcspan_outline_limits limits{1000, 1000, 0, 0};
    outline_memory.resize(arcspan_outline_bytes(&limits));
    REQUIRE(arcspan_smooth_outlines(view, outline_memory.data(), outline_memory.size(), &limits) ==
            ARCSPAN_OK);
  }
  void draw() {
    constexpr arcspan_rgb kBlue = {0, 0, 90};
    REQUIRE(arcspan_prepare(view) == ARCSPAN_OK);
    const arcspan_target target{
        pixels.data(), 2 * pixels.size(), 2 * kMarkedSide, ARCSPAN_RGB565, {0, 0, kMarkedSide, kMarkedSide},
        depths.data(), depths.size(),     &kBlue};
    REQUIRE(arcspan_draw(view, &target) == ARCSPAN_OK);
  }
};

}  // namespace

TEST_CASE("outlines are smoothed from C without memory for gaps as from C++") {
  BallView smoothed;
  smoothed.smooth();
  smoothed.draw();
  BallView plain;
  plain.draw();
  CHECK(smoothed.pixels != plain.pixels);
  hal::Framebuffer<Rgb565> frame(plain.pixels, kMarkedSide, kMarkedSide);
  const DepthBuffer depth(plain.depths, kMarkedSide, kMarkedSide);
  REQUIRE(ok(smooth_outlines(smoothed.view->outlines.edges, frame, depth)));
  CHECK(smoothed.pixels == plain.pixels);
}
