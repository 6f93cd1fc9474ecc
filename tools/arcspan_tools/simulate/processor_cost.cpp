// SPDX-License-Identifier: MIT
#include <arcspan_tools/simulate/costs_json.hpp>
#include <arcspan_tools/simulate/processor_cost.hpp>
#include <nlohmann/json.hpp>

#include <string>

namespace arcspan::tools {

std::optional<double> draw_instructions(std::string_view shading, const RenderStats& stats,
                                        std::size_t vertices) {
  static const nlohmann::json kMarginal = nlohmann::json::parse(kCostsJson).at("marginal").at("mps2-an385");
  const auto found = kMarginal.find(std::string(shading));
  if (found == kMarginal.end()) return std::nullopt;
  const auto cost = [&found](const char* what) { return found->at(what).get<double>(); };
  const auto bands = static_cast<double>(stats.bands);
  // A triangle includes its share of transforming the vertices once; every further band transforms them
  // again.
  return cost("triangle_without_planes") * stats.triangles +
         cost("vertex") * static_cast<double>(vertices) * (bands - 1) +
         cost("span") * static_cast<double>(stats.spans) + cost("pixel") * static_cast<double>(stats.pixels);
}

}  // namespace arcspan::tools
