// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace arcspan::tools {

/// What a file has and a picture does not need, counted by kind.
///
/// The rule for whatever cannot be drawn: a picture needs faces, and the positions that they use; without
/// them reading ends with a Failure that names the place. Everything else is left out, and counted here.
class LeftOut {
 public:
  void add(const std::string& kind, std::size_t count = 1) { counts_[kind] += count; }

  /// Adds a line about all kinds to `warnings`, if there are any.
  void warn(std::vector<std::string>& warnings) const {
    constexpr std::size_t kMostListed = 12;
    std::string line;
    std::size_t listed = 0;
    for (const auto& [kind, count] : counts_) {
      if (count == 0) continue;
      line += listed == 0 ? "left out: " : ", ";
      line += listed == kMostListed ? "..." : kind + " (" + std::to_string(count) + ")";
      if (listed++ == kMostListed) break;
    }
    if (listed > 0) warnings.push_back(line);
  }

 private:
  std::map<std::string, std::size_t> counts_;
};

}  // namespace arcspan::tools
