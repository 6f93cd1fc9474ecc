// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/simulate/forecast.hpp>
#include <nlohmann/json.hpp>

#include <string>

namespace arcspan::tools {

/// For people, several lines.
[[nodiscard]] std::string to_text(const Forecast& forecast);

/// For machines.
[[nodiscard]] nlohmann::ordered_json to_json(const Forecast& forecast);

}  // namespace arcspan::tools
