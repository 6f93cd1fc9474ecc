// SPDX-License-Identifier: MIT
// Cameras and placements against double precision.
#include <arcspan/vertex/raster_vertex.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/scene_support.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// Where a point of the world appears, in sixteenths of a pixel from the middle of the picture, y down, and
/// its distance before the camera.
struct Seen {
  double x;
  double y;
  double ahead;
};

Seen see(const Camera& camera, Vec3 world, double focal) {
  const Vec3 view = turned(camera.rotation(), world - to_vec3(camera.eye()));
  return {16 * focal * view.x / -view.z, -16 * focal * view.y / -view.z, -view.z};
}

Vec3 to_world_space(const Object& object, Vec3 position) {
  return to_vec3(object.position) + (to_double(object.scale) / 32768) * turned(object.rotation, position);
}

WorldPoint random_point(Random& random, double size) {
  return to_point({random.real(-size, size), random.real(-size, size), random.real(-size, size)});
}

const MeshView kNoMesh{};

}  // namespace

TEST_CASE("look_at turns the camera to its target with `up` upwards") {
  Random random(1811);
  double worst = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    const LookAt view{random_point(random, random.decades(0.01, 32000)),
                      random_point(random, random.decades(0.01, 32000)), to_direction(random_unit(random))};
    const Vec3 back = normalised(to_vec3(view.eye) - to_vec3(view.target));
    const Vec3 up = to_vec3(view.up);
    if (length(cross(up, back)) < std::sin(radians(10))) continue;
    const Vec3 right = normalised(cross(up, back));
    const Vec3 axes[3] = {right, cross(back, right), back};
    Camera camera;
    REQUIRE(camera.look_at(view) == Status::kOk);
    for (std::size_t r = 0; r < 3; ++r) {
      const double exact[3] = {axes[r].x, axes[r].y, axes[r].z};
      for (std::size_t c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(std::ldexp(camera.rotation().m[r][c].raw(), -30) - exact[c]));
      }
    }
  }
  CHECK(worst < 0x1p-26);
}

TEST_CASE("a camera that is given the pose of another sees the same") {
  Camera camera;
  Camera posed;
  REQUIRE(Camera::make({WorldPoint::of(3, -1, 4), WorldPoint::of(1, 2, -1)}, kLens, kScreen, camera) ==
          Status::kOk);
  REQUIRE(Camera::make({{}, WorldPoint::of(0, 0, -1)}, kLens, kScreen, posed) == Status::kOk);
  posed.set_pose(camera.eye(), camera.rotation());
  const ScreenPoint seen = camera.project(WorldPoint::of(1, 1, -2));
  REQUIRE(seen.in_front);
  CHECK(posed.project(WorldPoint::of(1, 1, -2)) == seen);
}

TEST_CASE("a camera made of constants is the same as a constant and as a variable") {
  static constexpr Camera constant = Camera::of({WorldPoint::of(0, 0, 4), {}}, kLens, kScreen);
  const Camera variable = Camera::of({WorldPoint::of(0, 0, 4), {}}, kLens, kScreen);
  ClipTransform expected;
  ClipTransform found;
  REQUIRE(constant.place(WorldPoint::of(-0.8, 0, 0), Rotation::identity(), WorldLength::of(1), expected));
  REQUIRE(variable.place(WorldPoint::of(-0.8, 0, 0), Rotation::identity(), WorldLength::of(1), found));
  const ClipPosition a = expected({100, -2000, 30000});
  const ClipPosition b = found({100, -2000, 30000});
  CHECK((a.x == b.x && a.y == b.y && a.w == b.w));
}

TEST_CASE("vertices of objects of any scale appear where double precision has them") {
  Random random(1812);
  double worst = 0;  // in sixteenths of a pixel, beyond the clip coordinates' last units
  int seen = 0;
  int too_far = 0;
  int near_enough = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    const std::int32_t width = random.integer(1, 2048);
    const std::int32_t height = random.integer(1, 2048);
    const double focal = random.integer(20, 3000);
    const double far_plane = random.chance(0.5) ? 20000 : random.decades(0.2, 20000);
    Camera camera;
    REQUIRE(Camera::make({random_point(random, 100), random_point(random, 100)},
                         Lens::focal_length(PixelLength::from_raw(static_cast<std::int32_t>(2048 * focal)),
                                            to_world(0.1), to_world(far_plane)),
                         {width, height}, camera) == Status::kOk);
    Object object(kNoMesh, kRed);
    object.scale = to_world(random.decades(0.002, 1000));
    object.position = random_point(random, random.decades(1, 10000));
    object.rotation = random_rotation(random);
    ClipTransform transform;
    REQUIRE(camera.place(object.position, object.rotation, object.scale, transform));
    const auto c = [&] { return static_cast<std::int16_t>(random.integer(-32768, 32767)); };
    const ObjectPosition p{c(), c(), c()};
    const Seen exact = see(camera, to_world_space(object, {double(p.x), double(p.y), double(p.z)}), focal);
    const ClipPosition clip = transform(p);
    const std::uint8_t code = outcode(clip, transform.w_range());
    // Both distances have 16 fraction bits of a world unit, and the clip coordinates' last units.
    const double slack = 0x1p-14 + 8 * std::abs(exact.ahead / clip.w);
    if (std::abs(exact.ahead - far_plane) > slack) {
      const bool beyond = exact.ahead > far_plane;
      REQUIRE(((code & kOutsideFar) != 0) == beyond);
      ++(beyond ? too_far : near_enough);
    }
    if (code != kInside || std::abs(exact.x) > 16000 || std::abs(exact.y) > 16000) continue;
    ++seen;
    const RasterPosition raster = project(clip, transform);
    const double error = std::max(std::abs(raster.x - (exact.x + 8 * (width & 1))),
                                  std::abs(raster.y - (exact.y + 8 * (height & 1))));
    // Camera space has 16 fraction bits of a world unit.
    worst = std::max(worst, error - 16384 * 8.0 / clip.w - 16 * focal * 0x1p-15 / exact.ahead);
  }
  CHECK(seen > share_of(20000) / 20);
  CHECK(too_far > share_of(20000) / 20);
  CHECK(near_enough > share_of(20000) / 20);
  CHECK(worst < 0.6);
}

TEST_CASE("an object that is moved slowly moves steadily") {
  Camera camera;
  REQUIRE(Camera::make({WorldPoint::of(0, 0, 5), {}}, kLens, kScreen, camera) == Status::kOk);
  Object object(kNoMesh, kRed);
  object.rotation = rotation_of(EulerAngles{{1234}, {777}, {4321}});
  std::int32_t last = INT32_MIN;
  double worst = 0;
  const double focal = Canvas::kHeight / 2.0 / std::tan(std::numbers::pi * 10000 / 65536);
  for (std::int32_t step = 0; step < 4000; ++step) {
    object.position.x = WorldLength::from_raw(-65536 + 32 * step);  // 1/80 of a subpixel
    ClipTransform transform;
    REQUIRE(camera.place(object.position, object.rotation, object.scale, transform));
    const RasterPosition raster = project(transform({9000, -7000, 5000}), transform);
    const Seen exact = see(camera, to_world_space(object, {9000, -7000, 5000}), focal);
    worst = std::max(worst, std::abs(raster.x - exact.x));
    CHECK(raster.x >= last);  // never back
    last = raster.x;
  }
  CHECK(worst < 0.51);
}

TEST_CASE("objects of different scale have the depths of one camera") {
  Camera camera;
  REQUIRE(Camera::make({WorldPoint::of(0, 0, 0), WorldPoint::of(0, 0, -1)}, kLens, kScreen, camera) ==
          Status::kOk);
  Random random(1813);
  double worst = 0;
  for (int i = 0; i < share_of(5000); ++i) {
    const double ahead = random.decades(0.6, 99);
    ClipTransform transform;
    REQUIRE(camera.place(to_point({0, 0, -ahead}), Rotation::identity(), to_world(random.decades(0.01, 1000)),
                         transform));
    const double exact = 256 + 65023 * 100 / 99.5 * (1 - 0.5 / (std::round(ahead * 65536) / 65536));
    worst = std::max(worst, std::abs(project(transform({}), transform).z - exact));
  }
  CHECK(worst < 2.5);
}

TEST_CASE("what is far beside the view of an orthographic lens is beside it") {
  Random random(1816);
  int placed = 0;
  for (int i = 0; i < 100; ++i) {
    Camera camera;
    const Lens lens =
        Lens::orthographic(to_world(random.decades(0.01, 10)), to_world(1), to_world(random.real(2, 3000)));
    if (!ok(Camera::make({WorldPoint::of(0, 0, 2), {}}, lens, {320, 240}, camera))) continue;
    Object object(kNoMesh, kRed, to_point({random.decades(1000, 16000), random.decades(1000, 16000), 0.5}));
    object.scale = to_world(random.decades(0.01, 1000));
    ClipTransform transform;
    if (!camera.place(object.position, object.rotation, object.scale, transform)) continue;
    ++placed;
    const std::uint8_t code = outcode(transform({0, 0, 0}), transform.w_range());
    REQUIRE((code & kOutsideRight) != 0);
    REQUIRE((code & kOutsideTop) != 0);
  }
  CHECK(placed > 50);
}

TEST_CASE("an orthographic lens is parallel to within 1/8192, with linear depth") {
  Random random(1814);
  double worst = 0;
  double worst_depth = 0;
  int seen = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    const double height = random.decades(0.1, 1000);
    const double near_plane = height * random.decades(0.1, 10);
    const double far_plane = near_plane + height * random.decades(0.5, 10);
    Camera camera;
    REQUIRE(Camera::make({random_point(random, 100), random_point(random, 100)},
                         Lens::orthographic(to_world(height), to_world(near_plane), to_world(far_plane)),
                         {320, 240}, camera) == Status::kOk);
    // Within the view: the camera's axes are the rows of its rotation.
    const Vec3 view{height * random.real(-0.6, 0.6), height * random.real(-0.5, 0.5),
                    -random.real(near_plane, far_plane)};
    Object object(kNoMesh, kRed);
    object.scale = to_world(height * random.decades(0.02, 0.5) + 0.001);
    Vec3 world = to_vec3(camera.eye());
    const double v[3] = {view.x, view.y, view.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& row = camera.rotation().m[k];
      world = world +
              std::ldexp(v[k], -30) * Vec3{double(row[0].raw()), double(row[1].raw()), double(row[2].raw())};
    }
    object.position = to_point(world);
    object.rotation = random_rotation(random);
    ClipTransform transform;
    REQUIRE(camera.place(object.position, object.rotation, object.scale, transform));
    const auto c = [&] { return static_cast<std::int16_t>(random.integer(-32768, 32767)); };
    const ObjectPosition p{c(), c(), c()};
    const Vec3 at =
        turned(camera.rotation(),
               to_world_space(object, {double(p.x), double(p.y), double(p.z)}) - to_vec3(camera.eye()));
    const ClipPosition clip = transform(p);
    const double slack = 0x1p-13 + 1e-4 * (far_plane - near_plane);
    if (-at.z > far_plane + slack) REQUIRE((outcode(clip, transform.w_range()) & kOutsideFar) != 0);
    if (-at.z < far_plane - slack) REQUIRE((outcode(clip, transform.w_range()) & kOutsideFar) == 0);
    if (-at.z < near_plane || -at.z > far_plane) continue;
    ++seen;
    const RasterPosition raster = project(clip, transform);
    const double x = 16 * 240 / height * at.x;
    const double y = -16 * 240 / height * at.y;
    const double world_step = 16 * 240 / height * 0x1p-15;
    worst = std::max(worst, std::max(std::abs(raster.x - x) - std::abs(x) / 8192,
                                     std::abs(raster.y - y) - std::abs(y) / 8192) -
                                world_step);
    const double depth = 256 + 65023 * (-at.z - near_plane) / (far_plane - near_plane);
    worst_depth =
        std::max(worst_depth, std::abs(raster.z - depth) - 65023 * 0x1p-14 / (far_plane - near_plane));
  }
  CHECK(seen > share_of(20000) / 4);
  CHECK(worst < 0.8);
  CHECK(worst_depth < 20);
}

TEST_CASE("a field of view and a focal length agree") {
  Camera by_angle;
  Camera by_length;
  // 2 atan(1/2) = 53.13 degrees: 9672 of 65536; tan of half of it is 0.49997.
  REQUIRE(Camera::make({{}, WorldPoint::of(0, 0, -1)}, Lens::field_of_view({9672}, to_world(1), to_world(9)),
                       kScreen, by_angle) == Status::kOk);
  REQUIRE(Camera::make({{}, WorldPoint::of(0, 0, -1)},
                       Lens::focal_length(PixelLength::of(Canvas::kHeight), to_world(1), to_world(9)),
                       kScreen, by_length) == Status::kOk);
  ClipTransform a;
  ClipTransform b;
  REQUIRE(by_angle.place(WorldPoint::of(0, 0, -3), Rotation::identity(), to_world(1), a));
  REQUIRE(by_length.place(WorldPoint::of(0, 0, -3), Rotation::identity(), to_world(1), b));
  CHECK(std::abs(a.focal().raw() - b.focal().raw()) < 8);
  CHECK(project(a({30000, -20000, 0}), a) == project(b({30000, -20000, 0}), b));
}

TEST_CASE("cameras that make no sense are refused") {
  const Lens lens = Lens::field_of_view({8000}, to_world(1), to_world(9));
  const WorldPoint here = WorldPoint::of(1, 2, 3);
  Camera camera;
  const auto made = [&](const LookAt& view, const Lens& with, const Viewport& viewport) {
    return Camera::make(view, with, viewport, camera);
  };
  CHECK(made({here, {}}, lens, kScreen) == Status::kOk);
  const Camera before = camera;
  CHECK(made({here, here}, lens, kScreen) == Status::kNoViewDirection);
  CHECK(made({here, WorldPoint::of(1, 7, 3)}, lens, kScreen) == Status::kNoViewDirection);
  CHECK(made({here, {}, Direction{}}, lens, kScreen) == Status::kNoViewDirection);
  CHECK(camera.look_at({here, here}) == Status::kNoViewDirection);
  const auto planes = [](double near_plane, double far_plane) {
    return Lens::orthographic(to_world(4), to_world(near_plane), to_world(far_plane));
  };
  CHECK(made({here, {}}, planes(2, 2), kScreen) == Status::kNearNotBeforeFar);
  CHECK(made({here, {}}, planes(3, 2), kScreen) == Status::kNearNotBeforeFar);
  CHECK(made({here, {}}, planes(0, 2), kScreen) == Status::kNearNotBeforeFar);
  CHECK(made({here, {}}, planes(1, 2), {0, 10}) == Status::kInvalidArgument);
  CHECK(made({here, {}}, planes(1, 2), {10, 2049}) == Status::kInvalidArgument);
  const auto angle = [](std::uint16_t raw) { return Lens::field_of_view({raw}, to_world(1), to_world(2)); };
  CHECK(made({here, {}}, angle(0), kScreen) == Status::kInvalidArgument);
  CHECK(made({here, {}}, angle(1), {2048, 2048}) == Status::kInvalidArgument);
  CHECK(made({here, {}}, angle(0x8000), kScreen) == Status::kInvalidArgument);
  CHECK(made({here, {}}, angle(0xC000), kScreen) == Status::kInvalidArgument);
  CHECK(made({here, {}}, Lens::focal_length(PixelLength{}, to_world(1), to_world(2)), kScreen) ==
        Status::kInvalidArgument);
  CHECK(made({here, {}}, Lens::orthographic(WorldLength{}, to_world(1), to_world(2)), kScreen) ==
        Status::kInvalidArgument);
  CHECK(camera.eye() == before.eye());
  ClipTransform transform;
  CHECK_FALSE(Camera{}.place({}, Rotation::identity(), to_world(1), transform));
  CHECK_FALSE(camera.place({}, Rotation::identity(), WorldLength::from_raw(63), transform));
}
