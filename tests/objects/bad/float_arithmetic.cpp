// SPDX-License-Identifier: MIT
// must be rejected by: float
float product(float a, float b) { return a * b; }
