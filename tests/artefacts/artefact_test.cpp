// SPDX-License-Identifier: MIT
// The artefacts that the papers describe, measured on the pipeline's pictures.
#include <arcspan_tools/compare/artefacts.hpp>
#include <catch2/catch.hpp>

#include <cmath>

using namespace arcspan::tools;

TEST_CASE("a highlight inside a triangle: Gouraud misses it, the arcs have it (S3, defect c)") {
  const ArtefactScene scene = ArtefactScene::highlight();
  const double reference = peak(scene.middle_row(ReferenceKind::kPhong));
  CHECK(reference > 240);  // 255 * (0.5 + 0.45)
  CHECK(peak(scene.middle_row("gouraud")) < 0.5 * 255);
  CHECK(std::fabs(peak(scene.middle_row("arc")) - reference) < 2);
}

TEST_CASE("Mach bands: Gouraud's brightness has a kink at an edge, the arcs' has none (S1, S3, defect d)") {
  const ArtefactScene scene = ArtefactScene::fold();
  constexpr double kEdge = 100;
  constexpr int kReach = 12;
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
  CHECK(std::fabs(rotation_spread("arc", 60).steps - wide.steps) < 2);
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
