// SPDX-License-Identifier: MIT
// Nothing converts by itself from one format to another.
#include <arcspan/numbers/formats.hpp>

using namespace arcspan;

Factor f(Unit a) { return a; }
