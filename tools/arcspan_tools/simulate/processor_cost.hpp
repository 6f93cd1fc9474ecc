// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/render/render.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// An amount on which the instructions of a drawing depend, such as its multiplications or its spans.
struct CostTerm {
  std::string name;  ///< the key of its weight in docs/estimates.json
  double amount = 0;
};

/// Returns the terms of drawing a job's bands:
///
/// - the operations of the counting pipeline; those of pixels times the share that passed the depth test;
/// - the triangles, spans and pixels that are drawn, and again the small triangles and their spans, because
///   these have a set-up and a loop of their own;
/// - the calls of draw_mesh().
///
/// `stats` are those of rendering the job with RenderJob::counts.
[[nodiscard]] std::vector<CostTerm> cost_terms(std::string_view shading, const RenderJob& job,
                                               const FixedMeshes& meshes, const RenderStats& stats);

/// The terms by the weights of docs/estimates.json, summed: instructions. Nothing for a method without
/// weights. Methods whose pixels depend on the highlight have weights for each.
[[nodiscard]] std::optional<double> weighted_sum(std::string_view shading, Highlight highlight,
                                                 const std::vector<CostTerm>& terms);

/// Instructions that a Cortex-M3 takes to draw a job: the terms by the weights of docs/estimates.json, which
/// scripts/simulate-estimates fits to drawings on an emulated board. Nothing for a method without weights
/// there.
[[nodiscard]] std::optional<double> draw_instructions(std::string_view shading, const RenderJob& job,
                                                      const FixedMeshes& meshes, const RenderStats& stats);

}  // namespace arcspan::tools
