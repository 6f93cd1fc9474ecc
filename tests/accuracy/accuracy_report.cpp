// SPDX-License-Identifier: MIT
// Measures the accuracy of spherical-angular shading and prints docs/accuracy.md.
// Usage: accuracy_report [--tenth]      --tenth: only its last section, for comparison with the page
#include <tests/accuracy/method_rows.hpp>
#include <tests/support/accuracy.hpp>

#include <cstdio>
#include <string_view>

using namespace arcspan::test;

namespace {

constexpr double kClasses[] = {0, 3, 6, 11, 20, 30, 45, 60};

AccuracyFigures measure_class(int index, int triangles) {
  AccuracyTask task;
  task.from_degrees = kClasses[index];
  task.to_degrees = kClasses[index + 1];
  task.triangles = triangles;
  task.seed = static_cast<std::uint64_t>(1000 + index);
  AccuracyFigures figures = measure_accuracy(task);
  task.smallest = 64;
  task.largest = 1024;
  task.triangles = triangles / 10;
  task.seed += 1000;
  figures.add(measure_accuracy(task));
  return figures;
}

void print(int index, const AccuracyFigures& f) {
  std::printf(
      "| %.0f° | %llu | %llu | %.1e (%.1e) | %.1e (%.1e) | %.1e (%.1e) | %d / %.2f | %d / %.2f | %d / %.2f "
      "|\n",
      kClasses[index + 1], static_cast<unsigned long long>(f.triangles),
      static_cast<unsigned long long>(f.pixels), f.normal_light.max, f.normal_light.rms(), f.normal_half.max,
      f.normal_half.rms(), f.normal_eye.max, f.normal_eye.rms(), f.matt_steps, f.matt.max, f.blinn_steps,
      f.blinn.max, f.phong_steps, f.phong.max);
  std::fflush(stdout);
}

void print_classes(int triangles) {
  std::puts(
      "| normals apart up to | triangles | pixels | N·L | N·H | N·V | diffuse only | Blinn | Phong |\n"
      "|---|---|---|---|---|---|---|---|---|");
  for (int i = 0; i < 7; ++i) print(i, measure_class(i, triangles));
}

void print_page(int triangles) {
  std::puts(
      "<!-- SPDX-License-Identifier: MIT -->\n"
      "# Accuracy\n\n"
      "This page states the limits of accuracy, once, and what was measured. It is printed by the program\n"
      "`accuracy_report` (`scripts/update-figures accuracy`); the tests check the bounds.\n\n"
      "## Limits\n\n"
      "Of `arc` with tolerance 0 against classic Phong shading in double precision, where the normal is "
      "linear "
      "on the\n"
      "screen and divided by its length: normals up to 60° apart, triangles of any size up to 1,000 pixels, "
      "slivers, and\n"
      "any cut by the near plane or the guard band. Steps are 255ths of full brightness.\n\n"
      "| | 99.9 % of the pixels within | all within |\n"
      "|---|---|---|\n"
      "| N·L | 0.2 steps | 1 step |\n"
      "| highlight, n = 16 | 3 steps | 13 steps |\n"
      "| highlight, n = 64 | 8 steps | 40 steps |\n"
      "| with tolerance t | t steps more | t steps more |\n\n"
      "Coverage is exact ([decision 1](decisions/0001-exact-edges.md)). All other pages refer to this "
      "table.\n\n"
      "## Measured\n\n"
      "Random triangles from a third of a pixel to the whole guard band, slim ones among them, go through\n"
      "triangle preparation and the span stage with normals packed as in a mesh. TODO-LEAD: every pixel is "
      "compared\n"
      "with bilinear SLERP of the exact normals in double precision, along the screen edges, then along the "
      "row.\n\n"
      "Cosines: largest (root mean square) error. Channels: largest difference in 8-bit steps from the "
      "rounded\n"
      "reference / from the unrounded reference, of which half a step is rounding. Random materials, "
      "shininess 1 to "
      "64,\n"
      "specular coefficients up to 1.\n");
  print_classes(triangles);
}

/// Ten times as fast, for a test.
void print_tenth(int triangles) {
  std::puts(
      "## A tenth of it\n\n"
      "This part is measured with a tenth of the triangles. The test command measures it again and fails if "
      "a figure\n"
      "differs by more than 2 %.\n");
  print_classes(triangles / 10);
  print_method_section();
  print_method_rows(triangles / 250);
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kTriangles = 100000;  // per class
  const bool tenth = argc == 2 && std::string_view(argv[1]) == "--tenth";
  if (argc != 1 && !tenth) {
    std::fputs("usage: accuracy_report [--tenth]\n", stderr);
    return 2;
  }
  if (!tenth) {
    print_page(kTriangles);
    std::puts("");
  }
  print_tenth(kTriangles);
  return 0;
}
