// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/render/render.hpp>

#include <cstddef>
#include <optional>
#include <string_view>

namespace arcspan::tools {

/// Instructions that a Cortex-M3 takes to draw what `stats` says, by the marginal costs of docs/costs.json,
/// which were counted in a frame with one light; in bands, vertices cost once for each. Nothing for a
/// shading method that has no figures there.
[[nodiscard]] std::optional<double> draw_instructions(std::string_view shading, const RenderStats& stats,
                                                      std::size_t vertices);

}  // namespace arcspan::tools
