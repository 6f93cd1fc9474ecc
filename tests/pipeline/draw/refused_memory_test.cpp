// SPDX-License-Identifier: MIT
// Memory that does not suit a draw call is refused with a status, and nothing is drawn.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/random.hpp>

#include <algorithm>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kPhong>;
using Method = Flat<Light>;
using Frame = hal::Framebuffer<Rgb565>;

constexpr std::int32_t kRows = 40;  // a third of the camera's 120

/// A sphere in view, and memory for a band of its picture.
struct Scene {
  Random random{181};
  TestMesh sphere = make_sphere(6, 8, 4000, 0, random);
  TestCamera camera;
  Light light;
  std::vector<std::uint16_t> colours;
  std::vector<std::uint16_t> depths;
  std::vector<CachedVertex<Method>> cache;

  Scene() {
    camera.translation = {0, 0, -14000};
    light = make_light<1, Highlight::kPhong>(camera);
    colours.resize(Frame::words(camera.width, kRows));
    depths.resize(DepthBuffer::words(camera.width, kRows), DepthBuffer::kFarthest);
    cache.resize(sphere.positions.size());
  }
  DrawResult draw(Frame& frame, const DepthBuffer& depth, std::size_t vertices = 0) {
    std::fill(colours.begin(), colours.end(), std::uint16_t{});
    return draw_mesh<Method>(sphere.view(), camera.transform(), light, frame, depth,
                             std::span(cache).first(vertices));
  }
  [[nodiscard]] bool is_blank() const {
    return std::all_of(colours.begin(), colours.end(), [](std::uint16_t code) { return code == 0; });
  }
};

}  // namespace

TEST_CASE("a depth buffer must cover the band that is drawn") {
  Scene scene;
  const std::int32_t width = scene.camera.width;
  Frame band(scene.colours, width, kRows, kRows);
  const auto status = [&](std::int32_t columns, std::int32_t rows, std::int32_t first_row) {
    const DepthBuffer depth(scene.depths, columns, rows, first_row);
    const DrawResult result = scene.draw(band, depth);
    CHECK(scene.is_blank() == !ok(result.status));
    CHECK((result.triangles == 0) == !ok(result.status));
    return result.status;
  };
  CHECK(status(width, kRows, kRows) == Status::kOk);
  CHECK(status(width, kRows, 0) == Status::kDepthMismatch);  // move_to() was forgotten
  CHECK(status(width, kRows, kRows + 1) == Status::kDepthMismatch);
  CHECK(status(width, kRows, kRows - 1) == Status::kDepthMismatch);
  CHECK(status(width - 1, kRows, kRows) == Status::kDepthMismatch);
  CHECK(status(width, kRows - 1, kRows) == Status::kDepthMismatch);
  CHECK(status(width, kRows + 1, kRows) == Status::kBufferTooSmall);
  CHECK(status(width, kRows, -1) == Status::kInvalidArgument);
  CHECK(status(width, kRows, INT32_MAX) == Status::kInvalidArgument);
}

TEST_CASE("a depth buffer of a rectangle must cover what is drawn") {
  Scene scene;
  const std::int32_t width = scene.camera.width;
  Frame band(scene.colours, width, kRows, kRows);
  const auto status = [&](const Rect& held) {
    const DepthBuffer depth(scene.depths, held);
    return scene.draw(band, depth).status;
  };
  CHECK(status({0, kRows, width, 2 * kRows}) == Status::kOk);
  CHECK(status({1, kRows, width, 2 * kRows}) == Status::kDepthMismatch);
  CHECK(status({0, kRows, width - 1, 2 * kRows}) == Status::kDepthMismatch);
  CHECK(status({0, kRows + 1, width, 2 * kRows}) == Status::kDepthMismatch);
  CHECK(status({0, kRows, width, 2 * kRows + 1}) == Status::kBufferTooSmall);
  CHECK(status({0, -1, width, 1}) == Status::kInvalidArgument);
  CHECK(status({-1, 0, 1, 1}) == Status::kInvalidArgument);
  CHECK(status({0, kRows, width, 32768}) == Status::kInvalidArgument);
  CHECK(status({0, 2 * kRows, width, kRows}) == Status::kInvalidArgument);
  CHECK(status({INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX}) == Status::kInvalidArgument);
}

TEST_CASE("a depth buffer of a rectangle has its columns, and moves to other rows") {
  std::vector<std::uint16_t> memory(DepthBuffer::words(4, 3) + 1, 7);
  DepthBuffer depth(memory, {5, 2, 9, 5});
  CHECK(depth.status() == Status::kOk);
  CHECK(depth.bounds() == Rect{5, 2, 9, 5});
  CHECK(depth.stride() == 4);
  CHECK(depth.row(2) + 5 == memory.data());
  depth.move_to(-1);
  CHECK(depth.bounds().empty());
  depth.move_to(20);
  CHECK(depth.bounds() == Rect{5, 20, 9, 23});
  CHECK(depth.row(22) + 8 == memory.data() + 11);
  depth.clear();
  CHECK(memory[0] == DepthBuffer::kFarthest);
  CHECK(memory[11] == DepthBuffer::kFarthest);
  CHECK(memory[12] == 7);
}

TEST_CASE("a depth buffer of an empty rectangle needs no memory") {
  for (const Rect& held : {Rect{7, 2, 7, 9}, Rect{7, 2, 9, 2}}) {
    DepthBuffer depth({}, held);
    CHECK(depth.status() == Status::kOk);
    CHECK(depth.bounds() == held);
    depth.clear();
    depth.move_to(5);
    CHECK(depth.status() == Status::kOk);
  }
}

TEST_CASE("rows of a band below the picture need no depths") {
  Scene scene;
  const std::int32_t width = scene.camera.width;
  Frame band(scene.colours, width, kRows, scene.camera.height - kRows / 2);
  const DepthBuffer half(scene.depths, width, kRows / 2, scene.camera.height - kRows / 2);
  CHECK(scene.draw(band, half).status == Status::kOk);
  band.move_to(scene.camera.height);
  const DepthBuffer elsewhere(scene.depths, width, kRows);
  CHECK(scene.draw(band, elsewhere).status == Status::kOk);
  CHECK(scene.is_blank());
}

TEST_CASE("a depth buffer lies between row 0 and row INT32_MAX") {
  std::vector<std::uint16_t> memory(DepthBuffer::words(4, 3), 7);
  CHECK(DepthBuffer(memory, 65536, 65536).status() == Status::kInvalidArgument);
  CHECK(DepthBuffer(memory, 4, 4).status() == Status::kBufferTooSmall);
  CHECK(DepthBuffer(memory, 4, 3, -1).bounds().empty());
  DepthBuffer depth(memory, 4, 3, INT32_MAX - 3);
  CHECK(depth.status() == Status::kOk);
  for (const std::int32_t row : {INT32_MAX - 2, INT32_MAX, -1, INT32_MIN}) {
    depth.move_to(row);
    CHECK(depth.status() == Status::kInvalidArgument);
    CHECK(depth.bounds().empty());
    depth.clear();
  }
  depth.move_to(9);
  CHECK(depth.status() == Status::kOk);
  CHECK(depth.bounds() == Rect{0, 9, 4, 12});
  CHECK(*(depth.row(11) + 3) == DepthBuffer::kFarthest);
}

TEST_CASE("a framebuffer that is not ok is reported by the draw call") {
  Scene scene;
  const std::int32_t width = scene.camera.width;
  const DepthBuffer depth(scene.depths, width, kRows);
  Frame too_small(std::span(scene.colours).first(100), width, kRows);
  CHECK(scene.draw(too_small, depth).status == Status::kBufferTooSmall);
  Frame band(scene.colours, width, kRows);
  band.move_to(-kRows);
  CHECK(scene.draw(band, depth).status == Status::kInvalidArgument);
  CHECK(scene.is_blank());
  band.move_to(0);
  CHECK(scene.draw(band, depth).status == Status::kOk);
}

TEST_CASE("a sink may lie anywhere") {
  struct Elsewhere : Frame {
    using Frame::Frame;
    [[nodiscard]] Rect bounds() const { return place; }
    Rect place;
  };
  Scene scene;
  Elsewhere sink(scene.colours, scene.camera.width, kRows);
  for (const Rect& place : {Rect{INT32_MAX - 9, 0, INT32_MAX, 9}, Rect{INT32_MIN, 0, INT32_MIN + 9, 9},
                            Rect{0, INT32_MAX - 9, 9, INT32_MAX}, Rect{0, INT32_MIN, 9, INT32_MIN + 9},
                            Rect{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN}}) {
    sink.place = place;
    const DrawResult result =
        draw_mesh<Method>(scene.sphere.view(), scene.camera.transform(), scene.light, sink, NoDepth{});
    CHECK(result.status == Status::kOk);
    CHECK(result.triangles == 0);
  }
  CHECK(scene.is_blank());
}

TEST_CASE("a vertex cache is empty or large enough") {
  Scene scene;
  const std::int32_t width = scene.camera.width;
  Frame band(scene.colours, width, kRows, kRows);
  DepthBuffer depth(scene.depths, width, kRows, kRows);
  for (const std::size_t vertices : {std::size_t{1}, scene.cache.size() - 1}) {
    CHECK(scene.draw(band, depth, vertices).status == Status::kCacheTooSmall);
    CHECK(scene.is_blank());
  }
  CHECK(scene.draw(band, depth).status == Status::kOk);
  depth.clear();
  CHECK(scene.draw(band, depth, scene.cache.size()).status == Status::kOk);
  CHECK_FALSE(scene.is_blank());
}
