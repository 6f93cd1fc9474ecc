// SPDX-License-Identifier: MIT
#include <arcspan_tools/plot/figure.hpp>
#include <arcspan_tools/plot/figure_list.hpp>

#include <cstdio>

namespace arcspan::tools {

std::span<const FigureMaker> figure_makers() {
  static constexpr FigureMaker kMakers[] = {
      {"diffuse-error",
       "relative error in the middle of a linear segment against its angle: diffuse (S3 fig. 3)",
       &diffuse_error_figure},
      {"absolute-error", "absolute error in the middle of a linear segment: diffuse (S3 fig. 2)",
       &absolute_error_figure},
      {"specular-error", "relative error for highlights of several exponents (S3 fig. 4)",
       &specular_error_figure},
      {"polynomial-error", "dichotomy: polynomials for 1/sqrt(2 + z) against the angle", &polynomial_figure},
      {"recurrence-error", "the recurrence's error against the span's length, per word length",
       &recurrence_figure},
      {"highlight", "a highlight inside a triangle, by every shading", &highlight_figure},
      {"mach-bands", "brightness across the edge between two triangles, by every shading", &mach_figure},
      {"mach-bands-side", "the same where triangles of unequal width are lit from the side",
       &narrow_mach_figure},
      {"flicker", "brightest pixel of a sphere while it turns about its axis, by every shading",
       &flicker_figure},
      {"rotation", "brightness of one point while the picture is turned, by every shading", &rotation_figure},
  };
  return kMakers;
}

std::string to_csv(const Figure& figure) {
  std::string text = "curve,x,y\n";
  for (const Curve& curve : figure.curves) {
    for (const auto& [x, y] : curve.points) {
      char line[96];
      std::snprintf(line, sizeof line, ",%.9g,%.9g\n", x, y);
      text += "\"" + curve.label + "\"" + line;
    }
  }
  return text;
}

}  // namespace arcspan::tools
