// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace arcspan::tools {

/// That of `words` which `word` was probably meant to be: at most two letters are missing, too many or
/// others.
[[nodiscard]] std::optional<std::string> closest_word(const std::string& word,
                                                      const std::vector<std::string>& words);

/// Says what the first argument is that `app`, or the subcommand that was given, does not take. Nothing if it
/// takes all of them.
[[nodiscard]] std::optional<std::string> unexpected_argument(const CLI::App& app);

}  // namespace arcspan::tools
