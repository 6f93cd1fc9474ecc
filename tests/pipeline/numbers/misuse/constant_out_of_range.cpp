// SPDX-License-Identifier: MIT
// A constant out of its format's range does not compile.
#include <arcspan/numbers/formats.hpp>

using namespace arcspan;

constexpr Unit kTooLarge = Unit::of(2.0);
