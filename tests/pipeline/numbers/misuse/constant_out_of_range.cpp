// SPDX-License-Identifier: MIT
// A constant out of its format's range does not compile.
#include <arcspan/numbers/fixed_formats.hpp>

using namespace arcspan;

constexpr Cosine kTooLarge = Cosine::of(2.0);
