// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/bench/measure.hpp>

#include <string>

namespace arcspan::tools {

/// Tables for people: a scene a row, from small to large triangles.
[[nodiscard]] std::string bench_markdown(const BenchReport& report);

/// Everything, for machines.
[[nodiscard]] std::string bench_json(const BenchReport& report);

}  // namespace arcspan::tools
