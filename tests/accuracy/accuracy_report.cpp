// SPDX-License-Identifier: MIT
// Measures the accuracy of shading and prints docs/accuracy.md.
// Usage: accuracy_report                prints the page
//        accuracy_report --methods      only its last section, for comparison with the page
//        accuracy_report --tenth        a tenth of its table of measurements, for comparison with tenth.txt
#include <tests/accuracy/method_rows.hpp>
#include <tests/support/surface_accuracy.hpp>

#include <cstdio>
#include <iterator>
#include <string_view>

using namespace arcspan::test;

namespace {

/// Classes of the widest angle between two normals of a triangle.
constexpr double kClasses[] = {0, 20, 40, 60, 97};

SurfaceErrors measure(std::size_t index, std::int32_t shininess, std::int32_t tolerance, int triangles) {
  SurfaceMeasurement<arcspan::Highlight::kPhong> measurement;
  Random random(1000 + index);
  const SurfaceShapes shapes{.from_degrees = kClasses[index], .to_degrees = kClasses[index + 1]};
  for (int i = 0; i < triangles; ++i) {
    SurfaceCase c = random_surface(random, shapes);
    c.shininess = shininess;
    c.tolerance = tolerance;
    measurement.measure(c);
  }
  return measurement.errors;
}

void print_classes(int triangles) {
  std::puts(
      "| widest angle of normals | tolerance | pixels | N·L | highlight, n = 16 | n = 64 |\n"
      "|---|---|---|---|---|---|");
  for (std::size_t i = 0; i + 1 < std::size(kClasses); ++i) {
    for (const std::int32_t tolerance : {0, 1}) {
      const SurfaceErrors blunt = measure(i, 16, tolerance, triangles);
      const SurfaceErrors sharp = measure(i, 64, tolerance, triangles);
      std::printf("| %.0f° | %d | %llu | %.2f (%.2f) | %.2f (%.2f) | %.2f (%.2f) |\n", kClasses[i + 1],
                  tolerance, static_cast<unsigned long long>(blunt.pixels), blunt.light_bins.nearly_all(),
                  blunt.light, blunt.highlight_bins.nearly_all(), blunt.highlight,
                  sharp.highlight_bins.nearly_all(), sharp.highlight);
      std::fflush(stdout);
    }
  }
}

void print_page(int triangles) {
  std::puts(
      "<!-- SPDX-License-Identifier: MIT -->\n"
      "# Accuracy\n\n"
      "This page states the limits of accuracy, once, and what was measured. It is printed by the program\n"
      "`accuracy_report` (`scripts/update-figures accuracy`); the tests check the bounds.\n\n"
      "## Limits\n\n"
      "Of `arc` with tolerance 0 against classic Phong shading in double precision, where the normal is "
      "linear on the\n"
      "screen and divided by its length: triangles of any size up to 1,000 pixels, slivers, and any cut by "
      "the near plane,\n"
      "or by the guard band in pictures up to 1,024 pixels; white light, diffuse and specular coefficients "
      "1. "
      "Steps are\n"
      "255ths of full brightness. In brackets: the largest error found by tests and the measurement below, "
      "or "
      "the part\n"
      "outside of the limit.\n\n"
      "| | normals up to 60° apart: 99.9 % of the pixels within | all within | 60° to 97°: all within |\n"
      "|---|---|---|---|\n"
      "| N·L | 0.2 steps (all but 0.03 %) | 1 step (0.35) | 1 step (0.21) |\n"
      "| highlight, n = 16 | 3 steps | 13 steps (4.5) | 13 steps (9.0) |\n"
      "| highlight, n = 64 | 8 steps (all but 0.002 %) | 40 steps (12.2) | 40 steps (15.9) |\n"
      "| with tolerance t, 1 to 64 | t steps more | t steps more | t steps more |\n\n"
      "* *Limits of the orders.* A linear or quadratic surface may add 0.2 steps to N·L and 1.4 to a "
      "highlight\n"
      "  (`kExactEnough`, `kHighlightError`); the rest is rounding of normals and tables.\n"
      "* *Tolerance.* With t = 1, 4, 16 and 64 the tests find N·L off by at most 1.2, 3.2, 12.9 and 27.8 "
      "steps.\n"
      "* *Beyond 97°* between two normals the length of the linear normal may fall below a half. It "
      "saturates there: no\n"
      "  scalar is lengthened by more than twice, and N·L may be off by up to 240 steps. Such normals "
      "usually mean\n"
      "  a sharp edge (`--crease`).\n"
      "* *The terminator.* A highlight that ends abruptly at N·L = 0 may be drawn on either side where |N·L| "
      "is below\n"
      "  1/255. `Material::highlight_fade` makes it fade out instead.\n"
      "* *Several lights.* Errors of their highlights add up. Where those of two lights coincide (diffuse "
      "0.2, "
      "specular 0.4,\n"
      "  normals up to 30° apart), colours are within 3.5 steps, with n = 64 within 5.5, half a step of "
      "rounding included\n"
      "  (`two_lights_test.cpp`).\n\n"
      "Coverage is exact ([decision 1](decisions/0001-exact-edges.md)). The limits are asserted by "
      "`tests/pipeline/surface`;\n"
      "all other pages refer to this table, and [decision 35](decisions/0035-one-surface.md) has the "
      "reasons.\n\n"
      "## Measured\n\n"
      "50,000 random triangles of 3 to 1,000 pixels for each row, a quarter of them slivers, with packed "
      "normals.\n"
      "Every pixel is compared with classic Phong shading in double precision. The error of 99.9 % of the "
      "pixels (of\n"
      "all), in 255ths; highlights by R·V.\n");
  print_classes(triangles);
}

void print_methods(int triangles) {
  print_method_section();
  print_method_rows(triangles / 125);
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kTriangles = 50000;  // per class
  const std::string_view part = argc == 2 ? argv[1] : "";
  if (argc > 2 || (argc == 2 && part != "--methods" && part != "--tenth")) {
    std::fputs("usage: accuracy_report [--methods | --tenth]\n", stderr);
    return 2;
  }
  if (part == "--tenth") {
    print_classes(kTriangles / 10);
    return 0;
  }
  if (part.empty()) {
    print_page(kTriangles);
    std::puts("");
  }
  print_methods(kTriangles);
  return 0;
}
