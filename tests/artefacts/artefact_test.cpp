// SPDX-License-Identifier: MIT
// The artefacts that the papers describe, measured on the pipeline's pictures.
#include <arcspan_tools/compare/artefacts.hpp>
#include <arcspan_tools/compare/scan_line_polygon.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>

using namespace arcspan::tools;

namespace {

constexpr double kEdge = 100;
constexpr int kReach = 12;

}  // namespace

TEST_CASE("a highlight inside a triangle: Gouraud misses it, the arcs have it (S3, defect c)") {
  const ArtefactScene scene = ArtefactScene::highlight();
  const double reference = peak(scene.middle_row(ReferenceKind::kPhong));
  CHECK(reference > 240);  // 255 * (0.5 + 0.45)
  CHECK(peak(scene.middle_row("gouraud")) < 0.5 * 255);
  CHECK(std::fabs(peak(scene.middle_row("arc")) - reference) < 2);
}

TEST_CASE(
    "Mach bands: lit head-on, Gouraud's brightness has a kink at an edge, the arcs' has none (S3, defect "
    "d)") {
  const ArtefactScene scene = ArtefactScene::fold();
  const double reference = kink(scene.middle_row(ReferenceKind::kPhong), kEdge, kReach);
  const double gouraud = kink(scene.middle_row("gouraud"), kEdge, kReach);
  const double arc = kink(scene.middle_row("arc"), kEdge, kReach);
  // Linear from 255 to 255 cos 30 degrees over half the strip, 75 pixels or so, on either side.
  CHECK(gouraud < -0.8);
  CHECK(std::fabs(reference) < 0.25);  // what is left is the cosine's own second difference
  CHECK(std::fabs(arc - reference) < 0.1);
  // A smooth curve's second difference shrinks with the distance, a kink does not.
  CHECK(std::fabs(kink(scene.middle_row(ReferenceKind::kPhong), kEdge, 3)) < std::fabs(reference) / 2);
  CHECK(kink(scene.middle_row("gouraud"), kEdge, 4) < 0.8 * gouraud);
}

TEST_CASE(
    "Mach bands: lit from the side, Phong's method and the arcs have a larger kink than Gouraud's (S1)") {
  const ArtefactScene scene = ArtefactScene::narrow_fold();
  const double gouraud = kink(scene.middle_row("gouraud"), kEdge, kReach);
  CHECK(gouraud > 1.4);
  CHECK(gouraud < 1.8);
  for (const char* shading : {"phong", "arc"}) {
    CAPTURE(shading);
    CHECK(kink(scene.middle_row(shading), kEdge, kReach) > 1.3 * gouraud);
  }
  // It is not the pipeline's: the references have it, and nearer to the edge it does not shrink.
  for (const ReferenceKind kind : {ReferenceKind::kPhong, ReferenceKind::kSlerp}) {
    const double reference = kink(scene.middle_row(kind), kEdge, kReach);
    CHECK(reference > 1.4 * gouraud);
    CHECK(kink(scene.middle_row(kind), kEdge, 3) > reference);
  }
}

TEST_CASE("a highlight flickers on a turning sphere by Gouraud's method, not by the arcs (S3, defect e)") {
  CHECK(flicker(ReferenceKind::kPhong) <= 1);
  CHECK(flicker("gouraud") > 60);
  CHECK(flicker("flat") > 20);
  CHECK(flicker("arc") <= 1);
}

TEST_CASE("a round highlight becomes a star by Gouraud's method, not by the arcs (S3, defect f)") {
  const ArtefactScene scene = ArtefactScene::star();
  CHECK(highlight_elongation(scene.picture(ReferenceKind::kPhong)) < 1.2);  // rounding to pixels
  CHECK(highlight_elongation(scene.picture("gouraud")) > 2);
  CHECK(highlight_elongation(scene.picture("arc")) < 1.2);
}

TEST_CASE("a non-convex polygon jumps at its reflex corner if it is shaded as a whole (S1, figure 26.3)") {
  // The corner P is in row 68; column 95 is beside it.
  constexpr std::int32_t kColumn = 95;
  for (const ScanLineKind kind : {ScanLineKind::kGouraud, ScanLineKind::kPhong}) {
    const ColumnStep step =
        largest_step(draw_by_scan_lines(concave_polygon(), kind, 0.9, 70.4, 201, 151), kColumn);
    CHECK(step.steps > 60);
    CHECK(std::abs(step.row - 68) <= 1);
  }
  // As two triangles that share the edge PQ it does not.
  for (const char* shading : {"gouraud", "phong", "arc"}) {
    CAPTURE(shading);
    CHECK(largest_step(ArtefactScene::concave().picture(shading), kColumn).steps < 8);
  }
}

TEST_CASE("the picture's middle shows the same point however it is turned") {
  const Vec3 first = ArtefactScene::turned(60, 0).middle_normal(ReferenceKind::kPhong);
  for (int turn = 5; turn < 360; turn += 35) {
    CHECK(length(ArtefactScene::turned(60, turn).middle_normal(ReferenceKind::kPhong) - first) < 2e-3);
  }
}

TEST_CASE("turning: chords do not depend on it, great circles do, and more the wider the triangle (S1)") {
  // On a triangle linear interpolation is the same in every direction; what is left is snapping to pixels.
  CHECK(rotation_spread(ReferenceKind::kPhong, 60).degrees < 0.15);
  CHECK(rotation_spread("gouraud", 60).steps <= 1);
  CHECK(rotation_spread("flat", 60).steps == 0);
  const RotationSpread wide = rotation_spread(ReferenceKind::kSlerp, 60);
  const RotationSpread middling = rotation_spread(ReferenceKind::kSlerp, 30);
  const RotationSpread near = rotation_spread(ReferenceKind::kSlerp, 10);
  CHECK(wide.degrees > 1);
  CHECK(wide.degrees > 4 * middling.degrees);
  CHECK(middling.degrees > 1.5 * near.degrees);
  CHECK(near.steps < 0.5);
  // The pipeline is as dependent on it as what it computes.
  CHECK(std::fabs(rotation_spread("recurrence", 60).steps - wide.steps) < 2);
  CHECK(rotation_spread("arc", 60).steps <= 3);
  CHECK(rotation_spread("arc", 10).steps <= 2);
}

TEST_CASE("every shading has its profile, of the same pixels") {
  const ArtefactScene scene = ArtefactScene::fold();
  const Profile reference = scene.middle_row(ReferenceKind::kSlerp);
  CHECK(reference.size() > 120);
  for (const ShadingRenderer& renderer : shading_renderers()) {
    const std::string shading(renderer.shading);
    CAPTURE(shading);
    const Profile profile = scene.middle_row(shading);
    REQUIRE(profile.size() == reference.size());
    for (const auto& [x, level] : profile) CHECK(level > 0);  // nothing left out
  }
}
