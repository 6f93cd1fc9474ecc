// SPDX-License-Identifier: MIT
// Measures what the papers claim and prints docs/claims.md (CMake target update_claims).
// Usage: claims_report [--untimed]      --untimed: without times, for comparison with the page
#include <arcspan_tools/compare/artefacts.hpp>
#include <arcspan_tools/compare/scan_line_polygon.hpp>
#include <arcspan_tools/plot/formulas.hpp>
#include <tests/artefacts/speed_claims.hpp>

#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>

using namespace arcspan::tools;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

void print_head() {
  std::puts(
      "<!-- SPDX-License-Identifier: MIT -->\n"
      "# What the papers say and what we measured\n\n"
      "S0, S1 and S3 are the [papers](papers.md). `scripts/update-figures claims` prints this page, at "
      "releases; `arcspan\n"
      "plot` draws the papers' figures. Times are of one x86-64 core, instructions are callgrind's; both "
      "are of whole\n"
      "pictures with depth test, a release build.\n\n"
      "Compiled by gcc " __VERSION__ ".\n");
}

void print_recurrence() {
  std::puts(
      "## The recurrence in short words\n\n"
      "S0 gives eq. 7 and 14 without a word length. Largest error of x(t) = cos(start + t angle/m) over "
      "20,000\n"
      "random spans with angles up to 90 degrees:\n\n"
      "| pixels m | printed form, 16 bits | 24 bits | 32 bits | difference form, 16x16 multiply |\n"
      "|---:|---:|---:|---:|---:|");
  for (const int pixels : {16, 64, 256, 1024}) {
    std::printf("| %d | %.1e | %.1e | %.1e | %.1e |\n", pixels, printed_recurrence_error(pixels, 14),
                printed_recurrence_error(pixels, 22), printed_recurrence_error(pixels, 30),
                difference_recurrence_error(pixels));
  }
  std::puts("\nThe method `recurrence` uses the difference form and begins anew after 256 pixels.\n");
}

void print_segments() {
  std::puts("## Segments (S3)\n\n| claim | paper | measured |\n|---|---|---|");
  std::printf(
      "| error of a highlight, 1 - cos^n(angle/2), n = 100, at 4 degrees | at most 4 %% | %.2f %% |\n",
      100 * segment_error(4 * kDegree, 100));
  std::printf("| up to which angle 4 %% holds for n = 100 | 4 degrees | %.2f degrees |\n",
              widest_segment(0.04, 100) / kDegree);
  int n = 1;
  while (segment_error(4 * kDegree, n + 1) <= 0.04) ++n;
  std::printf("| up to which n 4 %% holds at 4 degrees | 100 | %d |\n", n);
  for (const int exponent : {1, 16, 64}) {
    std::printf("| widest segment with an error of at most 1/64, n = %d | - | %.1f degrees |\n", exponent,
                widest_segment(1.0 / 64, exponent) / kDegree);
  }
  for (const double degrees : {10.0, 20.0, 45.0}) {
    std::printf(
        "| absolute error of the diffuse part at %.0f degrees (figure 2) | at most %.4f, by its formula | "
        "%.4f |\n",
        degrees, s3_absolute_error(degrees * kDegree), segment_error(degrees * kDegree, 1));
  }
  std::puts(
      "\nS3's formula has both ends of a segment fully lit, which no light does. `arcspan plot "
      "absolute-error`,\n"
      "`diffuse-error` and `specular-error` draw S3's figures 2 to 4.\n");
}

void print_polynomial(const char* name, const char* claim, Polynomial p) {
  constexpr double k45 = 45 * kDegree;
  std::printf("| %s | %s | %.1e | %.1e | %.1e |\n", name, claim, worst_absolute(p, k45),
              worst_relative(p, k45), length_error_after_halvings(p, k45, 5));
}

void print_polynomials() {
  std::puts(
      "## Dichotomy: polynomials for 1/sqrt(2 + z) (S3)\n\n"
      "For normals up to 45 degrees apart. The last column is the largest error of a normal's length among "
      "all\n"
      "nodes of five halvings from 45 degrees.\n\n"
      "| polynomial | S3: error at most | absolute | relative | after 5 halvings "
      "|\n|---|---|---:|---:|---:|");
  print_polynomial("0.64 - 0.07 z, as printed", "5e-4 (0.12 %)", &s3_linear);
  print_polynomial("0.681 - 0.119 z + 0.014 z^2, as printed", "2e-5 (0.004 %)", &s3_quadratic);
  print_polynomial("the same with nine digits, linear", "-", &minimax_linear);
  print_polynomial("the same with nine digits, quadratic", "-", &minimax_quadratic);
  print_polynomial("in 2 - z, linear", "-", &flat_linear);
  print_polynomial("in 2 - z, quadratic", "-", &flat_quadratic);
  print_polynomial("in 2 - z, cubic", "-", &flat_cubic);
  std::puts(
      "\nS3 rounds the coefficients too far. The forms in 2 - z leave flat spans exactly alone, which those "
      "in\n"
      "z do not.\n");
}

std::string spread_text(const RotationSpread& s) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f / %.2f°", s.steps, s.degrees);
  return text;
}

template <class Shading>
void print_artefact_row(const char* name, const Shading& shading) {
  constexpr double kEdge = 100;
  constexpr int kReach = 12;
  constexpr std::int32_t kBesideReflexCorner = 95;
  std::printf("| %s | %.0f | %.2f | %.2f | %.0f | %.2f | %.0f |", name,
              peak(ArtefactScene::highlight().middle_row(shading)),
              kink(ArtefactScene::fold().middle_row(shading), kEdge, kReach),
              kink(ArtefactScene::narrow_fold().middle_row(shading), kEdge, kReach), flicker(shading),
              highlight_elongation(ArtefactScene::star().picture(shading)),
              largest_step(ArtefactScene::concave().picture(shading), kBesideReflexCorner).steps);
  for (const double apart : {10.0, 30.0, 60.0}) {
    std::printf(" %s |", spread_text(rotation_spread(shading, apart)).c_str());
  }
  std::puts("");
}

double scan_line_step(ScanLineKind kind) {
  return largest_step(draw_by_scan_lines(concave_polygon(), kind, 0.9, 70.4, 201, 151), 95).steps;
}

void print_artefacts() {
  std::puts(
      "## Artefacts\n\n"
      "* Highlight (S3, defect c): in the middle of a triangle whose corners lie outside it; the brightest "
      "pixel, of 255.\n"
      "* Mach bands (S1; S3, defect d): the kink of the brightness across the edge between two triangles, in "
      "steps per\n"
      "  pixel. *Head-on*: triangles of equal width whose normals turn away to both sides; here Phong and "
      "arcs "
      "are equal\n"
      "  by symmetry. *From the side*: widths 1 and 0.3, light at 45 degrees; S1 is right that Phong's "
      "method "
      "shows this\n"
      "  band more strongly than Gouraud's.\n"
      "* Flicker (S3, defect e): a sphere of 12 x 6 turns by one segment; how much the brightest pixel "
      "changes.\n"
      "* Star (S3, defect f): the largest radius of a highlight that should be round, divided by its least; "
      "up to 1.2 is\n"
      "  rounding to pixels.\n"
      "* Reflex corner (S1, figure 26.3): the largest step between two rows beside the inward corner of a "
      "polygon.\n"
      "* Turned (S1): the same triangle turned in the image plane; the spread of one point's brightness in "
      "steps / of its\n"
      "  normal, for normals 10, 30 and 60 degrees apart.\n\n"
      "| shading | highlight | kink, head-on | kink, from the side | flicker | star | reflex corner | "
      "turned, 10° "
      "| turned, 30° | turned, 60° |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
  print_artefact_row("reference: Phong, double", ReferenceKind::kPhong);
  print_artefact_row("reference: slerp, double", ReferenceKind::kSlerp);
  // The others differ from one of these by rounding.
  for (const std::string shading : {"flat", "gouraud", "arc", "segment", "recurrence", "phong", "lyon",
                                    "reflection-map", "dichotomy-printed-quadratic"}) {
    print_artefact_row(shading.c_str(), shading);
  }
  std::printf(
      "\nA non-convex polygon that is shaded as a whole, along its edges and then along rows, as S1 "
      "describes it,\n"
      "has a step of %.0f by Gouraud's method and %.0f by Phong's there. The pipeline draws triangles "
      "only.\n\n",
      scan_line_step(ScanLineKind::kGouraud), scan_line_step(ScanLineKind::kPhong));
  std::puts(
      "![Mach bands, flicker, star and reflex corner by Gouraud's method and by "
      "arcs](images/artefacts.png)\n\n"
      "S1 says that shading by Gouraud's and Phong's methods depends on rotation. On triangles it does "
      "not: linear\n"
      "interpolation is the same in every direction, and so is `arc` with its normalised linear normal. "
      "Great "
      "circles\n"
      "along edges and then along rows do depend on it, by the spread above.");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc > 3 && std::string(argv[1]) == "--draw") {
      for (int i = 3; i + 1 < argc; i += 2) draw_once(argv[i], argv[2], std::atoi(argv[i + 1]));
      return 0;
    }
    const bool untimed = argc == 2 && std::string(argv[1]) == "--untimed";
    print_head();
    print_speed(argv[0], untimed ? Timing::kLeftOut : Timing::kMeasured);
    print_recurrence();
    print_segments();
    print_polynomials();
    print_artefacts();
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "claims_report: %s\n", e.what());
    return 1;
  }
}
