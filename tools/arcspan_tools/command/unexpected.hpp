// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace arcspan::tools {

/// Returns the one of `words` that differs from `word` by the fewest inserted, removed or replaced letters.
/// Nothing if those are more than two.
[[nodiscard]] std::optional<std::string> closest_word(const std::string& word,
                                                      const std::vector<std::string>& words);

/// Returns a message about an argument that the given subcommand, or `app` without one, does not take.
/// Nothing if it takes all of them.
[[nodiscard]] std::optional<std::string> unexpected_argument(const CLI::App& app);

}  // namespace arcspan::tools
