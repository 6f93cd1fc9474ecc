// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/morph_keys.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace arcspan::tools {

void fill_in_weights(std::vector<MorphKey>& keys) {
  const std::size_t targets = keys.empty() ? 0 : keys[0].mValue.size();
  for (std::size_t target = 0; target < targets; ++target) {
    const auto is_given = [target](const MorphKey& key) { return bool{key.is_given[target]}; };
    auto next = std::find_if(keys.begin(), keys.end(), is_given);
    if (next == keys.end()) continue;
    auto last = next;
    for (auto key = keys.begin(); key != keys.end(); ++key) {
      if (key == next) {
        last = key;
        const auto after = std::find_if(key + 1, keys.end(), is_given);
        if (after != keys.end()) next = after;
        continue;
      }
      const double span = next->mTime - last->mTime;
      const double share = span > 0 ? std::clamp((key->mTime - last->mTime) / span, 0.0, 1.0) : 0;
      key->mValue[target] = std::lerp(last->mValue[target], next->mValue[target], share);
    }
  }
}

}  // namespace arcspan::tools
