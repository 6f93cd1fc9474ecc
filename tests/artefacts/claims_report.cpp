// SPDX-License-Identifier: MIT
// Measures what the papers claim and prints docs/claims.md (CMake target update_claims).
#include <arcspan_tools/compare/artefacts.hpp>
#include <arcspan_tools/plot/formulas.hpp>
#include <arcspan_tools/plot/worked_example.hpp>
#include <tests/artefacts/speed_claims.hpp>

#include <cmath>
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
      "S0, S1 and S3 are the [papers](papers.md). Every figure here is printed by the program "
      "`claims_report`\n"
      "(`cmake --preset release && cmake --build build/release --target update_claims`; it takes valgrind).\n"
      "`tests/artefacts` checks the statements. `arcspan plot` draws the figures, `arcspan compare` the\n"
      "pictures. Times are of one x86-64 core, instructions are callgrind's; both are of whole pictures "
      "with\n"
      "depth test, a release build.\n");
}

void print_recurrence() {
  std::puts(
      "## The recurrence in short words\n\n"
      "S0 gives eq. 7 and 14 without a word length. Largest error of x(t) = cos(start + t angle/m) over "
      "spans\n"
      "of 10, 30, 60 and 90 degrees and 24 starts:\n\n"
      "| pixels m | printed form, 16 bits | 24 bits | 32 bits | difference form, 16x16 multiply |\n"
      "|---:|---:|---:|---:|---:|");
  for (const int pixels : {16, 64, 256, 1024}) {
    std::printf("| %d | %.1e | %.1e | %.1e | %.1e |\n", pixels, printed_recurrence_error(pixels, 14),
                printed_recurrence_error(pixels, 22), printed_recurrence_error(pixels, 30),
                difference_recurrence_error(pixels));
  }
  std::puts("\nThe pipeline uses the difference form and begins anew after 256 pixels.\n");
}

void print_segments() {
  std::puts("## Segments (S3)\n\n| claim | paper | measured | remarks |\n|---|---|---|---|");
  std::printf(
      "| error of a highlight, n = 100, at 4 degrees | at most 4 %% | %.2f %% | by S3's own formula, "
      "1 - cos^n(angle/2) |\n",
      100 * segment_error(4 * kDegree, 100));
  std::printf("| up to which angle 4 %% holds for n = 100 | 4 degrees | %.2f degrees | |\n",
              widest_segment(0.04, 100) / kDegree);
  int n = 1;
  while (segment_error(4 * kDegree, n + 1) <= 0.04) ++n;
  std::printf("| up to which n 4 %% holds at 4 degrees | 100 | %d | |\n", n);
  for (const int exponent : {1, 16, 64, 256}) {
    std::printf("| widest segment with an error of at most 1/64, n = %d | - | %.1f degrees | |\n", exponent,
                widest_segment(1.0 / 64, exponent) / kDegree);
  }
  std::puts("");
}

void print_polynomial(const char* name, const char* claim, Polynomial p) {
  constexpr double k45 = 45 * kDegree;
  std::printf("| %s | %s | %.1e | %.1e | %.1e |\n", name, claim, worst_absolute(p, k45),
              worst_relative(p, k45), std::fabs(length_after_halvings(p, k45, 5)));
}

void print_polynomials() {
  std::puts(
      "## Dichotomy: polynomials for 1/sqrt(2 + z) (S3)\n\n"
      "For normals up to 45 degrees apart. The last column is the error of a normal's length after five\n"
      "halvings from 45 degrees.\n\n"
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

void print_misprints() {
  constexpr double kStart = 0.3;
  constexpr double kPhi = 5 * kDegree;
  std::puts(
      "## Misprints\n\n"
      "S0 eq. 9 to 11 make x(t+2), x(t+3), x(t+4) from x(t) and x(t-1). Tried on x(t) = cos(0.3 + t phi),\n"
      "phi = 5 degrees, t = 0; C = cos(2 phi), c = cos(phi):\n\n"
      "| equation | reference | as printed | corrected | the correct form |\n|---|---:|---:|---:|---|");
  const char* forms[] = {"as printed: (2C + 1) x(t) - 2c x(t-1)", "C (4c x(t) - 2 x(t-1)) - x(t-1)",
                         "2C (2C + 1) x(t) - 4cC x(t-1) - x(t)"};
  for (int ahead = 2; ahead <= 4; ++ahead) {
    std::printf("| S0 (%d) | %.6f | %.6f | %.6f | %s |\n", ahead + 7, std::cos(kStart + ahead * kPhi),
                printed_ahead(ahead, kStart, kPhi), corrected_ahead(ahead, kStart, kPhi), forms[ahead - 2]);
  }
  std::puts("");
}

void print_worked_example() {
  const WorkedExample e = worked_example();
  std::puts(
      "S1's worked example, rounded there to two digits at every step:\n\n"
      "| intensity | exact | printed |\n|---|---:|---|");
  std::printf("| flat, plane 3 | %.6f | 3.95 in the text, 3.93 in the summary |\n", e.flat);
  std::printf("| at A, B, C | %.6f, %.6f, %.6f | 4.25, 4.65, 4.45 |\n", e.vertices[0], e.vertices[1],
              e.vertices[2]);
  std::printf("| Gouraud at P | %.6f | 4.54 |\n", e.gouraud);
  std::printf("| Phong at P, normal not normalised, as S1 does | %.6f | 4.65 |\n", e.phong_not_normalised);
  std::printf("| Phong at P | %.6f | - |\n| along great circles at P | %.6f | - |\n\n", e.phong, e.arc);
  std::printf(
      "The printed gap between Gouraud and Phong, 0.11, is rounding; the true one is %.3f. The eye's unit\n"
      "vector is printed with y = 0.5; its components are all 0.577.\n\n",
      e.phong - e.gouraud);
}

std::string spread_text(const RotationSpread& s) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f / %.2f°", s.steps, s.degrees);
  return text;
}

template <class Shading>
void print_artefact_row(const char* name, const Shading& shading) {
  const double highest = peak(ArtefactScene::highlight().middle_row(shading));
  const double second_difference = kink(ArtefactScene::fold().middle_row(shading), 100, 12);
  std::printf("| %s | %.0f | %.2f |", name, highest, second_difference);
  for (const double apart : {10.0, 30.0, 60.0}) {
    std::printf(" %s |", spread_text(rotation_spread(shading, apart)).c_str());
  }
  std::puts("");
}

void print_artefacts() {
  std::puts(
      "## Artefacts\n\n"
      "* A highlight in the middle of a triangle whose corners lie outside it (S3, defect c of Gouraud's\n"
      "  method): the brightest pixel of the middle row, of 255.\n"
      "* Mach bands (S1; S3, defect d): the kink of the brightness across the edge between two triangles, "
      "in\n"
      "  steps a pixel, over 12 pixels on either side. A smooth surface has its own second difference, the "
      "reference's.\n"
      "* Change of shading under rotation (S1): the same triangle turned in the image plane in steps of 5\n"
      "  degrees; the spread of one point's brightness in 8-bit steps / of its normal in degrees, for "
      "normals\n"
      "  10, 30 and 60 degrees apart. Normals are calculated from 8-bit brightness, to 0.2 degrees or so; "
      "references\n"
      "  exactly. What is left of the first reference is the snapping of vertices to 1/16 pixel.\n\n"
      "`arcspan plot highlight`, `mach-bands` and `rotation` show them.\n\n"
      "| shading | highlight | kink | turned, 10° | turned, 30° | turned, 60° "
      "|\n|---|---:|---:|---:|---:|---:|");
  print_artefact_row("reference: Phong, double", ReferenceKind::kPhong);
  print_artefact_row("reference: slerp, double", ReferenceKind::kSlerp);
  for (const std::string& shading : shading_names()) print_artefact_row(shading.c_str(), shading);
  std::puts(
      "\nS1 says that shading by Gouraud's and Phong's methods depends on rotation. On triangles it does "
      "not:\n"
      "linear interpolation over a triangle is the same in every direction (over quadrilaterals, of which "
      "S1\n"
      "speaks, it is not). Great circles along edges and then along rows do depend on it, by the spread "
      "above:\n"
      "this is why triangles of more than 60 degrees are split.");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 5 && std::string(argv[1]) == "--draw") {
      draw_once(argv[2], argv[3], std::atoi(argv[4]));
      return 0;
    }
    print_head();
    print_speed(argv[0]);
    print_recurrence();
    print_segments();
    print_polynomials();
    print_misprints();
    print_worked_example();
    print_artefacts();
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "claims_report: %s\n", e.what());
    return 1;
  }
}
