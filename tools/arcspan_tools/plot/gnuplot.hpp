// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/plot/figure.hpp>

#include <cstdint>

namespace arcspan::tools {

enum class PlotFormat : std::uint8_t { kSvg, kPng };

/// The complete script for gnuplot, data included.
[[nodiscard]] std::string gnuplot_script(const Figure& figure, PlotFormat format, const std::string& output);

/// The figure drawn by gnuplot, a whole file. Throws Failure if gnuplot is not installed or fails.
[[nodiscard]] std::string draw_figure(const Figure& figure, PlotFormat format);

}  // namespace arcspan::tools
