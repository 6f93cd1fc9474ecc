// SPDX-License-Identifier: MIT
// Every pixel of random triangles against bilinear SLERP in double precision. docs/accuracy.md holds the
// measured figures; here are the bounds.
#include <catch2/catch.hpp>
#include <tests/support/accuracy.hpp>
#include <tests/support/test_share.hpp>

using namespace arcspan::test;

namespace {

AccuracyFigures measure(double from, double to, double smallest, double largest, int triangles,
                        std::uint64_t seed, int shininess = 64) {
  AccuracyTask task;
  task.shininess = shininess;
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

TEST_CASE("arcs up to 30 degrees keep the cosines within 2^-11 and the colours within 1 and 2") {
  AccuracyFigures f = measure(0, 30, 0.3, 64, 60000, 1);
  f.add(measure(0, 3, 0.3, 64, 15000, 2));
  f.add(measure(3, 6, 0.3, 64, 15000, 3));
  f.add(measure(6, 11, 0.3, 64, 15000, 4));
  f.add(measure(0, 30, 64, 1024, 5000, 5));
  f.add(measure(9, 16, 0.3, 64, 30000, 9, 16));  // broad highlights take wider patches
  check_cosines(f, 3.3e-4);                      // the demand is 2^-11; patches take what is more than 1e-4
  CHECK(f.matt_steps <= 1);
  CHECK(f.blinn_steps <= 2);
  // R·V doubles the errors of both N·L and N·V, the rounding of the packed normals among them.
  CHECK(f.phong_steps <= 2);
  // The largest errors are rare.
  CHECK(f.normal_light.rms() < 0x1p-15);
  CHECK(f.normal_half.rms() < 0x1p-15);
}

TEST_CASE("arcs up to 60 degrees keep the cosines within 2^-8") {
  AccuracyFigures f = measure(30, 60, 0.3, 64, 30000, 6);
  f.add(measure(55, 60, 0.3, 64, 15000, 7));
  f.add(measure(30, 60, 64, 1024, 5000, 8));
  check_cosines(f, 0x1p-8);
  CHECK(f.matt_steps <= 2);
  CHECK(f.normal_light.rms() < 0x1p-12);
}
