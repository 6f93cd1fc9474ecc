// SPDX-License-Identifier: MIT
// The control: what is right compiles, so that the others fail for their own reason.
#include <arcspan/numbers/fixed_formats.hpp>

using namespace arcspan;

constexpr Cosine kFits = Cosine::of(1.5);
Factor f(Factor a, Factor b) { return multiply<Factor>(a, b) + convert<Factor>(kFits); }
