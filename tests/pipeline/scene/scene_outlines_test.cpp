// SPDX-License-Identifier: MIT
// Smooth outlines of whole scenes, against the same calls for each object alone.
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/scene_outlines.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/texture/texel_formats.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/random_scene.hpp>
#include <tests/support/circle.hpp>
#include <tests/support/neighbours.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// A mesh of several parts and one without.
struct Meshes {
  Random random{11};
  TestMesh ball = make_sphere(7, 9, 32000, 0, random);
  TestMesh lump = make_sphere(4, 6, 32000, 6000, random);
  MeshView ball_mesh = ball.view();
  MeshView lump_mesh = lump.view();
  TestNeighbours ball_neighbours{ball_mesh, true};
  TestNeighbours lump_neighbours{lump_mesh};
  OutlinedMesh outlined[2] = {{&ball_mesh, &ball_neighbours.view}, {&lump_mesh, &lump_neighbours.view}};
  Part same[2] = {{&kCopper, 0, 30}, {&kJade, 30, ball_mesh.triangle_count() - 30}};
  PreparedMaterial<Unlit> both_sides{Unlit::lighting({200, 30, 20}), {.two_sided = true}};
  /// The last one hides the backs of some triangles that both show.
  Part different[3] = {
      {&kRed, 0, 17}, {&both_sides, 40, 30}, {&kCopper, 60, ball_mesh.triangle_count() - 60}};
};

struct Room {
  std::vector<TriangleSide> sides;
  std::vector<OutlineEdge> edges;
  std::vector<OutlineGap<Rgb888>> gaps;
  SceneOutlines<Rgb888> outlines;

  explicit Room(const Meshes& meshes, std::size_t most_edges = 2000)
      : sides(200),
        edges(most_edges),
        gaps(5000),
        outlines{meshes.outlined, sides, OutlineList(edges), gaps} {}
};

RandomObjects random_objects(Random& random, const Meshes& meshes) {
  RandomObjects made{random_camera(random), {}};
  made.objects = {{meshes.ball_mesh, kCopper},
                  {meshes.ball_mesh, std::span(meshes.same)},
                  {meshes.ball_mesh, std::span(meshes.different)},
                  {meshes.lump_mesh, kRed}};
  for (Object& object : made.objects) place_at_random(random, object, 2.5);
  return made;
}

/// The objects in view, the nearest first, as their outlines are listed: of two surfaces that meet between
/// the same pixels the first counts.
template <class Memory>
std::vector<const detail::SceneSlot*> slots_of(Memory& memory) {
  const detail::SceneFrame frame = memory.frame();
  std::vector<const detail::SceneSlot*> slots;
  for (std::size_t i = 0; i < frame.header.in_view; ++i) slots.push_back(&frame.entries[frame.order[i]]);
  return slots;
}

/// Adds the outlines of an object by calls that know nothing of scenes.
void add_alone(const Meshes& meshes, const Camera& camera, const Object& object, OutlineList& edges) {
  ClipTransform transform;
  if (!camera.place(object.position, object.rotation, object.scale, transform)) return;
  const MeshView& mesh = object.mesh();
  std::vector<TriangleSide> sides(mesh.triangle_count(), TriangleSide::kHidden);
  for (std::size_t i = 0; i < object.part_count(); ++i) {
    const Part part = object.part(i);
    std::vector<TriangleSide> of_part(part.count);
    REQUIRE(ok(find_sides<Unlit>(mesh.part(part.first, part.count), transform, Unlit::lighting({}), NoCache{},
                                 of_part,
                                 static_cast<const PreparedMaterial<Unlit>*>(part.material)->options())));
    std::copy(of_part.begin(), of_part.end(), sides.begin() + static_cast<std::ptrdiff_t>(part.first));
  }
  const auto& neighbours = &mesh == &meshes.ball_mesh ? meshes.ball_neighbours : meshes.lump_neighbours;
  REQUIRE(ok(edges.add(mesh, neighbours.view, VertexPositions(transform), sides)));
}

/// Room for curves, too.
struct CurvedRoom : Room {
  std::unique_ptr<CurveMemory<400>> curve_memory = std::make_unique<CurveMemory<400>>();
  SceneOutlines<Rgb888, CurvedOutlines> outlines;

  explicit CurvedRoom(const Meshes& meshes)
      : Room(meshes),
        outlines{meshes.outlined, sides, OutlineList(edges), gaps, CurvedOutlines(*curve_memory)} {}
};

/// The words of a picture of which `draw` draws each band, and gets its first row.
template <class Draw>
std::vector<Picture::Word> in_bands(std::int32_t rows, const Draw& draw) {
  std::vector<Picture::Word> all;
  Canvas band(rows + 2);
  for (std::int32_t row = 0; row < Canvas::kHeight; row += rows) {
    const std::int32_t first = row == 0 ? 0 : row - 1;
    band.move_to(first);
    draw(band, row);
    const auto begin = band.pixels.begin() + std::ptrdiff_t{row - first} * Canvas::kWidth;
    all.insert(all.end(), begin, begin + std::ptrdiff_t{rows} * Canvas::kWidth);
  }
  return all;
}

template <class Memory>
std::vector<Picture::Word> drawn_in_bands(const Scene& scene, Memory& memory, Room& room, std::int32_t rows) {
  REQUIRE(ok(prepare_scene(scene, memory)));
  return in_bands(rows, [&](Canvas& band, std::int32_t row) {
    REQUIRE(ok(draw_prepared_scene(memory, band.picture, band.depth).status));
    // After drawing, although that may have left the vertices of another object.
    if (row == 0) REQUIRE(ok(find_outlines(memory, room.outlines)));
    REQUIRE(ok(smooth_outlines(room.outlines.edges, band.picture, band.depth, room.outlines.gaps)));
  });
}

TEST_CASE("outlines of scenes are smoothed as those of their objects, also in bands") {
  const Meshes meshes;
  static SceneMemory<SceneMethods, 4, 400, 1000> own_vertices;
  static SceneMemory<SceneMethods, 4, 100> shared_vertices;
  static SceneMemory<SceneMethods, 4> no_vertices;
  Random random(3);
  int smoothed = 0;
  for (int repeat = 0; repeat < share_of(200); ++repeat) {
    const RandomObjects objects = random_objects(random, meshes);
    Room room(meshes);
    Canvas plain;
    REQUIRE(
        ok(draw_scene(objects.scene(), plain.picture, plain.depth, own_vertices, Rgb8{10, 20, 30}).status));
    std::vector<OutlineEdge> memory(2000);
    OutlineList edges(memory);
    for (const detail::SceneSlot* slot : slots_of(own_vertices))
      add_alone(meshes, objects.camera, *slot->object, edges);
    REQUIRE(ok(smooth_outlines(edges, plain.picture, plain.depth, std::span(room.gaps))));
    Canvas by_scene;
    REQUIRE(ok(draw_scene(objects.scene(), by_scene.picture, by_scene.depth, own_vertices, Rgb8{10, 20, 30},
                          room.outlines)
                   .status));
    CHECK(by_scene.pixels == plain.pixels);
    CHECK(by_scene.depths == plain.depths);
    CHECK(drawn_in_bands(objects.scene(), own_vertices, room, 24) == plain.pixels);
    CHECK(drawn_in_bands(objects.scene(), shared_vertices, room, 12) == plain.pixels);
    CHECK(drawn_in_bands(objects.scene(), no_vertices, room, 36) == plain.pixels);
    if (!edges.edges().empty()) ++smoothed;
  }
  CHECK(smoothed >= share_of(200) * 3 / 4);
}

TEST_CASE("outlines of scenes are inked as by ink_outlines()") {
  const Meshes meshes;
  static SceneMemory<SceneMethods, 4, 400> memory;
  Random random(4);
  int inked = 0;
  for (int repeat = 0; repeat < share_of(40); ++repeat) {
    const RandomObjects objects = random_objects(random, meshes);
    const OutlineInk ink{{200, 30, 20}, static_cast<std::uint8_t>(random.integer(1, 4)), random.chance(0.5)};
    Room room(meshes);
    Canvas by_calls;
    REQUIRE(ok(prepare_scene(objects.scene(), memory)));
    REQUIRE(ok(find_outlines(memory, room.outlines)));
    REQUIRE(ok(draw_prepared_scene(memory, by_calls.picture, by_calls.depth, Rgb8{10, 20, 30}).status));
    const auto plain = by_calls.pixels;
    const OutlineList& edges = room.outlines.edges;
    REQUIRE(ok(ink_outlines(edges, ink, by_calls.picture, by_calls.depth, room.outlines.gaps)));
    if (by_calls.pixels != plain) ++inked;
    REQUIRE(ok(smooth_outlines(edges, by_calls.picture, by_calls.depth, room.outlines.gaps)));
    Canvas at_once;
    REQUIRE(ok(draw_scene(objects.scene(), at_once.picture, at_once.depth, memory, Rgb8{10, 20, 30},
                          room.outlines, ink)
                   .status));
    CHECK(at_once.pixels == by_calls.pixels);
    CHECK(at_once.depths == by_calls.depths);
    // Ink reaches bands that its object does not, with two rows more on both sides.
    constexpr std::int32_t kRows = 3;
    Canvas band(kRows + 4);
    for (std::int32_t row = 0; row < Canvas::kHeight; row += kRows) {
      const std::int32_t first = row < 2 ? 0 : row - 2;
      band.move_to(first);
      REQUIRE(ok(
          draw_scene(objects.scene(), band.picture, band.depth, memory, Rgb8{10, 20, 30}, room.outlines, ink)
              .status));
      const auto begin = band.pixels.begin() + std::ptrdiff_t{row - first} * Canvas::kWidth;
      const auto expected = at_once.pixels.begin() + std::ptrdiff_t{row} * Canvas::kWidth;
      CHECK(std::equal(begin, begin + std::ptrdiff_t{kRows} * Canvas::kWidth, expected));
    }
    const OutlineInk too_wide{{}, 5};
    CHECK(draw_scene(objects.scene(), at_once.picture, at_once.depth, memory, Rgb8{}, room.outlines, too_wide)
              .status == Status::kInvalidArgument);
  }
  CHECK(inked >= share_of(40) * 3 / 4);
}

TEST_CASE("a scene of which an object cannot be smoothed is drawn, with the others smoothed") {
  const Meshes meshes;
  static SceneMemory<SceneMethods, 2, 200> memory;
  const Object both[2] = {{meshes.ball_mesh, kCopper, WorldPoint::of(-0.8, 0, 0)},
                          {meshes.lump_mesh, kRed, WorldPoint::of(0.9, 0.3, -1)}};
  const Camera camera = Camera::of({WorldPoint::of(0, 0, 4), {}}, kLens, kScreen);
  const auto drawn = [&](std::span<const Object> objects, Room& room, Status expected) {
    Canvas canvas;
    const SceneResult result =
        draw_scene({camera, kLights, objects}, canvas.picture, canvas.depth, memory, Rgb8{}, room.outlines);
    CHECK(result.status == expected);
    CHECK(result.objects == objects.size());
    return room.outlines.edges.edges().size();
  };
  Room room(meshes);
  const std::size_t of_both = drawn(both, room, Status::kOk);
  const std::size_t of_first = drawn(std::span(both).first(1), room, Status::kOk);
  const std::size_t of_second = drawn(std::span(both).last(1), room, Status::kOk);
  CHECK(of_both == of_first + of_second);
  REQUIRE(of_first > of_second);

  SECTION("without neighbours") {
    room.outlines.meshes = std::span(meshes.outlined).first(1);
    CHECK(drawn(both, room, Status::kUnsupported) == of_first);
  }
  SECTION("with those of another mesh") {
    const OutlinedMesh swapped[2] = {{&meshes.ball_mesh, &meshes.lump_neighbours.view}, meshes.outlined[1]};
    room.outlines.meshes = swapped;
    CHECK(drawn(both, room, Status::kInvalidArgument) == of_second);
  }
  SECTION("with too few sides") {
    room.outlines.sides = std::span(room.sides).first(meshes.ball_mesh.triangle_count() - 1);
    CHECK(drawn(both, room, Status::kBufferTooSmall) == of_second);
  }
  SECTION("with too few edges") {
    Room small(meshes, of_first - 1);
    CHECK(drawn(both, small, Status::kBufferTooSmall) == of_second);
  }
  SECTION("with too few gaps, or none") {
    room.outlines.gaps = std::span(room.gaps).first(9);
    CHECK(drawn(both, room, Status::kBufferTooSmall) == of_both);
    room.outlines.gaps = {};
    CHECK(drawn(both, room, Status::kBufferTooSmall) == of_both);
  }
}

TEST_CASE("outlines are not found before a scene is prepared") {
  const Meshes meshes;
  Room room(meshes);
  static SceneMemory<SceneMethods, 2, 200> memory;
  CHECK(find_outlines(memory, room.outlines) == Status::kNotReady);
  SceneMemoryView<SceneMethods> nothing;
  CHECK(find_outlines(nothing, room.outlines) == Status::kBufferTooSmall);
}

/// A picture with curves in bands. Without `background` they are not cleared by the scene.
template <class Memory>
std::vector<Picture::Word> curved_in_bands(const Scene& scene, Memory& memory, CurvedRoom& room,
                                           std::int32_t rows, const Rgb8* background = nullptr) {
  REQUIRE(ok(prepare_scene(scene, memory)));
  REQUIRE(ok(find_outlines(memory, room.outlines)));
  const CurvedOutlines& curves = room.outlines.curves;
  return in_bands(rows, [&](Canvas& band, std::int32_t) {
    const SceneResult result =
        background == nullptr ? draw_prepared_scene(memory, band.picture, band.depth, curves)
                              : draw_prepared_scene(memory, band.picture, band.depth, *background, curves);
    REQUIRE(ok(result.status));
    REQUIRE(ok(smooth_outlines(room.outlines.edges, band.picture, band.depth, room.outlines.gaps)));
  });
}

TEST_CASE("curves are drawn with the objects of a scene as objects of their own are, also in bands") {
  const Meshes meshes;
  static SceneMemory<SceneMethods, 8, 1200> own_vertices;
  static SceneMemory<SceneMethods, 8, 400> shared_vertices;
  static SceneMemory<SceneMethods, 8, 0, 300> no_vertices;
  Random random(5);
  std::size_t found = 0;
  for (int repeat = 0; repeat < share_of(200); ++repeat) {
    RandomObjects objects = random_objects(random, meshes);
    CurvedRoom room(meshes);
    Canvas by_scene;
    REQUIRE(ok(draw_scene(objects.scene(), by_scene.picture, by_scene.depth, own_vertices, Rgb8{10, 20, 30},
                          room.outlines)
                   .status));
    const CurvedOutlines& curves = room.outlines.curves;
    found += curves.count();
    // Objects of several parts have none.
    std::vector<MeshView> views;
    std::vector<Object> with_curves = objects.objects;
    views.reserve(objects.objects.size());
    std::size_t first = 0;
    for (const detail::SceneSlot* slot : slots_of(own_vertices)) {
      views.push_back(curves.mesh(first, slot->end_of_curves));
      first = slot->end_of_curves;
      const Object& object = *slot->object;
      if (object.part_count() != 1) CHECK(views.back().triangle_count() == 0);
      if (views.back().triangle_count() == 0) continue;
      Object& added = with_curves.emplace_back(views.back(), *object.part(0).material, object.sphere());
      added.position = object.position;
      added.rotation = object.rotation;
      added.scale = object.scale;
    }
    Canvas by_objects;
    REQUIRE(ok(draw_scene({objects.camera, kLights, with_curves}, by_objects.picture, by_objects.depth,
                          no_vertices, Rgb8{10, 20, 30})
                   .status));
    REQUIRE(
        ok(smooth_outlines(room.outlines.edges, by_objects.picture, by_objects.depth, std::span(room.gaps))));
    CHECK(by_scene.pixels == by_objects.pixels);
    CHECK(by_scene.depths == by_objects.depths);
    constexpr Rgb8 kBackground{10, 20, 30};
    CHECK(curved_in_bands(objects.scene(), own_vertices, room, 4) == by_scene.pixels);
    CHECK(curved_in_bands(objects.scene(), shared_vertices, room, 12, &kBackground) == by_scene.pixels);
    CHECK(curved_in_bands(objects.scene(), no_vertices, room, 36) == by_scene.pixels);
  }
  CHECK(found > 10 * static_cast<std::size_t>(share_of(200)));
  STATIC_REQUIRE(detail::kDrawsCurves<SceneMethod>);
  STATIC_REQUIRE_FALSE(detail::kDrawsCurves<Textured<SceneMethod, DirectTexels<>>>);
  STATIC_REQUIRE_FALSE(detail::kDrawsCurves<Wireframe<>>);
}

TEST_CASE("a curve that leaves the sphere of its object is drawn in all bands") {
  // A wedge whose upper edge bulges as far as any.
  constexpr double kRadius = 30990;
  TestMesh wedge;
  for (const double side : {-1.0, 1.0})
    wedge.add(kRadius * Vec3{0.232 * side, 0.9727, 0}, Vec3{0.591 * side, 0.806, 0});
  for (const double front : {1.0, -1.0}) wedge.add(kRadius * Vec3{0, -0.9, 0.1 * front}, Vec3{0, -1, 0});
  wedge.triangle(0, 2, 1);
  wedge.triangle(0, 1, 3);
  wedge.triangle(0, 3, 2);
  wedge.triangle(1, 2, 3);
  const MeshView mesh = wedge.view();
  const TestNeighbours neighbours(mesh);
  const OutlinedMesh outlined[] = {{&mesh, &neighbours.view}};
  const Object object(mesh, kCopper, BoundingSphere{{}, 31000});
  static SceneMemory<SceneMethods, 1, 4> memory;
  const Meshes meshes;
  CurvedRoom room(meshes);
  room.outlines.meshes = outlined;
  for (int i = 0; i < 8; ++i) {
    Camera camera;  // the sphere is 100 pixels high and ends at the middle of the picture
    const double up = 31000.0 / 32768 + i / 400.0;
    REQUIRE(ok(Camera::make({to_point({0, up, 6}), to_point({0, up, 0})},
                            Lens::orthographic(to_world(0.7), to_world(1), to_world(12)), kScreen, camera)));
    const Scene scene{camera, kLights, {&object, 1}};
    Canvas whole;
    REQUIRE(
        ok(draw_scene(scene, whole.picture, whole.depth, memory, Rgb8{10, 20, 30}, room.outlines).status));
    REQUIRE(room.outlines.curves.count() == 1);
    CHECK(curved_in_bands(scene, memory, room, 4) == whole.pixels);
  }
}

TEST_CASE("the outline of a coarse sphere in a scene deviates from a circle by half as much with curves") {
  Random random(6);
  const TestMesh ball = make_sphere(8, 16, 32000, 0, random);
  const MeshView mesh = ball.view();
  const TestNeighbours neighbours(mesh);
  const OutlinedMesh outlined[] = {{&mesh, &neighbours.view}};
  static SceneMemory<SceneMethods, 1, 200> memory;
  double straight_sum = 0;
  double curved_sum = 0;
  for (int i = 0; i < 12; ++i) {
    Object object(mesh, kCopper);
    object.rotation = random_rotation(random);
    // Parallel rays: the radius is that of the sphere, 32000 / 32768 of half the picture's height.
    Camera camera;
    REQUIRE(ok(Camera::make({WorldPoint::of(0, 0, 6), {}},
                            Lens::orthographic(to_world(2), to_world(1), to_world(12)), kScreen, camera)));
    std::vector<TriangleSide> sides(mesh.triangle_count());
    std::vector<OutlineEdge> edges(400);
    CurveMemory<100> curve_memory;
    const Scene scene{camera, kLights, {&object, 1}};
    REQUIRE(ok(prepare_scene(scene, memory)));
    SceneOutlines<Rgb888> straight{outlined, sides, OutlineList(edges), {}};
    REQUIRE(ok(find_outlines(memory, straight)));
    constexpr double kRadius = 32000.0 / 32768 * Canvas::kHeight / 2;
    straight_sum += deviation_from_circle(straight.edges, kRadius);
    SceneOutlines<Rgb888, CurvedOutlines> curved{
        outlined, sides, OutlineList(edges), {}, CurvedOutlines(curve_memory)};
    REQUIRE(ok(find_outlines(memory, curved)));
    curved_sum += deviation_from_circle(curved.edges, kRadius);
  }
  CHECK(curved_sum < 0.6 * straight_sum);
}

TEST_CASE("a scene with too little memory for curves is drawn, and the other edges stay straight") {
  const Meshes meshes;
  static SceneMemory<SceneMethods, 2, 200> memory;
  const Object both[2] = {{meshes.ball_mesh, kCopper, WorldPoint::of(-0.8, 0, 0)},
                          {meshes.lump_mesh, kRed, WorldPoint::of(0.9, 0.3, -1)}};
  const Camera camera = Camera::of({WorldPoint::of(0, 0, 4), {}}, kLens, kScreen);
  CurvedRoom room(meshes);
  const auto drawn = [&](auto& outlines, Status expected) {
    Canvas canvas;
    CHECK(
        draw_scene({camera, kLights, both}, canvas.picture, canvas.depth, memory, Rgb8{}, outlines).status ==
        expected);
    return canvas.pixels;
  };
  const auto curved = drawn(room.outlines, Status::kOk);
  const std::size_t curves = room.outlines.curves.count();
  const std::size_t edges = room.outlines.edges.edges().size();
  REQUIRE(curves > 6);
  const auto straight = drawn(room.Room::outlines, Status::kOk);
  CHECK(curved != straight);
  CHECK(edges == room.Room::outlines.edges.edges().size() + curves);

  CurveMemory<3> few;
  room.outlines.curves = CurvedOutlines(few);
  CHECK(drawn(room.outlines, Status::kBufferTooSmall) != straight);
  CHECK(room.outlines.curves.count() == 3);
  CHECK(room.outlines.edges.edges().size() == edges - curves + 3);
  room.outlines.curves = CurvedOutlines({}, {}, {});
  CHECK(drawn(room.outlines, Status::kBufferTooSmall) == straight);

  // Curves of another frame are drawn with any object, but only those that exist.
  room.outlines.curves = CurvedOutlines(few);
  REQUIRE(find_outlines(memory, room.outlines) == Status::kBufferTooSmall);
  REQUIRE(ok(prepare_scene({camera, kLights, both}, memory)));
  Canvas canvas;
  CHECK(ok(draw_prepared_scene(memory, canvas.picture, canvas.depth, room.outlines.curves).status));
}

}  // namespace
