// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace arcspan::tools {

struct Curve {
  std::string label;
  std::vector<std::pair<double, double>> points;
  bool marks = false;  ///< single points instead of a line
};

/// A diagram: axes, legend and curves.
struct Figure {
  std::string title;
  std::string x_label;
  std::string y_label;
  bool logarithmic_x = false;
  bool logarithmic_y = false;
  std::vector<Curve> curves;
};

/// A figure that `arcspan plot` can make.
struct FigureMaker {
  std::string_view name;
  std::string_view help;
  Figure (*make)();
};

/// All of them.
[[nodiscard]] std::span<const FigureMaker> figure_makers();

/// `curve,x,y` lines with a head line.
[[nodiscard]] std::string to_csv(const Figure& figure);

}  // namespace arcspan::tools
