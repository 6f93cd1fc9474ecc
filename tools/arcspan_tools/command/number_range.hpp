// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <string>

namespace arcspan::tools {

/// Checks that an option's text is a number `least` ... `most`, which `range` writes. Unlike CLI::Range it
/// refuses "nan".
[[nodiscard]] inline CLI::Validator number_range(double least, double most, const std::string& range) {
  const auto check = [=](const std::string& text) {
    const std::optional<double> value = parse_number(text);
    if (value && *value >= least && *value <= most) return std::string();
    return "expected a number " + range + ", not '" + text + "'";
  };
  return CLI::Validator(check, "");
}

}  // namespace arcspan::tools
