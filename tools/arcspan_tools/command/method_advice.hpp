// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace arcspan::tools {

/// Instructions of a picture by each main method.
struct MethodCosts {
  double flat = 0;
  double gouraud = 0;  ///< of textures by GreyGouraud
  double arc = 0;
  bool textured = false;
};

/// Which method to take for a model, a sentence for each: the advice of docs/performance.md with its figures.
[[nodiscard]] std::string method_advice(const MethodCosts& costs);

}  // namespace arcspan::tools
