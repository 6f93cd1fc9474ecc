// SPDX-License-Identifier: MIT
// An integer is not a number until from_raw says what it means.
#include <arcspan/numbers/fixed_formats.hpp>

using namespace arcspan;

Factor f(int a) { return a; }
