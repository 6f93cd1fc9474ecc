// SPDX-License-Identifier: MIT
// Scenes some of whose parts are blended, against two scenes: what is opaque, then what is not, by a depth
// that is only read.
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/pixel/fog.hpp>
#include <arcspan/scene_outlines.hpp>
#include <arcspan/shading/with_operation.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/random_scene.hpp>
#include <tests/support/neighbours.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Glass = WithOperation<Unlit, Opacity<>>;
using Door = WithOperation<Unlit, ScreenDoor>;
using GlassAndRed = MethodList<Glass, Unlit>;

static_assert(detail::kBlends<Glass> && detail::kBlends<Wireframe<Glass>>);
static_assert(detail::kBlends<WithOperation<WithOperation<Unlit, Fogged>, Opacity<Blend::kAdd>>>);
static_assert(!detail::kBlends<Unlit> && !detail::kBlends<Door> && !detail::kBlends<Wireframe<Unlit>>);
static_assert(detail::kHasBlended<SceneMemory<GlassAndRed, 1>::UseList>);
static_assert(!detail::kHasBlended<SceneMemory<SceneMethods, 1>::UseList>);

const PreparedMaterial<Glass> kGreen(Glass::Lighting(Unlit::lighting({0, 220, 40}), Opacity<>{16}));
const PreparedMaterial<Glass> kBlue(Glass::Lighting(Unlit::lighting({10, 0, 240}), Opacity<>{9}));

/// Objects that are opaque, blended, and of parts of both kinds.
struct Shapes {
  Random random{5};
  TestMesh ball = make_sphere(7, 9, 32000, 0, random);
  TestMesh lump = make_sphere(4, 6, 32000, 6000, random);
  MeshView ball_mesh = ball.view();
  MeshView lump_mesh = lump.view();
  std::size_t rest = ball_mesh.triangle_count() - 50;
  Part mixed[4] = {{&kGreen, 0, 20}, {&kRed, 20, 30}, {&kBlue, 50, rest - 20}, {&kRed, 30 + rest, 20}};
  Part opaque[2] = {mixed[1], mixed[3]};
  Part blended[2] = {mixed[0], mixed[2]};

  /// All objects, or with the parts of one kind only. The places are the same.
  [[nodiscard]] std::vector<Object> objects(std::span<const Part> of_mixed, bool has_opaque,
                                            bool has_blended) const {
    std::vector<Object> made{
        {lump_mesh, kGreen}, {ball_mesh, kRed}, {ball_mesh, of_mixed}, {lump_mesh, kBlue}, {lump_mesh, kRed}};
    for (const std::size_t i : {1u, 4u}) made[i].visible = has_opaque;
    for (const std::size_t i : {0u, 3u}) made[i].visible = has_blended;
    return made;
  }
};

struct SplitScene {
  Camera camera;
  std::vector<Object> all;
  std::vector<Object> opaque;
  std::vector<Object> blended;

  [[nodiscard]] Scene scene(const std::vector<Object>& objects) const { return {camera, kLights, objects}; }
};

SplitScene random_split(Random& random, const Shapes& shapes) {
  SplitScene made{random_camera(random), shapes.objects(shapes.mixed, true, true),
                  shapes.objects(shapes.opaque, true, false), shapes.objects(shapes.blended, false, true)};
  for (std::size_t i = 0; i < made.all.size(); ++i) {
    Object& object = made.all[i];
    if (random.chance(0.3)) {
      place_beside_eye(random, object, made.camera, random.real(0.3, 1.5));
    } else {
      place_at_random(random, object, 2.5);
    }
    for (Object* same : {&made.opaque[i], &made.blended[i]}) {
      same->position = object.position;
      same->rotation = object.rotation;
      same->scale = object.scale;
    }
  }
  return made;
}

SceneMemory<GlassAndRed, 5, 200> memory;

/// The picture in two passes, and what both have drawn.
SceneResult draw_in_two(const SplitScene& split, Canvas& canvas) {
  const SceneResult first = draw_scene(split.scene(split.opaque), canvas.picture, canvas.depth, memory);
  const SceneResult second =
      draw_scene(split.scene(split.blended), canvas.picture, ReadOnlyDepth(canvas.depth), memory);
  REQUIRE(first.status == Status::kOk);
  REQUIRE(second.status == Status::kOk);
  return {Status::kOk, 0, first.triangles + second.triangles, first.left_out + second.left_out};
}

}  // namespace

TEST_CASE("blended parts are drawn after what is opaque, the farthest first, wherever objects list them") {
  const Shapes shapes;
  static SceneMemory<GlassAndRed, 5> no_vertices;
  static SceneMemory<GlassAndRed, 5, 1000, 1000> with_rows;
  Random random{41};
  std::size_t blended_pixels = 0;
  for (int i = 0; i < share_of(100); ++i) {
    const SplitScene split = random_split(random, shapes);
    Canvas expected;
    const SceneResult in_two = draw_in_two(split, expected);
    Canvas opaque;
    REQUIRE(ok(draw_scene(split.scene(split.opaque), opaque.picture, opaque.depth, memory).status));
    for (std::size_t k = 0; k < expected.pixels.size(); ++k)
      blended_pixels += opaque.pixels[k] != expected.pixels[k];

    Canvas canvas;
    const SceneResult drawn = draw_scene(split.scene(split.all), canvas.picture, canvas.depth, memory);
    REQUIRE(drawn.status == Status::kOk);
    CHECK(drawn.triangles == in_two.triangles);
    CHECK(drawn.left_out == in_two.left_out);
    CHECK(canvas.pixels == expected.pixels);
    CHECK(canvas.depths == expected.depths);
    CHECK(drawn_in_bands(split.scene(split.all), no_vertices, Canvas::kHeight) == expected.pixels);
    for (const std::int32_t rows : {8, 24})
      CHECK(drawn_in_bands(split.scene(split.all), with_rows, rows) == expected.pixels);
  }
  CHECK(blended_pixels > static_cast<std::size_t>(share_of(10000)));
}

TEST_CASE("an object of opaque and blended parts counts once") {
  const Shapes shapes;
  const Camera camera = Camera::of({WorldPoint::of(0, 0, 4), {}}, kLens, kScreen);
  std::vector<Object> objects = shapes.objects(shapes.mixed, true, true);
  Canvas canvas;
  const SceneResult drawn = draw_scene(Scene{camera, kLights, objects}, canvas.picture, canvas.depth, memory);
  CHECK(drawn.status == Status::kOk);
  CHECK(drawn.objects == 5);
}

TEST_CASE("a depth that is only read keeps the order from far to near for all parts") {
  const Camera camera = Camera::of({WorldPoint::of(0, 0, 4), {}}, kLens, kScreen);
  const Shapes shapes;
  // The opaque ball is nearer than the green one, and covers it.
  const Object objects[] = {{shapes.ball_mesh, kRed, WorldPoint::of(0, 0, 1)},
                            {shapes.ball_mesh, kGreen, WorldPoint::of(0, 0, -1)}};
  Canvas canvas;
  REQUIRE(ok(draw_scene(Scene{camera, kLights, objects}, canvas.picture, ReadOnlyDepth(canvas.depth), memory)
                 .status));
  CHECK(canvas.picture.pixel(Canvas::kWidth / 2, Canvas::kHeight / 2).g == 30);
}

TEST_CASE("outlines of a scene with blended parts are those of its bands") {
  const Shapes shapes;
  const TestNeighbours ball_neighbours{shapes.ball_mesh, true};
  const TestNeighbours lump_neighbours{shapes.lump_mesh};
  const OutlinedMesh outlined[2] = {{&shapes.ball_mesh, &ball_neighbours.view},
                                    {&shapes.lump_mesh, &lump_neighbours.view}};
  std::vector<TriangleSide> sides(200);
  std::vector<OutlineEdge> edges(3000);
  std::vector<OutlineGap<Rgb888>> gaps(8000);
  SceneOutlines<Rgb888> outlines{outlined, sides, OutlineList(edges), gaps};
  static SceneMemory<GlassAndRed, 5, 1000, 1000> with_rows;
  Random random{43};
  std::size_t smoothed = 0;
  for (int i = 0; i < share_of(40); ++i) {
    const SplitScene split = random_split(random, shapes);
    const Scene scene = split.scene(split.all);
    Canvas whole;
    REQUIRE(ok(draw_scene(scene, whole.picture, whole.depth, memory, Rgb8{10, 20, 30}, outlines).status));
    Canvas plain;
    REQUIRE(ok(draw_scene(scene, plain.picture, plain.depth, memory).status));
    smoothed += whole.pixels != plain.pixels;

    REQUIRE(ok(prepare_scene(scene, with_rows)));
    REQUIRE(ok(find_outlines(with_rows, outlines)));
    constexpr std::int32_t kRows = 12;
    Canvas band(kRows + 2);
    for (std::int32_t row = 0; row < Canvas::kHeight; row += kRows) {
      const std::int32_t first = row == 0 ? 0 : row - 1;
      band.move_to(first);
      REQUIRE(ok(draw_prepared_scene(with_rows, band.picture, band.depth).status));
      REQUIRE(ok(smooth_outlines(outlines.edges, band.picture, band.depth, outlines.gaps)));
      const auto at = band.pixels.begin() + std::ptrdiff_t{row - first} * Canvas::kWidth;
      CHECK(std::equal(at, at + std::ptrdiff_t{kRows} * Canvas::kWidth,
                       whole.pixels.begin() + std::ptrdiff_t{row} * Canvas::kWidth));
    }
  }
  CHECK(smoothed >= static_cast<std::size_t>(share_of(20)));
}
