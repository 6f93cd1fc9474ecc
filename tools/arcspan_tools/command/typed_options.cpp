// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/support/parse.hpp>
#include <arcspan_tools/support/text.hpp>

namespace arcspan::tools {

void add_number(CLI::App& app, const std::string& name, const std::string& help, double least, double most,
                double& value) {
  const auto short_text = [](double v) {
    std::string text = std::to_string(v);
    text.erase(text.find_last_not_of('0') + 1);
    return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
  };
  const std::string range = short_text(least) + "..." + short_text(most);
  add_parsed<double>(
      app, name, range, help + " (default " + short_text(value) + ")", "a number " + range,
      [least, most](const std::string& text) {
        const std::optional<double> v = parse_number(text);
        return v && *v >= least && *v <= most ? v : std::nullopt;
      },
      [&value](double v) { value = v; });
}

void add_integer(CLI::App& app, const std::string& name, const std::string& type, const std::string& help,
                 std::int32_t least, std::int32_t most, std::int32_t& value) {
  add_parsed<std::int32_t>(
      app, name, type, help, "an integer " + std::to_string(least) + "..." + std::to_string(most),
      [least, most](const std::string& text) -> std::optional<std::int32_t> {
        const std::optional<std::int64_t> v = parse_integer(text);
        if (!v || *v < least || *v > most) return std::nullopt;
        return static_cast<std::int32_t>(*v);
      },
      [&value](std::int32_t v) { value = v; });
}

void add_choice(CLI::App& app, const std::string& name, const std::string& help,
                const std::vector<std::string>& choices, std::string& value) {
  const std::string all = joined(choices, "|");
  add_parsed<std::string>(
      app, name, all, help + " (default " + value + ")", all,
      [choices](const std::string& text) -> std::optional<std::string> {
        for (const std::string& choice : choices) {
          if (choice == text) return text;
        }
        return std::nullopt;
      },
      [&value](const std::string& v) { value = v; });
}

}  // namespace arcspan::tools
