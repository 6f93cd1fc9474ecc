// SPDX-License-Identifier: MIT
// Nothing converts by itself from one format to another.
#include <arcspan/numbers/fixed_formats.hpp>

using namespace arcspan;

Factor f(Cosine a) { return a; }
