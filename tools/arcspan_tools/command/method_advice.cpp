// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/method_advice.hpp>
#include <arcspan_tools/support/text.hpp>

#include <cmath>

namespace arcspan::tools {
namespace {

/// "21 % more", "9 % less" or "as much".
std::string compared(double cost, double with) {
  const double percent = std::round(100 * (cost / with - 1));
  if (percent == 0) return "as much";
  return formatted("%.0f %% %s", std::fabs(percent), percent > 0 ? "more" : "less");
}

}  // namespace

std::string method_advice(const MethodCosts& costs) {
  // Flat shading is worth its facets only where it saves this much.
  constexpr double kWorthIt = 0.8;
  const char* const gouraud = costs.textured ? "grey Gouraud" : "Gouraud";
  const std::string arc = compared(costs.arc, costs.gouraud);
  const std::string flat = compared(costs.flat, costs.gouraud);
  const char* const word = arc == "as much" ? "as" : "than";
  std::string text = arc.ends_with("more")
                         ? formatted("arc, for highlights that move, takes %s than %s; %s for matt surfaces",
                                     arc.c_str(), gouraud, gouraud)
                         : formatted("arc takes %s %s %s: take arc", arc.c_str(), word, gouraud);
  text += "; flat takes ";
  text += flat == "as much" ? flat + formatted(" as %s", gouraud) : flat;
  return text + (costs.flat < kWorthIt * costs.gouraud ? ", for what is far away or has flat faces"
                                                       : ", which is not worth its facets");
}

}  // namespace arcspan::tools
