// SPDX-License-Identifier: MIT
// Every method of the literature against its own model in double precision: the integers add no more than the
// bound to what the method's mathematics is wrong by.
#include <catch2/catch.hpp>
#include <tests/support/method_accuracy.hpp>
#include <tests/support/test_share.hpp>

using namespace arcspan;
using namespace arcspan::test;

namespace {

template <class Model>
void check(std::string_view method, double to_degrees, double bound, double rms_bound, std::uint64_t seed) {
  MethodTask task;
  task.to_degrees = to_degrees;
  task.triangles = share_of(4000);
  task.seed = seed;
  const MethodFigures f = measure_method<Model>(probed_method(method), task);
  INFO("N·L max " << f.normal_light.max << " rms " << f.normal_light.rms() << ", N·H max "
                  << f.normal_half.max << ", pixels " << f.normal_light.count << ", slivers max "
                  << f.slivers.max << " rms " << f.slivers.rms());
  CHECK(f.missing == 0);
  CHECK(f.normal_light.count > static_cast<std::uint64_t>(task.triangles) * 20);
  CHECK(f.normal_light.max < bound);
  CHECK(f.normal_half.max < bound);
  CHECK(f.normal_light.rms() < rms_bound);
  CHECK(f.slivers.rms() < 0.05);
}

}  // namespace

TEST_CASE("phong: its integers against linear normals divided by their length") {
  check<UnitLinearModel>("phong", 30, 1.3e-4, 2e-5, 11);
  check<UnitLinearModel>("phong", 60, 1.3e-4, 2e-5, 12);
  check<UnitLinearModel>("phong", 150, 4e-4, 4e-5, 13);
}

TEST_CASE("phong-reciprocal: its integers against linear normals divided by their length") {
  check<UnitLinearModel>("phong-reciprocal", 60, 1.3e-4, 2e-5, 12);
  check<UnitLinearModel>("phong-reciprocal", 150, 4e-4, 4e-5, 13);
}

TEST_CASE("duff: its integers against linear normals divided by their length") {
  check<UnitLinearModel>("duff", 30, 1.3e-4, 2e-5, 21);
  check<UnitLinearModel>("duff", 60, 1.3e-4, 2e-5, 22);
}

TEST_CASE("lyon: its integers against linear normals times the series") {
  check<TaylorModel>("lyon", 30, 1.3e-4, 2e-5, 31);
  check<TaylorModel>("lyon", 60, 1.3e-4, 2e-5, 32);
  check<TaylorModel>("lyon", 120, 4e-4, 4e-5, 33);
}

TEST_CASE("recurrence: its integers against bilinear SLERP") {
  check<SlerpModel>("recurrence", 30, 1e-4, 2e-5, 41);
  check<SlerpModel>("recurrence", 58, 1e-3, 3e-5, 42);
}

TEST_CASE("recurrence-four: its integers against bilinear SLERP") {
  check<SlerpModel>("recurrence-four", 30, 1e-4, 2e-5, 41);
  check<SlerpModel>("recurrence-four", 58, 1e-3, 3e-5, 42);
}

TEST_CASE("arc-vector: its integers against bilinear SLERP") {
  check<SlerpModel>("arc-vector", 20, 1e-4, 2e-5, 41);
  check<SlerpModel>("arc-vector", 30, 1e-4, 2e-5, 41);
  check<SlerpModel>("arc-vector", 58, 1e-3, 3e-5, 42);
}

TEST_CASE("slerp: its integers against bilinear SLERP") {
  check<SlerpModel>("slerp", 1, 3e-4, 6e-5, 50);
  check<SlerpModel>("slerp", 30, 3e-4, 6e-5, 51);
  check<SlerpModel>("slerp", 58, 3e-4, 6e-5, 52);
}

TEST_CASE("kuijk-blake: its integers against bilinear SLERP") {
  check<SlerpModel>("kuijk-blake", 1, 2e-4, 4e-5, 60);
  check<SlerpModel>("kuijk-blake", 30, 2e-4, 4e-5, 61);
  check<SlerpModel>("kuijk-blake", 58, 2e-4, 4e-5, 62);
}
