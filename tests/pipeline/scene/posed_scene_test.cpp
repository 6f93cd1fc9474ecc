// SPDX-License-Identifier: MIT
// Objects whose vertices a mesh poses, against objects whose vertices lie where they are posed.
#include <arcspan/drawn_rect.hpp>
#include <arcspan/pick.hpp>
#include <arcspan/scene_outlines.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/random_scene.hpp>
#include <tests/support/neighbours.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// The triangles of a mesh, with the vertices of another one.
struct Disguise {
  const MeshView& triangles;
  const MeshView& vertices;

  [[nodiscard]] const MeshView& view() const { return triangles; }
  [[nodiscard]] ObjectPosition position(std::size_t i) const { return vertices.position(i); }
  [[nodiscard]] Direction direction(std::size_t i) const { return unpack_normal(vertices.normal(i)); }
};

using PosedMethods = MethodList<SceneMethod, Unlit, Posed<SceneMethod, Disguise>, Posed<Unlit, Disguise>>;

/// A ball, in the pose of a smaller and uneven one.
struct Poses {
  Random random{23};
  TestMesh ball = make_sphere(6, 8, 32000, 0, random);
  TestMesh lump = make_sphere(6, 8, 15000, 0.4, random);
  MeshView rest = ball.view();
  MeshView posed = lump.view();
  Disguise disguise{rest, posed};
  TestNeighbours rest_neighbours{rest};
  TestNeighbours posed_neighbours{posed};
  OutlinedMesh outlined[2] = {{&rest, &rest_neighbours.view}, {&posed, &posed_neighbours.view}};

  PreparedMaterial<SceneMethod> copper = kCopper;
  PreparedMaterial<Unlit> two_sided{Unlit::lighting({200, 30, 20}), {true}};
  PosedMaterial<Disguise> posed_copper{copper, disguise};
  PosedMaterial<Disguise> posed_red{two_sided, disguise};
  Part same[2] = {{&copper, 0, 30}, {&kJade, 30, 40}};
  PosedMaterial<Disguise> posed_jade{kJade, disguise};
  Part posed_same[2] = {{&posed_copper, 0, 30}, {&posed_jade, 30, 40}};
};

/// A random scene twice: as it is posed, and with meshes that lie like that.
struct Twins {
  RandomObjects posed;
  RandomObjects still;

  Twins(Random& random, const Poses& poses) {
    posed.camera = still.camera = random_camera(random);
    posed.objects = {{poses.rest, poses.posed_copper},
                     {poses.rest, poses.copper},
                     {poses.rest, poses.posed_red},
                     {poses.rest, std::span(poses.posed_same)}};
    still.objects = {{poses.posed, poses.copper},
                     {poses.rest, poses.copper},
                     {poses.posed, poses.two_sided},
                     {poses.posed, std::span(poses.same)}};
    for (std::size_t i = 0; i < still.objects.size(); ++i) {
      place_at_random(random, posed.objects[i], 2.5);
      posed.objects[i].set_sphere(still.objects[i].sphere());
      still.objects[i].position = posed.objects[i].position;
      still.objects[i].rotation = posed.objects[i].rotation;
      still.objects[i].scale = posed.objects[i].scale;
    }
  }
};

/// A picture in bands of so many rows, with smooth and curved outlines.
template <class Memory>
std::vector<Picture::Word> outlined_in_bands(const Scene& scene, Memory& memory, const Poses& poses,
                                             std::int32_t rows, std::size_t& curves) {
  std::vector<TriangleSide> sides(200);
  std::vector<OutlineEdge> edges(2000);
  std::vector<OutlineGap<Rgb888>> gaps(5000);
  const auto curve_memory = std::make_unique<CurveMemory<500>>();
  SceneOutlines<Rgb888, CurvedOutlines> outlines{poses.outlined, sides, OutlineList(edges), gaps,
                                                 CurvedOutlines(*curve_memory)};
  REQUIRE(ok(prepare_scene(scene, memory)));
  REQUIRE(ok(find_outlines(memory, outlines)));
  curves += outlines.curves.count();
  std::vector<Picture::Word> all;
  Canvas band(rows);
  for (std::int32_t row = 0; row < Canvas::kHeight; row += rows) {
    band.move_to(row);
    REQUIRE(ok(draw_prepared_scene(memory, band.picture, band.depth, outlines.curves).status));
    REQUIRE(ok(smooth_outlines(outlines.edges, band.picture, band.depth, outlines.gaps)));
    all.insert(all.end(), band.pixels.begin(), band.pixels.end());
  }
  return all;
}

/// A picture on black with smooth outlines, which are found after a first band, or `at_once` with drawing.
template <class Memory>
std::vector<Picture::Word> smoothed(const Scene& scene, Memory& memory, const Poses& poses, bool at_once) {
  std::vector<TriangleSide> sides(200);
  std::vector<OutlineEdge> edges(2000);
  std::vector<OutlineGap<Rgb888>> gaps(5000);
  SceneOutlines<Rgb888> outlines{poses.outlined, sides, OutlineList(edges), gaps};
  Canvas canvas;
  if (at_once) {
    REQUIRE(ok(draw_scene(scene, canvas.picture, canvas.depth, memory, Rgb8{}, outlines).status));
    return canvas.pixels;
  }
  REQUIRE(ok(prepare_scene(scene, memory)));
  Canvas band(Canvas::kHeight / 2);  // which finds the rows of triangles
  REQUIRE(ok(draw_prepared_scene(memory, band.picture, band.depth, Rgb8{}).status));
  REQUIRE(ok(find_outlines(memory, outlines)));
  REQUIRE(ok(draw_prepared_scene(memory, canvas.picture, canvas.depth, Rgb8{}).status));
  REQUIRE(ok(smooth_outlines(outlines.edges, canvas.picture, canvas.depth, outlines.gaps)));
  return canvas.pixels;
}

/// A picture on black in bands of so many rows.
template <class Memory>
std::vector<Picture::Word> in_bands(const Scene& scene, Memory& memory, std::int32_t rows) {
  REQUIRE(ok(prepare_scene(scene, memory)));
  std::vector<Picture::Word> all;
  Canvas band(rows);
  for (std::int32_t row = 0; row < Canvas::kHeight; row += rows) {
    band.move_to(row);
    REQUIRE(ok(draw_prepared_scene(memory, band.picture, band.depth, Rgb8{}).status));
    all.insert(all.end(), band.pixels.begin(), band.pixels.end());
  }
  all.resize(Picture::words(Canvas::kWidth, Canvas::kHeight));
  return all;
}

SceneMemory<PosedMethods, 4, 400> own_vertices;
SceneMemory<PosedMethods, 4, 100, 200> shared_vertices;  // and the rows of some objects
SceneMemory<PosedMethods, 4, 0, 1000> no_vertices;

}  // namespace

TEST_CASE("objects are drawn where a mesh poses their vertices, in every order and in bands") {
  const Poses poses;
  Random random(5);
  int drawn = 0;
  std::size_t curves = 0;
  for (int repeat = 0; repeat < share_of(150); ++repeat) {
    const Twins twins(random, poses);
    Canvas expected;
    REQUIRE(
        ok(draw_scene(twins.still.scene(), expected.picture, expected.depth, own_vertices, Rgb8{}).status));
    Canvas found;
    REQUIRE(ok(draw_scene(twins.posed.scene(), found.picture, found.depth, own_vertices, Rgb8{}).status));
    CHECK(found.pixels == expected.pixels);
    CHECK(found.depths == expected.depths);
    Canvas uncached;
    REQUIRE(
        ok(draw_scene(twins.posed.scene(), uncached.picture, uncached.depth, no_vertices, Rgb8{}).status));
    CHECK(uncached.pixels == expected.pixels);
    CHECK(in_bands(twins.posed.scene(), no_vertices, 10) == expected.pixels);
    REQUIRE(ok(draw_scene(twins.still.scene(), expected.picture, NoDepth{}, own_vertices, Rgb8{}).status));
    REQUIRE(ok(draw_scene(twins.posed.scene(), found.picture, NoDepth{}, shared_vertices, Rgb8{}).status));
    CHECK(found.pixels == expected.pixels);
    drawn +=
        std::count(found.pixels.begin(), found.pixels.end(), Rgb8{}) < Canvas::kWidth * Canvas::kHeight - 99;
    const auto smooth = smoothed(twins.still.scene(), own_vertices, poses, false);
    CHECK(smoothed(twins.posed.scene(), own_vertices, poses, true) == smooth);
    CHECK(smoothed(twins.posed.scene(), shared_vertices, poses, true) == smooth);
    CHECK(smoothed(twins.posed.scene(), shared_vertices, poses, false) == smooth);
    std::size_t still_curves = 0;
    const auto outlined = outlined_in_bands(twins.still.scene(), own_vertices, poses, 24, still_curves);
    CHECK(outlined_in_bands(twins.posed.scene(), own_vertices, poses, 24, curves) == outlined);
    CHECK(outlined_in_bands(twins.posed.scene(), shared_vertices, poses, 24, still_curves) == outlined);
  }
  CHECK(curves > static_cast<std::size_t>(share_of(150)));
  CHECK(drawn > share_of(150) / 2);
}

TEST_CASE("the rectangle and the picked triangle of a posed object are those of its pose") {
  const Poses poses;
  Random random(6);
  int picked = 0;
  const int scenes =
      std::max(share_of(150), 10);  // in fewer, chance alone decides how many pixels show an object
  for (int repeat = 0; repeat < scenes; ++repeat) {
    const Twins twins(random, poses);
    REQUIRE(ok(prepare_scene(twins.still.scene(), own_vertices)));
    REQUIRE(ok(prepare_scene(twins.posed.scene(), shared_vertices)));
    REQUIRE(ok(prepare_scene(twins.posed.scene(), no_vertices)));
    const Rect rect = drawn_rect(own_vertices);
    CHECK(drawn_rect(shared_vertices) == rect);
    CHECK(drawn_rect(no_vertices) == rect);
    for (int i = 0; i < 20; ++i) {
      const auto x =
          static_cast<std::int32_t>(random.integer(rect.left, std::max(rect.left, rect.right - 1)));
      const auto y = static_cast<std::int32_t>(random.integer(rect.top, std::max(rect.top, rect.bottom - 1)));
      const Picked expected = pick(own_vertices, x, y);
      const Picked found = pick(shared_vertices, x, y);
      REQUIRE((found.object == nullptr) == (expected.object == nullptr));
      CHECK(found.depth == expected.depth);
      if (found.object == nullptr) continue;
      ++picked;
      CHECK(found.object - twins.posed.objects.data() == expected.object - twins.still.objects.data());
      CHECK(found.part == expected.part);
      CHECK(found.triangle == expected.triangle);
    }
  }
  CHECK(picked > scenes);
  CHECK(pick(shared_vertices, -1, 0).object == nullptr);
}

TEST_CASE("the rectangle of a posed object that clip planes cut is that of its pose") {
  const Poses poses;
  Random random(7);
  int cut = 0;
  for (int repeat = 0; repeat < 40; ++repeat) {
    Twins twins(random, poses);
    for (RandomObjects* made : {&twins.posed, &twins.still})
      made->objects.erase(made->objects.begin() + 1, made->objects.end());
    place_beside_eye(random, twins.posed.objects[0], twins.posed.camera, 0.7);
    twins.still.objects[0].position = twins.posed.objects[0].position;
    twins.still.objects[0].rotation = twins.posed.objects[0].rotation;
    twins.still.objects[0].scale = twins.posed.objects[0].scale;
    REQUIRE(ok(prepare_scene(twins.still.scene(), own_vertices)));
    REQUIRE(ok(prepare_scene(twins.posed.scene(), shared_vertices)));
    const Rect rect = drawn_rect(own_vertices);
    CHECK(drawn_rect(shared_vertices) == rect);
    cut += rect.empty() ? 0 : 1;
  }
  CHECK(cut > 3);
}

TEST_CASE("a pose that does not fit its object is refused, and outlines without its vertices") {
  const Poses poses;
  const Camera camera = Camera::of({WorldPoint::of(0, 0, 4), {}}, kLens, kScreen);
  const TestMesh cube = make_smooth_cube(18000);
  const MeshView other = cube.view();
  std::vector<TriangleSide> sides(200);
  std::vector<OutlineEdge> edges(2000);
  SceneOutlines<Rgb888> outlines{poses.outlined, sides, OutlineList(edges), {}};
  Canvas canvas;

  const Object wrong[] = {{other, poses.posed_copper}};
  const Scene scene{camera, kLights, wrong};
  REQUIRE(ok(prepare_scene(scene, own_vertices)));
  CHECK(draw_prepared_scene(own_vertices, canvas.picture, canvas.depth).status == Status::kInvalidArgument);
  CHECK(drawn_rect(own_vertices) == Rect{});
  CHECK(pick(own_vertices, Canvas::kWidth / 2, Canvas::kHeight / 2).status == Status::kInvalidArgument);
  const TestNeighbours neighbours(other);
  const OutlinedMesh outlined[] = {{&other, &neighbours.view}};
  outlines.meshes = outlined;
  CHECK(find_outlines(own_vertices, outlines) == Status::kInvalidArgument);

  const Part mixed[] = {{&poses.posed_copper, 0, 30}, {&poses.posed_red, 30, 20}};
  const Part half_posed[] = {{&poses.posed_copper, 0, 30}, {&poses.copper, 30, 20}};
  outlines.meshes = poses.outlined;
  for (const std::span<const Part> parts : {std::span(mixed), std::span(half_posed)}) {
    const Object objects[] = {{poses.rest, parts}};
    const Scene two_methods{camera, kLights, objects};
    REQUIRE(ok(prepare_scene(two_methods, own_vertices)));
    CHECK(find_outlines(own_vertices, outlines) == Status::kUnsupported);
    CHECK(draw_scene(two_methods, canvas.picture, canvas.depth, own_vertices, Rgb8{}, outlines).status ==
          Status::kUnsupported);
  }
  const Object whole[] = {{poses.rest, poses.posed_copper}};
  REQUIRE(ok(prepare_scene({camera, kLights, whole}, no_vertices)));
  CHECK(find_outlines(no_vertices, outlines) == Status::kUnsupported);
  const Object still[] = {{poses.rest, poses.copper}};
  REQUIRE(ok(prepare_scene({camera, kLights, still}, no_vertices)));
  CHECK(find_outlines(no_vertices, outlines) == Status::kOk);

  static SceneMemory<SceneMethods, 4, 400> of_still_objects;
  CHECK(prepare_scene({camera, kLights, whole}, of_still_objects) == Status::kMethodNotListed);
}

TEST_CASE("a posed object is drawn by the options that its material was last made with") {
  Poses poses;
  Random random(8);
  // Open, so that backs show.
  const MeshView half = poses.rest.part(0, 40);
  const MeshView posed_half = poses.posed.part(0, 40);
  const Disguise disguise{half, posed_half};
  const PosedMaterial<Disguise> before(poses.copper, disguise);
  REQUIRE(
      ok(PreparedMaterial<SceneMethod>::make(matter(kFull, kFull, kFull), kLights, {true}, poses.copper)));
  const PosedMaterial<Disguise> after(poses.copper, disguise);
  const TestNeighbours neighbours(half);
  const OutlinedMesh outlined[] = {{&half, &neighbours.view}};
  std::vector<TriangleSide> sides(200);
  std::vector<OutlineEdge> edges(2000);
  SceneOutlines<Rgb888> outlines{outlined, sides, OutlineList(edges), {}};
  const auto drawn = [&](const PosedMaterial<Disguise>& material, const Camera& camera, Canvas& canvas,
                         Picked& picked) {
    const Object objects[] = {{half, material}};
    const Scene scene{camera, kLights, objects};
    REQUIRE(ok(draw_scene(scene, canvas.picture, canvas.depth, own_vertices, Rgb8{}).status));
    REQUIRE(ok(find_outlines(own_vertices, outlines)));
    picked = pick(own_vertices, Canvas::kWidth / 2, Canvas::kHeight / 2);
    return drawn_rect(own_vertices);
  };
  for (int repeat = 0; repeat < 20; ++repeat) {
    const Camera camera = random_camera(random);
    Canvas expected, found;
    Picked expected_pick, found_pick;
    const Rect expected_rect = drawn(after, camera, expected, expected_pick);
    const std::size_t expected_edges = outlines.edges.edges().size();
    CHECK(drawn(before, camera, found, found_pick) == expected_rect);
    CHECK(found.pixels == expected.pixels);
    CHECK(outlines.edges.edges().size() == expected_edges);
    CHECK(found_pick.depth == expected_pick.depth);
  }
}
