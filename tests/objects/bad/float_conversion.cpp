// SPDX-License-Identifier: MIT
// must be rejected by: float
// Nothing is computed in floating point here; the two conversions alone need helpers.
int stored(int level, volatile double& memory) {
  memory = level;
  return static_cast<int>(memory);
}
