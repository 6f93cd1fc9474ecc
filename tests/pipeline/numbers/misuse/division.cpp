// SPDX-License-Identifier: MIT
// Division of fixed-point numbers does not compile: the span stage has none.
#include <arcspan/numbers/formats.hpp>

using namespace arcspan;

Factor f(Factor a, Factor b) { return a / b; }
