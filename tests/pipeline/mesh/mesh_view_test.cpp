// SPDX-License-Identifier: MIT
#include <arcspan/mesh/bounding_sphere.hpp>
#include <arcspan/mesh/mesh_view.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <vector>

using namespace arcspan;

TEST_CASE("a mesh view checks its arrays once") {
  const std::array<ObjectPosition, 3> positions{{{1, 2, 3}, {-4, 5, 6}, {7, 8, -9}}};
  const std::array<PackedNormal, 3> normals{};
  const std::array<std::uint8_t, 6> indices{0, 1, 2, 2, 1, 0};
  MeshView view;
  REQUIRE(ok(MeshView::make(positions, normals, std::span<const std::uint8_t>(indices), view)));
  CHECK(view.vertex_count() == 3);
  CHECK(view.triangle_count() == 2);
  CHECK(view.triangle(1).a == 2);
  CHECK(view.position(1) == ObjectPosition{-4, 5, 6});

  MeshView untouched = view;
  const std::array<std::uint8_t, 3> beyond{0, 1, 3};
  CHECK(MeshView::make(positions, normals, std::span<const std::uint8_t>(beyond), untouched) ==
        Status::kIndexOutOfRange);
  const std::array<std::uint16_t, 3> far_beyond{0, 65535, 1};
  CHECK(MeshView::make(positions, normals, std::span<const std::uint16_t>(far_beyond), untouched) ==
        Status::kIndexOutOfRange);
  const std::array<std::uint8_t, 4> ragged{0, 1, 2, 0};
  CHECK(MeshView::make(positions, normals, std::span<const std::uint8_t>(ragged), untouched) ==
        Status::kInvalidArgument);
  const std::array<PackedNormal, 2> few{};
  CHECK(MeshView::make(positions, few, std::span<const std::uint8_t>(indices), untouched) ==
        Status::kInvalidArgument);
  CHECK(untouched.triangle_count() == 2);
}

TEST_CASE("a mesh view holds 65536 vertices and not one more, and may be empty") {
  std::vector<ObjectPosition> positions(65537);
  std::vector<PackedNormal> normals(65537);
  const std::array<std::uint16_t, 3> indices{0, 65535, 1};
  MeshView view;
  CHECK(MeshView::make(positions, normals, std::span<const std::uint16_t>(indices), view) ==
        Status::kInvalidArgument);
  positions.pop_back();
  normals.pop_back();
  CHECK(ok(MeshView::make(positions, normals, std::span<const std::uint16_t>(indices), view)));
  CHECK(view.triangle(0).b == 65535);
  CHECK(ok(MeshView::make({}, {}, std::span<const std::uint16_t>(), view)));
  CHECK(view.triangle_count() == 0);
}

TEST_CASE("the bounding sphere of a mesh lies around the middle of its box, wherever that is") {
  const std::array<ObjectPosition, 2> positions{{{1000, 20000, -30000}, {1200, 20400, -30400}}};
  const std::array<PackedNormal, 2> normals{};
  MeshView view;
  REQUIRE(ok(MeshView::make(positions, normals, std::span<const std::uint8_t>(), view)));
  CHECK(bounding_sphere(view) == BoundingSphere{{1100, 20200, -30200}, 300});
}
