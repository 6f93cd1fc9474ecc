// SPDX-License-Identifier: MIT
// The header that `arcspan mesh --planes` writes, in a program.
#include <arcspan/mesh/make_face_planes.hpp>

#include <catch2/catch.hpp>
#include <planed_torus.hpp>

#include <algorithm>
#include <vector>

using namespace arcspan;

TEST_CASE("a header with planes makes a view that has them") {
  MeshView view;
  REQUIRE(ok(planed_torus::make_view(view)));
  REQUIRE(view.triangle_count() == 576);
  std::vector<FacePlane> planes(view.triangle_count());
  PlaneScale scale;
  REQUIRE(ok(make_face_planes(view, planes, scale)));
  REQUIRE(view.planes() != nullptr);
  CHECK(std::equal(planes.begin(), planes.end(), view.planes()));
  CHECK(view.plane_scale() == scale);
}
