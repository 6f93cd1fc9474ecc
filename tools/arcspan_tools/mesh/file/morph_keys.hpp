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

/// Sets the weights that are not given: between two keys of the target by linear interpolation, before its
/// first and after its last to the weight of that key. A target without a key keeps its weights.
void fill_in_weights(std::vector<MorphKey>& keys);

}  // namespace arcspan::tools
