// SPDX-License-Identifier: MIT
// The rows of triangles that the memory of a scene keeps from band to band.
#include <catch2/catch.hpp>
#include <tests/pipeline/scene/scene_support.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Red = MethodList<Unlit>;
constexpr PreparedMaterial<Unlit> kTwoSidedRed(Unlit::lighting({90, 30, 20}), {.two_sided = true});

struct Ball {
  Random random{31};
  TestMesh shape = make_sphere(8, 12, 32000, 0, random);
  MeshView mesh = shape.view();
  Camera camera = Camera::of({WorldPoint::of(0, 0, 4), {}}, kLens, kScreen);
  std::size_t triangles = mesh.triangle_count();

  [[nodiscard]] Scene scene(std::span<const Object> objects) const { return {camera, kLights, objects}; }
};

TEST_CASE("rows are found by the first band of an object, once per frame, and not for a whole picture") {
  const Ball ball;
  Object object(ball.mesh, kRed);
  static SceneMemory<Red, 1, 200, 200> memory;
  const auto whole = drawn_in_bands(ball.scene({&object, 1}), memory, Canvas::kHeight);
  CHECK(memory.frame().entries[0].parts_with_rows == 0);
  // Nor are they for a band of more than half of its rows.
  Canvas large(Canvas::kHeight / 2 + 1);
  REQUIRE(ok(draw_prepared_scene(memory, large.picture, large.depth).status));
  CHECK(memory.frame().entries[0].parts_with_rows == 0);
  CHECK(drawn_in_bands(ball.scene({&object, 1}), memory, Canvas::kHeight / 2) == whole);
  CHECK(memory.frame().entries[0].parts_with_rows == 1);
  CHECK(drawn_in_bands(ball.scene({&object, 1}), memory, 8) == whole);
  const detail::SceneSlot& slot = memory.frame().entries[0];
  REQUIRE(slot.parts_with_rows == 1);

  std::vector<CachedVertex<Unlit>> vertices(ball.mesh.vertex_count());
  std::vector<TriangleRows> rows(TriangleRows::entries(ball.triangles));
  VertexCache<Unlit> cache(vertices, rows);
  REQUIRE(ok(cache.fill(ball.mesh, slot.transform, kRed.lighting())));
  CHECK(std::equal(rows.begin(), rows.end(), slot.rows));
  CHECK(std::count(rows.begin(), rows.end(), TriangleRows::culled()) > 50);

  // In the next frame the object is elsewhere, and its rows are found again.
  object.position = WorldPoint::of(0.3, 0.7, 0);
  const auto moved = drawn_in_bands(ball.scene({&object, 1}), memory, Canvas::kHeight);
  CHECK(moved != whole);
  CHECK(drawn_in_bands(ball.scene({&object, 1}), memory, 8) == moved);
}

TEST_CASE("each part has rows of its own, whatever its sides and whichever triangles it shares") {
  const Ball ball;
  const std::size_t third = ball.triangles / 3;
  const Part parts[] = {{&kRed, third, third + 5},
                        {&kTwoSidedRed, 0, ball.triangles},
                        {&kRed, 3, 0},
                        {&kTwoSidedRed, third, 7},
                        {&kRed, 0, ball.triangles}};
  std::size_t entries = 0;
  for (const Part& part : parts) entries += TriangleRows::entries(part.count);
  const Object objects[] = {{ball.mesh, std::span(parts)}, {ball.mesh, kRed, WorldPoint::of(0.5, 0.5, 0.5)}};
  static SceneMemory<Red, 2> memory;
  static SceneMemory<Red, 2, 0, 1000> with_rows;
  REQUIRE(entries < 700);
  // The camera is inside of the first ball, which the near plane cuts.
  for (const auto& eye : {WorldPoint::of(0, 0, 4), WorldPoint::of(0, 0, 1.2), WorldPoint::of(0.2, 0, 0)}) {
    Ball seen = ball;
    REQUIRE(ok(Camera::make({eye, WorldPoint::of(0, 0, -9)}, kLens, kScreen, seen.camera)));
    const auto whole = drawn_in_bands(seen.scene(objects), memory, Canvas::kHeight);
    for (const std::int32_t rows : {1, 8, 24})
      CHECK(drawn_in_bands(seen.scene(objects), with_rows, rows) == whole);
    CHECK(with_rows.frame().entries[0].parts_with_rows == 5);
    CHECK(with_rows.frame().entries[1].rows == with_rows.frame().entries[0].rows + entries);
  }
}

TEST_CASE("objects without room for their rows are drawn without, and others with") {
  const Ball ball;
  const TestMesh cube = make_smooth_cube(18000);
  const MeshView cube_mesh = cube.view();
  const Object objects[] = {{ball.mesh, kRed, WorldPoint::of(-1, 0, 0)},
                            {ball.mesh, kRed, WorldPoint::of(1, 0, 0)},
                            {cube_mesh, kRed, WorldPoint::of(0, 1, 0)}};
  using View = SceneMemoryView<Red>;
  const auto of_ball = static_cast<std::uint32_t>(ball.triangles);
  const auto of_cube = static_cast<std::uint32_t>(cube_mesh.triangle_count());
  std::vector<std::byte> memory(100000);
  View none(memory, {3, 500, 0});
  const auto whole = drawn_in_bands(ball.scene(objects), none, Canvas::kHeight);
  const auto has_rows = [&](std::uint32_t triangles) {
    View view(memory, {3, 500, triangles});
    CHECK(drawn_in_bands(ball.scene(objects), view, 8) == whole);
    std::vector<bool> has;
    for (const detail::SceneSlot& slot : view.frame().entries) has.push_back(slot.rows != nullptr);
    return has;
  };
  using Has = std::vector<bool>;
  CHECK(has_rows(0) == Has{false, false, false});
  CHECK(has_rows(of_cube - 1) == Has{false, false, false});
  CHECK(has_rows(of_cube) == Has{false, false, true});
  CHECK(has_rows(of_ball) == Has{true, false, false});
  CHECK(has_rows(of_ball + of_cube) == Has{true, false, true});
  CHECK(has_rows(2 * of_ball + of_cube) == Has{true, true, true});
  CHECK(View::bytes({3, 500, 160}) == View::bytes({3, 500, 0}) + 340);
  if constexpr (sizeof(std::size_t) == 8) {
    CHECK(View::bytes({3, 500, UINT32_MAX}) ==
          View::bytes({3, 500, 0}) + 2 * (std::size_t{UINT32_MAX} + UINT32_MAX / 16));
  } else {
    CHECK(View::bytes({3, 500, UINT32_MAX}) == SIZE_MAX);
  }
}

}  // namespace
