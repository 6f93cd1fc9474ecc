// SPDX-License-Identifier: MIT
#include <arcspan_tools/counting/count_operations.hpp>
#include <arcspan_tools/render/surface_drawer.hpp>
#include <arcspan_tools/simulate/estimates_json.hpp>
#include <arcspan_tools/simulate/processor_cost.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>

namespace arcspan::tools {

std::vector<CostTerm> cost_terms(std::string_view shading, const RenderJob& job, const FixedMeshes& meshes,
                                 const RenderStats& stats) {
  const arcspan_counting::CountedDraw draw = count_operations(shading, job, meshes);
  const auto share = [](std::uint64_t part, std::uint64_t of) {
    return of == 0 ? 0 : static_cast<double>(part) / static_cast<double>(of);
  };
  const double passed = job.depth ? share(stats.written, stats.pixels) : 1;
  std::vector<CostTerm> terms;
  for (std::size_t i = 0; i < arcspan_counting::kOperationKinds; ++i) {
    const std::string name(arcspan_counting::kOperationNames[i]);
    terms.push_back({name, static_cast<double>(draw.around.of[i])});
    terms.push_back({"pixel's " + name, static_cast<double>(draw.in_spans.of[i])});
  }
  const auto bands = static_cast<double>(stats.bands);
  const auto pixels = static_cast<double>(draw.pixels);
  terms.push_back({"triangle", static_cast<double>(draw.triangles)});
  terms.push_back({"small triangle", static_cast<double>(draw.small_triangles)});
  terms.push_back({"span", static_cast<double>(draw.spans)});
  terms.push_back({"small span", static_cast<double>(draw.small_spans)});
  terms.push_back({"pixel", pixels});
  terms.push_back({"written pixel", pixels * passed});
  terms.push_back({"call", bands * static_cast<double>(meshes.size())});
  return terms;
}

std::optional<double> weighted_sum(std::string_view shading, Highlight highlight,
                                   const std::vector<CostTerm>& terms) {
  static const nlohmann::json kWeights = nlohmann::json::parse(kEstimatesJson).at("mps2-an385");
  auto weights = kWeights.find(std::string(shading) + (highlight == Highlight::kBlinn ? " blinn" : " phong"));
  if (weights == kWeights.end()) weights = kWeights.find(std::string(shading));
  if (weights == kWeights.end()) return std::nullopt;
  double instructions = 0;
  for (const CostTerm& term : terms) instructions += weights->value(term.name, 0.0) * term.amount;
  return instructions;
}

std::optional<double> draw_instructions(std::string_view shading, const RenderJob& job,
                                        const FixedMeshes& meshes, const RenderStats& stats) {
  if (job.lights.size() != 1 || has_surfaces(job)) return std::nullopt;
  return weighted_sum(shading, job.highlight, cost_terms(shading, job, meshes, stats));
}

}  // namespace arcspan::tools
