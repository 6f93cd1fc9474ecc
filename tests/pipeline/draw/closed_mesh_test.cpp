// SPDX-License-Identifier: MIT
// Seen from inside, a closed mesh covers every pixel exactly once, wherever its triangles are cut.
#include <arcspan/draw.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/run_list.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

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

namespace {

/// A closed surface with random corners and normals. It may cut itself anywhere; each edge belongs to two
/// triangles in opposite directions.
TestMesh random_closed_mesh(Random& random) {
  TestMesh mesh;
  const double reach = random.decades(20, 1500);  // below a pixel to the whole picture
  const double thin = random.chance(0.3) ? 0.05 : 1;
  const bool tetrahedron = random.chance(0.5);
  for (int i = 0; i < (tetrahedron ? 4 : 6); ++i) {
    const auto coordinate = [&] { return random.real(-reach, reach); };
    mesh.add({coordinate(), thin * coordinate(), coordinate()}, random_unit(random));
  }
  if (tetrahedron) {
    mesh.indices = {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
  } else {
    mesh.indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  }
  return mesh;
}

constexpr std::int32_t kSmall = 40;
using Balance = std::array<int, static_cast<std::size_t>(kSmall) * kSmall>;

/// Adds `side` to each pixel for each front face of the mesh that covers it. Returns the number of these
/// pixels.
template <class Method>
std::uint64_t add_fronts(const TestMesh& mesh, const TestCamera& camera,
                         const typename Method::Lighting& lighting, int side, RunList& runs,
                         Balance& balance) {
  runs.runs.clear();
  std::uint64_t covered = 0;
  if (!ok(draw_mesh<Method>(mesh.view(), camera.transform(), lighting, runs, NoDepth{}).status))
    balance[0] += 1000;
  for (const Span& run : runs.runs) {
    covered += static_cast<std::uint64_t>(run.count);
    for (std::int32_t x = run.x; x < run.x + run.count; ++x) {
      balance[static_cast<std::size_t>(run.y * kSmall + x)] += side;
    }
  }
  return covered;
}

}  // namespace

TEMPLATE_TEST_CASE("front faces of a closed mesh cover each pixel as often as its back faces", "", Silhouette,
                   Arc<Blinn1>) {
  Random random(13);
  RunList runs({0, 0, kSmall, kSmall});
  TestCamera camera;
  camera.width = kSmall;
  camera.height = kSmall;
  camera.focal = 60;
  camera.translation = {0, 0, -4500};
  const typename TestType::Lighting lighting = make_light<1, Highlight::kBlinn>(camera);
  int faults = 0;
  std::uint64_t covered = 0;
  for (int i = 0; i < share_of(100000); ++i) {
    const TestMesh mesh = random_closed_mesh(random);
    Balance balance{};
    covered += add_fronts<TestType>(mesh, camera, lighting, 1, runs, balance);
    covered += add_fronts<TestType>(mesh.inside_out(), camera, lighting, -1, runs, balance);
    faults += std::all_of(balance.begin(), balance.end(), [](int b) { return b == 0; }) ? 0 : 1;
  }
  CHECK(covered > static_cast<std::uint64_t>(share_of(100000)) * 50);
  CHECK(faults == 0);
}
