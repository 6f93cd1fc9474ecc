// SPDX-License-Identifier: MIT
// Formats do not mix.
#include <arcspan/numbers/fixed_formats.hpp>

using namespace arcspan;

Factor f(Factor a, Cosine b) { return a + b; }
