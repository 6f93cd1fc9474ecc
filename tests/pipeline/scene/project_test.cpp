// SPDX-License-Identifier: MIT
// Points on the screen against double precision and against drawn vertices.
#include <arcspan/draw/line_stage.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/scene_support.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace arcspan;
using namespace arcspan::test;

namespace {

const MeshView kNoMesh{};

WorldPoint random_point(Random& random, double size) {
  return to_point({random.real(-size, size), random.real(-size, size), random.real(-size, size)});
}

/// The picture, and the point's pixel if that is outside of it.
Rect screen_rect(const ScreenPoint& point, const Viewport& viewport) {
  return bounding_rect({0, 0, viewport.width, viewport.height},
                       {point.column(), point.row(), point.column() + 1, point.row() + 1});
}

}  // namespace

TEST_CASE("a point of the world appears where double precision has it") {
  Random random(4511);
  double worst = 0;  // in pixels
  int seen = 0;
  int behind = 0;
  const int cases = std::max(share_of(20000), 4000);  // with fewer, chance decides what is counted
  for (int i = 0; i < cases; ++i) {
    const Viewport viewport{random.integer(1, 2048), random.integer(1, 2048)};
    const double focal = random.integer(20, 3000);
    const double near_plane = random.decades(0.02, 10);
    Camera camera;
    REQUIRE(Camera::make({random_point(random, 100), random_point(random, 100)},
                         Lens::focal_length(PixelLength::from_raw(static_cast<std::int32_t>(2048 * focal)),
                                            to_world(near_plane), to_world(20000)),
                         viewport, camera) == Status::kOk);
    const WorldPoint point = random_point(random, random.decades(1, 20000));
    const Vec3 view = turned(camera.rotation(), to_vec3(point) - to_vec3(camera.eye()));
    const ScreenPoint screen = camera.project(point);
    if (std::abs(-view.z - near_plane) > 1e-3) REQUIRE(screen.in_front == (-view.z > near_plane));
    if (!screen.in_front) {
      ++behind;
      REQUIRE(screen == ScreenPoint{});
      continue;
    }
    // Beyond the guard band all points are at its side, half a pixel farther in pictures of odd size.
    const auto exact = [&](double across, std::int32_t size) {
      return size / 2.0 + std::clamp(focal * across / -view.z, -1023.0, 1023.0);
    };
    const auto error_of = [](Subpixel at, double wanted, std::int32_t size) {
      const double from_middle = at.raw() / 16.0 - size / 2.0;
      return std::abs(std::clamp(from_middle, -1023.0, 1023.0) + size / 2.0 - wanted);
    };
    const double x = exact(view.x, viewport.width);
    const double y = exact(-view.y, viewport.height);
    const double error =
        std::max(error_of(screen.x, x, viewport.width), error_of(screen.y, y, viewport.height));
    const double rounding = focal * 0x1p-15 / -view.z;  // of 16 fraction bits of a world unit
    worst = std::max(worst, error - rounding);
    const auto is_inside = [&](double across, std::int32_t size) {
      return std::abs(focal * across / -view.z) < size / 2.0;
    };
    const bool inside = is_inside(view.x, viewport.width) && is_inside(view.y, viewport.height);
    const double to_side =
        std::min({std::abs(x), std::abs(y), std::abs(x - viewport.width), std::abs(y - viewport.height)});
    if (to_side > 0.1 + rounding) REQUIRE(screen.in_picture == inside);
    if (screen.in_picture)
      REQUIRE(screen_rect(screen, viewport) == Rect{0, 0, viewport.width, viewport.height});
    seen += inside ? 1 : 0;
  }
  CHECK(seen > cases / 20);
  CHECK(behind > cases / 4);
  CHECK(worst < 1.0 / 16);
}

TEST_CASE("a point of an object appears where a vertex is drawn") {
  Random random(4512);
  int seen = 0;
  for (int i = 0; i < share_of(5000); ++i) {
    const Viewport viewport{random.integer(1, 2048), random.integer(1, 2048)};
    const bool parallel = random.chance(0.3);
    Camera camera;
    REQUIRE(Camera::make({random_point(random, 10), random_point(random, 10)},
                         parallel ? Lens::orthographic(to_world(6), to_world(0.5), to_world(30)) : kLens,
                         viewport, camera) == Status::kOk);
    Object object(kNoMesh, kRed);
    object.scale = to_world(random.decades(0.01, 10));
    object.position = random_point(random, 10);
    object.rotation = random_rotation(random);
    ClipTransform transform;
    REQUIRE(camera.place(object.position, object.rotation, object.scale, transform));
    const auto c = [&] { return static_cast<std::int16_t>(random.integer(-32768, 32767)); };
    const ObjectPosition p{c(), c(), c()};
    const ScreenPoint screen = camera.project(object, p);
    REQUIRE(screen == screen_point(transform, p));
    const ClipPosition clip = transform(p);
    const std::uint8_t code = outcode(clip, transform.w_range());
    REQUIRE(screen.in_front == (code != kOutsideNear));
    if (code == kOutsideNear) continue;
    const auto from_middle = [](Subpixel v, std::int32_t size) { return v.raw() - size / 2 * 16; };
    const std::int32_t x = from_middle(screen.x, viewport.width);
    const std::int32_t y = from_middle(screen.y, viewport.height);
    if (code == kInside) {
      ++seen;
      REQUIRE(RasterPosition{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), screen.depth} ==
              project(clip, transform));
    }
    // Beyond the guard band a point stays at its side.
    if ((code & kOutsideLeft) != 0) REQUIRE(x <= -16383 + 8);
    if ((code & kOutsideRight) != 0) REQUIRE(x >= 16383 - 8);
    if ((code & kOutsideTop) != 0) REQUIRE(y <= -16383 + 8);
    if ((code & kOutsideBottom) != 0) REQUIRE(y >= 16383 - 8);
  }
  CHECK(seen > share_of(5000) / 20);
}

TEST_CASE("a camera that was not made sees no point, nor does one of an object without a size") {
  CHECK(Camera().project(WorldPoint::of(0, 0, -1)) == ScreenPoint{});
  Camera camera;
  REQUIRE(Camera::make({{}, WorldPoint::of(0, 0, -1)}, kLens, kScreen, camera) == Status::kOk);
  Object object(kNoMesh, kRed);
  object.position = WorldPoint::of(0, 0, -2);
  CHECK(camera.project(object, {0, 0, 0}).in_picture);
  object.scale = {};
  CHECK(camera.project(object, {0, 0, 0}) == ScreenPoint{});
}

TEST_CASE("a surface hides half of its own vertices, and none by more than the default bias") {
  Random random(4513);
  const TestMesh ball = make_sphere(24, 48, 32000, 0, random);
  const MeshView view = ball.view();
  const std::vector<Object> objects(1, Object(view, kRed));
  static SceneMemory<SceneMethods, 1> memory;
  Camera camera;
  REQUIRE(Camera::make({WorldPoint::of(0.3, 0.7, 4), {}}, kLens, kScreen, camera) == Status::kOk);
  Canvas canvas;
  REQUIRE(ok(draw_scene({camera, kLights, objects}, canvas.picture, canvas.depth, memory).status));
  int seen = 0;
  int hidden = 0;
  for (const ObjectPosition& p : ball.positions) {
    const Vec3 normal = Vec3{p.x / 32000.0, p.y / 32000.0, p.z / 32000.0};
    if (dot(normal, normalised(Vec3{0.3, 0.7, 4} - normal)) < 0.5) continue;
    const ScreenPoint point = camera.project(objects[0], p);
    const std::int32_t depth = canvas.depth.row(point.row())[point.column()];
    ++seen;
    hidden += depth < point.depth ? 1 : 0;
    CHECK(point.depth - depth <= DepthBias::kDefault);
  }
  CHECK(seen > 100);
  CHECK(hidden > seen / 3);
}
