// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/command/unexpected.hpp>

#include <algorithm>
#include <numeric>

namespace arcspan::tools {
namespace {

/// How many letters have to be inserted, removed or replaced (Levenshtein's distance).
std::size_t letters_between(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j] ? 1 : 0);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::vector<std::string> long_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

}  // namespace

std::optional<std::string> closest_word(const std::string& word, const std::vector<std::string>& words) {
  constexpr std::size_t kMostLetters = 2;
  const auto closest = std::min_element(words.begin(), words.end(), [&](const auto& a, const auto& b) {
    return letters_between(word, a) < letters_between(word, b);
  });
  if (closest == words.end() || letters_between(word, *closest) > kMostLetters) return std::nullopt;
  return *closest;
}

std::optional<std::string> unexpected_argument(const CLI::App& app) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  const CLI::App& asked = given.empty() ? app : *given.front();
  const std::vector<std::string> extras = asked.remaining();
  if (extras.empty()) return std::nullopt;
  // If an option is unknown, the argument after it is often its value: the option is named.
  const auto option = std::find_if(extras.begin(), extras.end(),
                                   [](const std::string& extra) { return extra.starts_with("-"); });
  const std::string name = given.empty() ? "arcspan" : "arcspan " + asked.get_name();
  if (option == extras.end()) return extras.front() + ": one argument too many for " + name;
  const std::string typed = option->substr(0, option->find('='));
  const std::optional<std::string> meant = closest_word(typed, long_options(asked));
  return typed + ": no such option of " + name +
         (meant ? "; did you mean " + *meant + "?" : " (see " + name + " --help)");
}

}  // namespace arcspan::tools
