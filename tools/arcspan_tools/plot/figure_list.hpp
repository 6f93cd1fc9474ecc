// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/plot/figure.hpp>

namespace arcspan::tools {

// The papers' own (formulas.cpp computes them).
[[nodiscard]] Figure diffuse_error_figure();
[[nodiscard]] Figure absolute_error_figure();
[[nodiscard]] Figure specular_error_figure();
[[nodiscard]] Figure polynomial_figure();
[[nodiscard]] Figure recurrence_figure();

// The papers' artefacts, drawn by every shading method of the pipeline.
[[nodiscard]] Figure highlight_figure();
[[nodiscard]] Figure mach_figure();
[[nodiscard]] Figure narrow_mach_figure();
[[nodiscard]] Figure flicker_figure();
[[nodiscard]] Figure rotation_figure();

}  // namespace arcspan::tools
