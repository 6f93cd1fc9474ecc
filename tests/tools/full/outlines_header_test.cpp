// SPDX-License-Identifier: MIT
// The header that `arcspan mesh --outlines` writes, in a program.
#include <arcspan/mesh/mesh_neighbours.hpp>

#include <catch2/catch.hpp>
#include <outlined_torus.hpp>

using namespace arcspan;

TEST_CASE("a header with neighbours makes a view of them") {
  MeshView view;
  MeshNeighbours neighbours;
  REQUIRE(ok(outlined_torus::make_view(view)));
  REQUIRE(ok(outlined_torus::make_neighbours(view, neighbours)));
  CHECK(neighbours.triangle_count() == 576);
  CHECK(neighbours.bytes() == outlined_torus::kNeighbours);
  CHECK(2 * sizeof outlined_torus::kNeighbours <= 7 * view.triangle_count());
  // Arrays that were edited are refused.
  CHECK_FALSE(ok(outlined_torus::make_neighbours(view.part(0, 575), neighbours)));
}
