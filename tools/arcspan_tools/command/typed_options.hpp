// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Adds an option whose text `parse` turns into a value; nothing means that it is not `expected`. Given
/// twice, the last counts. Messages call an option of several names, with commas between them, by its first.
template <class T>
void add_parsed(CLI::App& app, const std::string& name, const std::string& type, const std::string& help,
                const std::string& expected, std::function<std::optional<T>(const std::string&)> parse,
                std::function<void(const T&)> use) {
  const auto take = [first = name.substr(0, name.find(',')), expected, parse, use](const std::string& text) {
    const std::optional<T> value = parse(text);
    if (!value) throw CLI::ValidationError(first, "expected " + expected + ", not '" + text + "'");
    use(*value);
  };
  app.add_option_function<std::string>(name, take, help)
      ->type_name(type)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

/// A number from `least` to `most`; the help ends with the default, which is what `value` holds.
void add_number(CLI::App& app, const std::string& name, const std::string& help, double least, double most,
                double& value);

/// An integer from `least` to `most`; `type` stands for it in the help.
void add_integer(CLI::App& app, const std::string& name, const std::string& type, const std::string& help,
                 std::int32_t least, std::int32_t most, std::int32_t& value);

/// One of `choices`.
void add_choice(CLI::App& app, const std::string& name, const std::string& help,
                const std::vector<std::string>& choices, std::string& value);

}  // namespace arcspan::tools
