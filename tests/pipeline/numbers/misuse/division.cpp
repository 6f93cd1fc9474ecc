// SPDX-License-Identifier: MIT
// Division of fixed-point numbers does not compile: the span stage has none.
#include <arcspan/numbers/fixed_formats.hpp>

using namespace arcspan;

Factor f(Factor a, Factor b) { return a / b; }
