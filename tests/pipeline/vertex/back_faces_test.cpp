// SPDX-License-Identifier: MIT
// What planes tell to be a back is one on the raster too.
#include <arcspan/mesh/make_face_planes.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/vertex/back_faces.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <catch2/catch.hpp>
#include <tests/frames/stage_set.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/misuse_recorder.hpp>
#include <tests/support/test_share.hpp>

#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// A mesh with its planes.
struct PlanedMesh {
  TestMesh mesh;
  std::vector<FacePlane> planes;
  PlaneScale scale;

  explicit PlanedMesh(TestMesh made) : mesh(std::move(made)), planes(mesh.indices.size() / 3) {
    REQUIRE(ok(make_face_planes(mesh.view(), planes, scale)));
  }
  [[nodiscard]] MeshView view() const {
    MeshView view = mesh.view();
    REQUIRE(ok(view.attach(planes, scale)));
    return view;
  }
};

struct Tally {
  int known = 0;   ///< meshes of which something could be culled
  int culled = 0;  ///< culled triangles
  int backs = 0;   ///< that are backs on the raster
  int turned = 0;  ///< culled, although they show their front
  int outside = 0;
};

bool is_culled(const BackFaces& backs, std::size_t i) { return backs.next_front(i, i + 1) != i; }

void tally_view(const MeshView& mesh, const ClipTransform& transform, Tally& tally) {
  const BackFaces backs(mesh, transform);
  if (!backs.known()) return;
  ++tally.known;
  std::vector<RasterPosition> raster;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const ClipPosition clip = transform(mesh.position(i));
    tally.outside += outcode(clip, transform.w_range()) != kInside;
    raster.push_back(project(clip, transform));
  }
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleIndices t = mesh.triangle(i);
    const bool back = doubled_area(raster[t.a], raster[t.b], raster[t.c]) > 0;
    const bool culled = is_culled(backs, i);
    tally.culled += culled;
    tally.backs += back;
    tally.turned += culled && !back;
  }
}

/// Triangles of one size, all over a ball.
TestMesh scattered(Random& random, double size) {
  TestMesh mesh;
  const double radius = random.decades(2 * size, 30000);
  for (std::uint16_t i = 0; i < 200; ++i) {
    const Vec3 middle = random.real(0, radius) * random_unit(random);
    for (int corner = 0; corner < 3; ++corner) {
      (void)mesh.add(middle + random.real(0.1, 1) * size * random_unit(random), {0, 0, 1});
    }
    const auto first = static_cast<std::uint16_t>(3 * i);
    mesh.triangle(first, static_cast<std::uint16_t>(first + 1), static_cast<std::uint16_t>(first + 2));
  }
  return mesh;
}

/// A camera that has a mesh of this reach in view, more or less, an object unit being `scale` pixels.
TestCamera camera_before(Random& random, double reach, double scale) {
  TestCamera camera;
  camera.look_in_random_direction(random);
  camera.width = random.integer(1, 2048);
  camera.height = random.integer(1, 2048);
  const double away = reach * (random.chance(0.4) ? random.real(1.02, 1.5) : random.decades(1.5, 40));
  camera.focal = std::clamp(std::round(away * scale), 1.0, 1e6);
  const double aside = std::min(4e6, random.real(0, 0.8) * away * 1024 / camera.focal);
  const double turn = random.real(0, 6.28);
  camera.translation = {std::round(aside * std::cos(turn)), std::round(aside * std::sin(turn)),
                        std::round(-away)};
  camera.near_plane = std::max(1.0, std::round(random.real(0, 0.3) * away));
  camera.far_plane = camera.near_plane + 200000;
  return camera;
}

}  // namespace

TEST_CASE("no triangle culled by its plane shows its front on the raster") {
  Random random(111);
  Tally tally;
  for (int round = 0; round < share_of(8000); ++round) {
    const double size = random.decades(3, 10000);
    const PlanedMesh mesh(scattered(random, size));
    const double pixels = random.decades(0.003, 100);
    tally_view(mesh.view(), camera_before(random, mesh.scale.radius, pixels / size).transform(), tally);
  }
  // Nearly around the eye: the far side of the ball is seen much smaller than the near one.
  for (int round = 0; round < share_of(3000); ++round) {
    const PlanedMesh mesh(scattered(random, random.decades(1000, 6000)));
    const double reach = mesh.scale.radius;
    TestCamera camera = camera_before(random, reach, 1);
    camera.translation = {0, 0, std::round(-reach * random.real(1.03, 1.3))};
    camera.focal = std::round(1000 * (-camera.translation.z - reach) / reach);
    camera.near_plane = 1;
    tally_view(mesh.view(), camera.transform(), tally);
  }
  // Of the size where snapping decides: far off, below a pixel.
  for (int round = 0; round < share_of(6000); ++round) {
    const double size = random.real(1000, 5000);
    const PlanedMesh mesh(scattered(random, size));
    TestCamera camera = camera_before(random, mesh.scale.radius, 1);
    camera.translation = {0, 0, std::round(-20.0 * mesh.scale.radius)};
    camera.near_plane = 16;
    camera.far_plane = 4e6;
    camera.focal = std::round(random.decades(0.1, 1) / size * -camera.translation.z);
    if (camera.focal >= 1) tally_view(mesh.view(), camera.transform(), tally);
  }
  CAPTURE(tally.known, tally.culled, tally.backs);
  CHECK(tally.turned == 0);
  CHECK(tally.outside == 0);
  CHECK(tally.known > share_of(1000));
  CHECK(tally.culled > tally.backs / 8);
}

TEST_CASE("planes cull nearly all back faces of a sphere") {
  static constexpr auto kSphere = scenes::make_sphere<32, 16>();
  static constexpr auto kPlanes = scenes::planes_of(kSphere);
  MeshView mesh;
  REQUIRE(ok(kSphere.view(mesh)));
  REQUIRE(ok(kPlanes.attach_to(mesh)));
  for (std::uint16_t turn = 0; turn < 64; ++turn) {
    scenes::StageSet stage;
    REQUIRE(ok(scenes::set_stage({320, 240}, 72, Turn{static_cast<std::uint16_t>(turn * 1024)}, stage)));
    Tally tally;
    tally_view(mesh, stage.transform, tally);
    CHECK(tally.turned == 0);
    CHECK(tally.culled >= tally.backs * 93 / 100);
  }
}

TEST_CASE("nothing is culled without planes, nor where a plane or the guard band may clip") {
  Random random(112);
  const PlanedMesh mesh(make_sphere(8, 16, 3000, 0, random));
  TestCamera camera;
  camera.translation = {0, 0, -9000};
  CHECK(BackFaces(mesh.view(), camera.transform()).known());
  CHECK_FALSE(BackFaces(mesh.mesh.view(), camera.transform()).known());
  CHECK_FALSE(BackFaces{}.known());

  camera.near_plane = 6100;
  CHECK_FALSE(BackFaces(mesh.view(), camera.transform()).known());
  camera.near_plane = 16;
  camera.far_plane = 11900;
  CHECK_FALSE(BackFaces(mesh.view(), camera.transform()).known());
  camera.far_plane = 200000;
  camera.translation.z = -2000;  // around the eye
  CHECK_FALSE(BackFaces(mesh.view(), camera.transform()).known());
  camera.translation.z = 9000;  // behind it
  CHECK_FALSE(BackFaces(mesh.view(), camera.transform()).known());
  for (double Vec3::*side : {&Vec3::x, &Vec3::y}) {
    camera.translation = {0, 0, -9000};
    camera.translation.*side = 28000;  // 28000 + 3000 is beyond 1024 pixels at a distance of 6000
    CHECK_FALSE(BackFaces(mesh.view(), camera.transform()).known());
    camera.translation.*side = -27000;
    CHECK(BackFaces(mesh.view(), camera.transform()).known());
  }
}

TEST_CASE("a far plane right behind the vertices does not keep planes from being used") {
  Random random(115);
  constexpr Vec3 kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr std::int16_t ObjectPosition::*kCoordinates[] = {&ObjectPosition::x, &ObjectPosition::y,
                                                            &ObjectPosition::z};
  const int axis = GENERATE(0, 1, 2);  // points to the camera
  CAPTURE(axis);
  TestMesh made = make_sphere(8, 16, 1000, 0, random);
  for (ObjectPosition& p : made.positions) {
    std::int16_t& towards = p.*kCoordinates[axis];
    towards = static_cast<std::int16_t>(towards + 2000);
  }
  const PlanedMesh mesh(std::move(made));
  TestCamera camera{kAxes[(axis + 1) % 3], kAxes[(axis + 2) % 3], kAxes[axis]};
  camera.translation = {0, 0, -9000};
  for (const auto& [far_plane, known] :
       {std::pair{12100.0, true}, {8060.0, true}, {7950.0, false}, {7000.0, false}}) {
    camera.far_plane = far_plane;
    CAPTURE(far_plane);
    CHECK(BackFaces(mesh.view(), camera.transform()).known() == known);
    Tally tally;
    tally_view(mesh.view(), camera.transform(), tally);
    CHECK(tally.outside == 0);
  }
}

TEST_CASE("nothing is culled if the transform is no rotation") {
  MisuseRecorder ignored;
  Random random(114);
  const PlanedMesh mesh(make_sphere(8, 16, 3000, 0, random));
  for (int row = 0; row < 3; ++row) {
    for (const double factor : {0.5, 0.999, 1.0, 1.001, 1.9}) {
      Placement placement{Rotation::identity(), {{}, {}, ObjectLength::of(-9000)}};
      RotationEntry& entry = placement.rotation.m[row][row];
      entry = RotationEntry::from_raw(static_cast<std::int32_t>(entry.raw() * factor));
      ClipTransform transform;
      REQUIRE(ok(ClipTransform::make(placement,
                                     {PixelLength::of(200), ObjectLength::of(16), ObjectLength::of(20000)},
                                     {160, 120}, transform)));
      CAPTURE(row, factor);
      CHECK(BackFaces(mesh.view(), transform).known() == (factor <= 1));
    }
  }
}

TEST_CASE("any planes and any camera are defined") {
  Random random(113);
  std::vector<FacePlane> planes(300);
  const TestMesh mesh = scattered(random, 3000);
  MeshView view = mesh.view();
  planes.resize(view.triangle_count());
  const std::int32_t farthest = PlanedMesh(mesh).scale.radius;
  int known = 0;
  for (int round = 0; round < share_of(20000); ++round) {
    const auto byte = [&] {
      return static_cast<std::int8_t>(random.chance(0.3) ? -128 : random.integer(-128, 127));
    };
    for (FacePlane& plane : planes) plane = {byte(), byte(), byte(), byte()};
    const PlaneScale scale{static_cast<std::int8_t>(random.integer(-12, 8)),
                           static_cast<std::uint8_t>(random.integer(0, 17)),
                           static_cast<std::uint16_t>(random.integer(farthest, 65535))};
    REQUIRE(ok(view.attach(planes, scale)));
    TestCamera camera = camera_before(random, 1 + scale.radius, random.decades(1e-6, 1e3));
    if (random.chance(0.9)) camera.far_plane = 8e6;
    const BackFaces backs(view, camera.transform());
    if (!backs.known()) continue;
    ++known;
    CHECK(backs.next_front(0, planes.size()) <= planes.size());
  }
  CHECK(known > share_of(1000));
}
