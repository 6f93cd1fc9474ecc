// SPDX-License-Identifier: MIT
#include <arcspan/mesh/make_face_planes.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/vertex/back_faces.hpp>
#include <arcspan/vertex/band_planes.hpp>
#include <arcspan/vertex/project.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// The rows of a triangle on the raster, relative to the raster origin.
struct Rows {
  std::int32_t first;
  std::int32_t end;
};

Rows rows_of(const MeshView& mesh, const ClipTransform& transform, std::size_t i) {
  const TriangleIndices t = mesh.triangle(i);
  std::int32_t top = INT32_MAX;
  std::int32_t bottom = INT32_MIN;
  for (const std::uint16_t v : {t.a, t.b, t.c}) {
    const std::int32_t y = project(transform(mesh.position(v)), transform).y;
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  }
  return {first_row_at(top), first_row_at(bottom)};
}

}  // namespace

TEST_CASE("band planes exclude no triangle with rows in the band, and nearly all others") {
  Random random(175);
  std::size_t elsewhere = 0;
  std::size_t excluded = 0;
  std::size_t empty_bands = 0;
  int tried = 0;
  for (int round = 0; tried < share_of(400); ++round) {
    TestCamera camera;
    camera.look_in_random_direction(random);
    camera.width = static_cast<std::int32_t>(random.real(1, 2048));
    camera.height = static_cast<std::int32_t>(random.real(20, 2048));
    camera.focal = std::round(random.decades(20, 3000));
    const double distance = random.decades(4000, 60000);
    camera.translation = {std::round(random.real(-1, 1) * distance),
                          std::round(random.real(-1, 1) * distance), -std::round(distance)};
    const TestMesh shape = make_sphere(10, 14, random.decades(10, 4000), 0.2, random);
    std::vector<FacePlane> planes(shape.indices.size() / 3);
    PlaneScale scale;
    REQUIRE(ok(make_face_planes(shape.view(), planes, scale)));
    MeshView mesh = shape.view();
    REQUIRE(ok(mesh.attach(planes, scale)));
    const ClipTransform transform = camera.transform();
    if (!BackFaces(mesh, transform).known()) continue;
    ++tried;
    const std::int32_t middle = camera.height >> 1;
    for (int i = 0; i < 20; ++i) {
      const auto first = static_cast<std::int32_t>(random.real(0, camera.height - 1));
      const auto end = first + 1 + static_cast<std::int32_t>(random.real(0, camera.height - first - 1));
      BandPlanes band;
      CHECK_FALSE(band.known());
      band.set(transform, first, end, scale.radius);
      CAPTURE(round, first, end, camera.height, camera.focal);
      REQUIRE(band.known());
      bool reached = false;
      for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const Rows rows = rows_of(mesh, transform, t);
        const bool reaches = rows.first + middle < end && rows.end + middle > first && rows.first < rows.end;
        reached |= reaches;
        if (reaches) CHECK_FALSE(band.excludes(mesh, t));
        const TriangleIndices corners = mesh.triangle(t);
        const auto beyond = [&](std::size_t v) { return band.beyond(mesh.position(v), 128); };
        CHECK((beyond(corners.a) & beyond(corners.b) & beyond(corners.c)) ==
              (band.excludes(mesh, t) ? beyond(corners.a) : 128));
        // A row more on both sides, as triangles near the border may be left to the raster.
        if (rows.first + middle > end || rows.end + middle < first) {
          ++elsewhere;
          excluded += band.excludes(mesh, t);
        }
      }
      if (reached) CHECK_FALSE(band.excludes_all());
      empty_bands += band.excludes_all();
    }
  }
  CHECK(excluded == elsewhere);
  CHECK(elsewhere > 0);
  CHECK(empty_bands > 0);
}
