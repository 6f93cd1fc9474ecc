// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace arcspan::tools {

/// A key of an animation of morph targets, with names as the loader library's other keys have them.
struct MorphKey {
  double mTime;
  std::vector<double> mValue;  ///< the weight of each target
  std::vector<bool> is_given;  ///< for each target, whether the file has its weight at this time
};

/// Sets the weights that are not given, at the keys of other targets: between the target's own keys by linear
/// interpolation, before the first and after the last as there. A target without a key keeps its weights.
void fill_in_weights(std::vector<MorphKey>& keys);

}  // namespace arcspan::tools
