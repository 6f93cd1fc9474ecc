// SPDX-License-Identifier: MIT
// Formats do not mix.
#include <arcspan/numbers/formats.hpp>

using namespace arcspan;

Factor f(Factor a, Unit b) { return a + b; }
