// SPDX-License-Identifier: MIT

#include <tests/accuracy/method_rows.hpp>
#include <tests/support/dichotomy_model.hpp>
#include <tests/support/method_accuracy.hpp>

#include <algorithm>
#include <cstdio>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr double kClasses[] = {10, 25, 58};

template <class Model>
void print_row(const char* method, const char* model, int triangles) {
  std::printf("| `%s` | %s |", method, model);
  for (const double degrees : kClasses) {
    MethodTask task;
    task.to_degrees = degrees;
    task.triangles = triangles;
    task.seed = 4000 + static_cast<std::uint64_t>(degrees);
    const MethodFigures f = measure_method<Model>(probed_method(method), task);
    std::printf(" %.1e (%.1e) |", std::max(f.normal_light.max, f.normal_half.max), f.normal_light.rms());
  }
  std::puts("");
  std::fflush(stdout);
}

}  // namespace

void print_method_section() {
  std::puts(
      "## The methods that the papers compare with\n\n"
      "Each against its own model in double precision, with the very normals that it gets: what is measured "
      "is\n"
      "its integer arithmetic. Largest error of N·L and N·H (root mean square of N·L), triangles at least a "
      "pixel\n"
      "thin. In thinner ones the methods of chords lose more, since 16 bits of a distance say little "
      "there.\n"
      "Dichotomy changes over to Phong's normals beyond 45° across one segment; the two sides of that "
      "decision "
      "are up\n"
      "to 5e-3 apart, and integers and model do not always decide alike.");
}

void print_method_rows(int triangles) {
  std::puts("\n| method | model | normals up to 10° apart | 25° | 58° |\n|---|---|---|---|---|");
  const char* const chord = "chord / length";
  const char* const arc = "bilinear SLERP";
  print_row<UnitLinearModel>("phong", chord, triangles);
  print_row<UnitLinearModel>("phong-reciprocal", chord, triangles);
  print_row<UnitLinearModel>("duff", chord, triangles);
  print_row<TaylorModel>("lyon", "chord, times the series", triangles);
  const char* const halved = "chord, halved by the polynomial";
  print_row<DichotomyModel<&linear_root, 3>>("dichotomy-linear", halved, triangles);
  print_row<DichotomyModel<&quadratic_root, 3>>("dichotomy-quadratic", halved, triangles);
  print_row<DichotomyModel<&cubic_root, 3>>("dichotomy-cubic", halved, triangles);
  print_row<UnitLinearModel>("dichotomy-cubic", chord, triangles);
  print_row<DichotomyModel<&exact_root, 3, true>>("dichotomy-root", "chord, halved by the root", triangles);
  print_row<DichotomyModel<&printed_linear_root, 3, true>>("dichotomy-printed-linear", halved, triangles);
  print_row<DichotomyModel<&printed_quadratic_root, 3, true>>("dichotomy-printed-quadratic", halved,
                                                              triangles);
  print_row<SlerpModel>("slerp", arc, triangles);
  print_row<SlerpModel>("kuijk-blake", arc, triangles);
  print_row<SlerpModel>("recurrence", arc, triangles);
  print_row<SlerpModel>("recurrence-four", arc, triangles);
  print_row<SlerpModel>("arc-vector", arc, triangles);
}
