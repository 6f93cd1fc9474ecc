// SPDX-License-Identifier: MIT
// Every method of the literature against its own model in double precision: the integers add no more than the
// bound to what the method's mathematics is wrong by.
#include <arcspan/shading/literature/arc_vector.hpp>
#include <arcspan/shading/literature/duff.hpp>
#include <arcspan/shading/literature/kuijk_blake.hpp>
#include <arcspan/shading/literature/lyon.hpp>
#include <arcspan/shading/literature/phong.hpp>
#include <arcspan/shading/literature/recurrence_four.hpp>
#include <arcspan/shading/literature/slerp.hpp>

#include <catch2/catch.hpp>
#include <tests/support/method_accuracy.hpp>
#include <tests/support/test_share.hpp>

using namespace arcspan;
using namespace arcspan::test;

namespace {

template <class Method, class Model>
void check(double to_degrees, double bound, double rms_bound, std::uint64_t seed) {
  MethodTask task;
  task.to_degrees = to_degrees;
  task.triangles = share_of(4000);
  task.seed = seed;
  const MethodFigures f = measure_method<Method, Model>(task);
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
  check<Phong<Probe>, UnitLinearModel>(30, 1.3e-4, 2e-5, 11);
  check<Phong<Probe>, UnitLinearModel>(60, 1.3e-4, 2e-5, 12);
  check<Phong<Probe>, UnitLinearModel>(150, 4e-4, 4e-5, 13);
}

TEST_CASE("phong-reciprocal: its integers against linear normals divided by their length") {
  check<PhongReciprocal<Probe>, UnitLinearModel>(60, 1.3e-4, 2e-5, 12);
  check<PhongReciprocal<Probe>, UnitLinearModel>(150, 4e-4, 4e-5, 13);
}

TEST_CASE("duff: its integers against linear normals divided by their length") {
  check<Duff<Probe>, UnitLinearModel>(30, 1.3e-4, 2e-5, 21);
  check<Duff<Probe>, UnitLinearModel>(60, 1.3e-4, 2e-5, 22);
}

TEST_CASE("lyon: its integers against linear normals times the series") {
  check<Lyon<Probe>, TaylorModel>(30, 1.3e-4, 2e-5, 31);
  check<Lyon<Probe>, TaylorModel>(60, 1.3e-4, 2e-5, 32);
  check<Lyon<Probe>, TaylorModel>(120, 4e-4, 4e-5, 33);
}

TEST_CASE("recurrence: its integers against bilinear SLERP") {
  check<Recurrence<Probe>, SlerpModel>(30, 1e-4, 2e-5, 41);
  check<Recurrence<Probe>, SlerpModel>(58, 1e-3, 3e-5, 42);
}

TEST_CASE("recurrence-four: its integers against bilinear SLERP") {
  check<RecurrenceFour<Probe>, SlerpModel>(30, 1e-4, 2e-5, 41);
  check<RecurrenceFour<Probe>, SlerpModel>(58, 1e-3, 3e-5, 42);
}

TEST_CASE("arc-vector: its integers against bilinear SLERP") {
  check<ArcVector<Probe>, SlerpModel>(20, 1e-4, 2e-5, 41);
  check<ArcVector<Probe>, SlerpModel>(30, 1e-4, 2e-5, 41);
  check<ArcVector<Probe>, SlerpModel>(58, 1e-3, 3e-5, 42);
}

TEST_CASE("slerp: its integers against bilinear SLERP") {
  check<arcspan::Slerp<Probe>, SlerpModel>(1, 3e-4, 6e-5, 50);
  check<arcspan::Slerp<Probe>, SlerpModel>(30, 3e-4, 6e-5, 51);
  check<arcspan::Slerp<Probe>, SlerpModel>(58, 3e-4, 6e-5, 52);
}

TEST_CASE("kuijk-blake: its integers against bilinear SLERP") {
  check<KuijkBlake<Probe>, SlerpModel>(1, 2e-4, 4e-5, 60);
  check<KuijkBlake<Probe>, SlerpModel>(30, 2e-4, 4e-5, 61);
  check<KuijkBlake<Probe>, SlerpModel>(58, 2e-4, 4e-5, 62);
}
