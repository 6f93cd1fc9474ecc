// SPDX-License-Identifier: MIT
// Scene memory whose size is known when the program runs.
#include <arcspan/drawn_rect.hpp>
#include <arcspan/pick.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/scene_support.hpp>

#include <cstddef>
#include <span>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using View = SceneMemoryView<SceneMethods>;

struct TwoBalls {
  Random random{7};
  TestMesh shape = make_sphere(6, 8, 32000, 0, random);
  MeshView mesh = shape.view();
  Object objects[2] = {{mesh, kCopper, WorldPoint::of(-0.8, 0, 0)},
                       {mesh, kRed, WorldPoint::of(0.9, 0.3, -1)}};
  Camera camera = Camera::of({WorldPoint::of(0, 0, 4), {}}, kLens, kScreen);

  [[nodiscard]] Scene scene() const { return {camera, kLights, objects}; }
  [[nodiscard]] SceneLimits limits() const {
    return {2, static_cast<std::uint32_t>(2 * mesh.vertex_count()),
            static_cast<std::uint32_t>(2 * mesh.triangle_count())};
  }
};

TEST_CASE("a scene in bytes of the caller's is drawn as in SceneMemory, at any address") {
  const TwoBalls balls;
  static SceneMemory<SceneMethods, 2, 200, 200> constant;
  const auto expected = drawn_in_bands(balls.scene(), constant, 20);
  const Rect rect = drawn_rect(constant);
  // An odd number of vertices whose sizes are no multiples of 8.
  static SceneMemory<MethodList<Unlit>, 2, 51> small;
  CHECK(small.frame().vertices.size() >= 51 * sizeof(CachedVertex<Unlit>) + 14);
  const std::size_t bytes = View::bytes(balls.limits());
  for (std::size_t offset = 0; offset < 9; ++offset) {
    std::vector<std::byte> memory(bytes + offset, std::byte{0xA5});  // sanitizers see what is beyond
    View view(std::span<std::byte>(memory).subspan(offset), balls.limits());
    REQUIRE(ok(view.status()));
    CHECK((drawn_in_bands(balls.scene(), view, 20) == expected));
    CHECK(view.frame().entries[1].parts_with_rows == 1);
    CHECK(view.frame()
              .header.keeps_vertices);  // of objects that begin at multiples of 8, in both kinds of memory
    CHECK(drawn_rect(view) == rect);
    CHECK(pick(view, Canvas::kWidth / 4, Canvas::kHeight / 2).object == &balls.objects[0]);
  }
}

TEST_CASE("bytes that are one too few are refused by every function") {
  const TwoBalls balls;
  std::vector<std::byte> memory(View::bytes(balls.limits()) - 1);
  View view(memory, balls.limits());
  CHECK(view.status() == Status::kBufferTooSmall);
  CHECK(prepare_scene(balls.scene(), view) == Status::kBufferTooSmall);
  Canvas canvas;
  CHECK(draw_prepared_scene(view, canvas.picture, canvas.depth).status == Status::kBufferTooSmall);
  CHECK(drawn_rect(view) == Rect{});
  CHECK(drawn_rect(view, balls.objects[0]) == Rect{});
  CHECK(pick(view, 1, 1).status == Status::kBufferTooSmall);
  CHECK(View().status() == Status::kBufferTooSmall);
}

TEST_CASE("limits are those of the scene: objects, vertices, and sizes that no memory has") {
  const TwoBalls balls;
  std::vector<std::byte> memory(100000);
  View few_objects(memory, {1, 200});
  CHECK(prepare_scene(balls.scene(), few_objects) == Status::kTooManyObjects);
  View no_vertices(memory, {2, 0});
  CHECK(prepare_scene(balls.scene(), no_vertices) == Status::kCacheTooSmall);
  View not_prepared(memory, balls.limits());
  Canvas canvas;
  CHECK(draw_prepared_scene(not_prepared, canvas.picture, canvas.depth).status == Status::kNotReady);
  if constexpr (sizeof(std::size_t) == 4) CHECK(View::bytes({65535, UINT32_MAX}) == SIZE_MAX);
  CHECK(View::bytes({65535, 1000000}) > View::bytes({65534, 1000000}));
}

}  // namespace
