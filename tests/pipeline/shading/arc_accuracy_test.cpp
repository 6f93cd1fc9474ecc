// SPDX-License-Identifier: MIT
// Every pixel of random triangles against bilinear SLERP in double precision. docs/accuracy.md holds the
// measured figures; here are the bounds.
#include <catch2/catch.hpp>
#include <tests/support/accuracy.hpp>
#include <tests/support/test_share.hpp>

using namespace arcspan::test;

namespace {

AccuracyFigures measure(double from, double to, double smallest, double largest, int triangles,
                        std::uint64_t seed, int shininess = 64,
                        Probe::Limits limits = Probe::Limits::kSharpest) {
  AccuracyTask task;
  task.shininess = shininess;
  task.limits = limits;
  task.from_degrees = from;
  task.to_degrees = to;
  task.smallest = smallest;
  task.largest = largest;
  task.triangles = share_of(triangles);
  task.seed = seed;
  const AccuracyFigures figures = measure_accuracy(task);
  CHECK(figures.missing_pixels == 0);
  CHECK(figures.pixels > figures.triangles * 50);
  return figures;
}

void check_cosines(const AccuracyFigures& f, double bound) {
  CHECK(f.normal_light.max < bound);
  CHECK(f.normal_half.max < bound);
  CHECK(f.normal_eye.max < bound);
}

}  // namespace

TEST_CASE("normals up to 30 degrees apart: diffuse light is within 1 step of 255, highlights within 2") {
  AccuracyFigures f = measure(0, 30, 0.3, 64, 30000, 1);
  f.add(measure(0, 3, 0.3, 64, 8000, 2));
  f.add(measure(3, 6, 0.3, 64, 8000, 3));
  f.add(measure(6, 11, 0.3, 64, 8000, 4));
  f.add(measure(0, 30, 64, 1024, 4000, 5));
  check_cosines(f, 3.3e-4);
  CHECK(f.normal_light.rms() < 0x1p-14);
  CHECK(f.normal_half.rms() < 0x1p-14);
  // Broader highlights take wider patches.
  f.add(measure(9, 30, 0.3, 64, 15000, 9, 16));
  f.add(measure(14, 30, 0.3, 64, 10000, 10, 4));
  f.add(measure(11, 30, 0.3, 64, 10000, 12, 11));
  f.add(measure(16, 30, 0.3, 64, 10000, 11, 1));
  check_cosines(f, 1.2e-3);
  CHECK(f.matt_steps <= 1);
  CHECK(f.blinn_steps <= 2);
  // R·V doubles the errors of both N·L and N·V, the rounding of the packed normals among them.
  CHECK(f.phong_steps <= 2);
}

TEST_CASE(
    "normals up to 30 degrees apart: highlights are within 2 steps by the patches of a program with them") {
  using Limits = Probe::Limits;
  for (const Limits limits : {Limits::kPhong, Limits::kBlinn}) {
    AccuracyFigures f = measure(14, 30, 0.3, 64, 8000, 13, 4, limits);
    f.add(measure(14, 30, 0.3, 64, 12000, 14, 16, limits));
    f.add(measure(9, 30, 0.3, 64, 12000, 15, 64, limits));
    check_cosines(f, 2.2e-3);
    CHECK(f.matt_steps <= 1);
    if (limits == Limits::kPhong) {
      CHECK(f.phong_steps <= 2);
    } else {
      CHECK(f.blinn_steps <= 2);
    }
  }
}

TEST_CASE("normals up to 45 degrees apart: highlights are within 3 steps, up to 60 degrees within 6") {
  for (const int shininess : {1, 4, 16, 64}) {
    INFO("exponents up to " << shininess);
    const auto seed = static_cast<std::uint64_t>(shininess);
    AccuracyFigures f = measure(30, 45, 0.3, 64, 6000, 100 + seed, shininess);
    f.add(measure(30, 45, 64, 1024, 500, 200 + seed, shininess));
    check_cosines(f, 1.2e-3);
    CHECK(f.matt_steps <= 1);
    CHECK(f.blinn_steps <= 3);
    CHECK(f.phong_steps <= 3);
    AccuracyFigures wide = measure(45, 60, 0.3, 64, 8000, 300 + seed, shininess);
    wide.add(measure(45, 60, 64, 1024, 500, 400 + seed, shininess));
    check_cosines(wide, 2e-3);
    CHECK(wide.matt_steps <= 2);
    CHECK(wide.blinn_steps <= 6);
    CHECK(wide.phong_steps <= 6);
  }
}

TEST_CASE("normals beyond 60 degrees apart, up to 120, are shaded as well") {
  const AccuracyFigures f = measure(60, 120, 0.3, 64, 8000, 8);
  check_cosines(f, 2e-3);
  CHECK(f.matt_steps <= 2);
  CHECK(f.blinn_steps <= 6);
  CHECK(f.phong_steps <= 6);
}
