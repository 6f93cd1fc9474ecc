// SPDX-License-Identifier: MIT
// Seen from inside, a closed mesh covers every pixel exactly once, wherever its triangles are cut.
#include <arcspan/draw.hpp>
#include <arcspan/shading/arc/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/test_share.hpp>

#include <cstdio>
#include <cstdlib>

using namespace arcspan;
using namespace arcspan::test;
using Blinn1 = Illumination<1, Highlight::kBlinn>;

namespace {

struct Tally {
  std::uint64_t pictures = 0;
  std::uint64_t pixels = 0;
  std::uint64_t twice = 0;
  std::uint64_t missing = 0;
  std::uint64_t other = 0;
};

template <class Method>
void add_picture(Tally& tally, const TestMesh& mesh, const TestCamera& camera, StrictSink& sink) {
  const typename Method::Lighting lighting = make_light<1, Highlight::kBlinn>(camera);
  sink.clear();
  const DrawResult result = draw_mesh<Method>(mesh.view(), camera.transform(), lighting, sink, NoDepth{});
  const SinkFaults f = sink.faults();
  ++tally.pictures;
  tally.pixels += sink.drawn();
  tally.twice += f.twice;
  tally.missing += sink.missing();
  tally.other += f.outside + f.unpaired + f.empty_run + (ok(result.status) ? 0u : 1u);
}

TestCamera random_camera(Random& random, double reach) {
  TestCamera camera;
  camera.look_in_random_direction(random);
  camera.focal = random.decades(30, 2000);
  camera.near_plane = 4;
  camera.translation = random.unit() * reach * random_unit(random);
  return camera;
}

std::string report(const Tally& t) {
  return std::to_string(t.pictures) + " pictures, " + std::to_string(t.pixels) + " pixels, " +
         std::to_string(t.twice) + " twice, " + std::to_string(t.missing) + " missing";
}

}  // namespace

TEMPLATE_TEST_CASE("from inside a sphere every pixel is covered once", "", Silhouette, Arc<Blinn1>) {
  Random random(11);
  Tally tally;
  for (int i = 0; i < share_of(600); ++i) {
    const int rings = random.integer(3, 24);
    const double radius = random.decades(300, 30000);
    // A rough sphere is seen from its middle only: from elsewhere it really covers itself.
    const bool rough = random.chance(0.5);
    const TestMesh mesh =
        make_sphere(rings, random.integer(4, 2 * rings), radius, rough ? 0.3 : 0, random).inside_out();
    const TestCamera camera = random_camera(random, rough ? 0 : radius * 0.2);
    StrictSink sink({0, 0, camera.width, camera.height});
    add_picture<TestType>(tally, mesh, camera, sink);
  }
  INFO(report(tally));
  CHECK(tally.other == 0);
  CHECK(tally.twice == 0);
  CHECK(tally.missing == 0);
}

TEMPLATE_TEST_CASE("from inside a cube or a tetrahedron every pixel is covered once", "", Silhouette,
                   Arc<Blinn1>) {
  Random random(12);
  Tally tally;
  for (int i = 0; i < share_of(1000); ++i) {
    const double half = random.decades(300, 30000);
    const TestMesh mesh =
        (random.chance(0.5) ? make_smooth_cube(half) : make_smooth_tetrahedron(half)).inside_out();
    const TestCamera camera = random_camera(random, half * 0.3);
    StrictSink sink({0, 0, camera.width, camera.height});
    add_picture<TestType>(tally, mesh, camera, sink);
  }
  INFO(report(tally));
  CHECK(tally.other == 0);
  CHECK(tally.twice == 0);
  CHECK(tally.missing == 0);
}
