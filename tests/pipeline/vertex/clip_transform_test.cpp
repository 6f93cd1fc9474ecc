// SPDX-License-Identifier: MIT
// Transform and projection against double precision.
#include <arcspan/vertex/raster_vertex.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstdint>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// A camera of which the transform keeps every digit but the rotation's.
TestCamera random_camera(Random& random) {
  TestCamera camera;
  camera.look_in_random_direction(random);
  camera.width = random.integer(1, 2048);
  camera.height = random.integer(1, 2048);
  camera.focal = random.integer(1, 4000);
  const double far_off = random.decades(1, 60000);
  const auto whole = [](double v) { return std::round(v); };
  camera.translation = {whole(random.real(-far_off, far_off)), whole(random.real(-far_off, far_off)),
                        whole(random.real(-2 * far_off, far_off / 4))};
  camera.near_plane = random.integer(1, 200);
  camera.far_plane = camera.near_plane + random.integer(1, 200000);
  return camera;
}

Vec3 random_position(Random& random) {
  const double size = random.decades(10, 32767);
  const auto c = [&] { return std::round(random.real(-size, size)); };
  return {c(), c(), c()};
}

ObjectPosition to_position(Vec3 v) {
  return {static_cast<std::int16_t>(v.x), static_cast<std::int16_t>(v.y), static_cast<std::int16_t>(v.z)};
}

}  // namespace

TEST_CASE("projection is the pinhole camera's, rounded to 1/16 pixel") {
  Random random(81);
  int seen = 0;
  double worst = 0;        // sixteenths beyond what the clip coordinates' last units allow
  double worst_depth = 0;  // likewise in units of depth
  double worst_near = 0;   // sixteenths, of vertices at least 2^20 units in front
  for (int i = 0; i < share_of(300000); ++i) {
    const TestCamera camera = random_camera(random);
    const ClipTransform transform = camera.transform();
    const Vec3 lighting = random_position(random);
    const Vec3 view = camera.to_view(lighting);
    const ClipPosition clip = transform(to_position(lighting));
    if (outcode(clip, transform.w_range()) != kInside) continue;
    ++seen;
    const RasterPosition got = project(clip, transform);
    const double w = -view.z;
    const double x = 16 * (camera.focal * view.x / w + camera.width / 2.0 - camera.width / 2);
    const double y = 16 * (-camera.focal * view.y / w + camera.height / 2.0 - camera.height / 2);
    const double error = std::max(std::abs(got.x - std::clamp(x, -16384.0, 16383.0)),
                                  std::abs(got.y - std::clamp(y, -16384.0, 16383.0)));
    // Sums of four floors in x and in w, relative to w, times the guard band.
    const double units = 8.0 / clip.w;
    worst = std::max(worst, error - 16384 * units);
    if (clip.w > 1 << 20) worst_near = std::max(worst_near, error);
    const double n = camera.near_plane;
    const double f = camera.far_plane;
    const double depth = std::clamp(256 + 65023 * f / (f - n) * (1 - n / w), 256.0, 65279.0);
    worst_depth = std::max(worst_depth, std::abs(got.z - depth) - 65023 * f / (f - n) * units);
  }
  CHECK(seen > share_of(20000));
  CHECK(worst < 0.52);
  CHECK(worst_near < 0.65);
  CHECK(worst_depth < 2);
}

TEST_CASE("clip outcodes agree with the view volume up to rounding") {
  Random random(82);
  int wrong = 0;
  for (int i = 0; i < share_of(200000); ++i) {
    const TestCamera camera = random_camera(random);
    const ClipTransform transform = camera.transform();
    const Vec3 lighting = random_position(random);
    const Vec3 view = camera.to_view(lighting);
    const ClipPosition clip = transform(to_position(lighting));
    const double w = -view.z;
    // Clear cases only: a thousandth of the farthest corner away from every plane.
    const double slack = 1e-3 * (length(camera.translation) + 56756);
    const double x = camera.focal / 1024 * view.x;
    const std::uint8_t code = outcode(clip, transform.w_range());
    if (w < camera.near_plane - slack) {
      wrong += code == kOutsideNear ? 0 : 1;
    } else if (w > camera.near_plane + slack) {
      const double scaled_slack = slack * std::max(1.0, camera.focal / 1024);
      if (x > w + scaled_slack) wrong += (code & kOutsideRight) != 0 ? 0 : 1;
      if (x < -w - scaled_slack) wrong += (code & kOutsideLeft) != 0 ? 0 : 1;
      if (std::abs(x) < w - scaled_slack) wrong += (code & (kOutsideLeft | kOutsideRight)) == 0 ? 0 : 1;
      if (w > camera.far_plane + slack) wrong += (code & kOutsideFar) != 0 ? 0 : 1;
      if (w < camera.far_plane - slack) wrong += (code & kOutsideFar) == 0 ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("depth rises with the distance") {
  Random random(83);
  int falls = 0;
  for (int i = 0; i < 300; ++i) {
    const TestCamera camera = random_camera(random);
    const ClipTransform transform = camera.transform();
    std::uint16_t last = 0;
    for (std::int64_t w = transform.near_w(); w < 1 << 29; w += 1 + w / 64) {
      const std::uint16_t depth = project({0, 0, static_cast<std::int32_t>(w)}, transform).z;
      falls += depth < last ? 1 : 0;
      falls += depth < ClipTransform::kDepthMargin || depth > 65535 - ClipTransform::kDepthMargin ? 1 : 0;
      last = depth;
    }
  }
  CHECK(falls == 0);
}

TEST_CASE("a transform out of range is rejected") {
  const Viewport viewport{320, 240};
  const Projection projection{PixelLength::of(300.0), ObjectLength::of(1.0), ObjectLength::of(1000.0)};
  const Placement placement{Rotation::identity(), {}};
  ClipTransform t;
  CHECK(ok(ClipTransform::make(placement, projection, viewport, t)));
  CHECK(ok(ClipTransform::make(placement, projection, {2048, 2048}, t)));
  CHECK(ok(ClipTransform::make(placement, projection, {1, 1}, t)));
  for (const Viewport bad : {Viewport{0, 240}, {320, 0}, {2049, 240}, {320, 2049}, {-1, 240}}) {
    CHECK(ClipTransform::make(placement, projection, bad, t) == Status::kInvalidArgument);
  }
  Projection bad = projection;
  bad.focal = PixelLength{};
  CHECK(ClipTransform::make(placement, bad, viewport, t) == Status::kInvalidArgument);
  bad = projection;
  bad.near_plane = ObjectLength{};
  CHECK(ClipTransform::make(placement, bad, viewport, t) == Status::kInvalidArgument);
  bad = projection;
  bad.far_plane = bad.near_plane;
  CHECK(ClipTransform::make(placement, bad, viewport, t) == Status::kInvalidArgument);
  Placement far_off = placement;
  far_off.translation[1] = ObjectLength::of(4194304.0);
  CHECK(ok(ClipTransform::make(far_off, projection, viewport, t)));
  far_off.translation[1] = ObjectLength::of(-4194304.5);
  CHECK(ClipTransform::make(far_off, projection, viewport, t) == Status::kInvalidArgument);
}

TEST_CASE("a near plane behind everything hides everything") {
  for (const double near_plane : {100000.0, 262144.0, 524288.0, 4194304.0, 8388600.0}) {
    TestCamera camera;
    camera.near_plane = near_plane;
    camera.far_plane = 8388607;
    camera.translation = {0, 0, -20000};
    const ClipTransform transform = camera.transform();
    INFO("near " << near_plane);
    CHECK(outcode(transform({0, 0, 0}), transform.w_range()) == kOutsideNear);
    CHECK(outcode(transform({-32768, 32767, -32768}), transform.w_range()) == kOutsideNear);
  }
}
