// SPDX-License-Identifier: MIT
// Everything of the pipeline that is included between this file and end_counted.hpp is compiled with integers
// that count what is done to them, in the namespace arcspan_counted. No #pragma once: these are brackets.
#include <arcspan_tools/counting/counted_std.hpp>

#undef ARCSPAN_CHECKED  // the same library serves all builds
#define arcspan arcspan_counted
#define std arcspan_counted_std

#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/numbers/root.hpp>
// Each of these counts as one division or one root, whatever it is made of.
#define ARCSPAN_AS_ONE(kind, call) \
  ::arcspan_counting::count_as_one(::arcspan_counting::Operation::kind, [&] { return call; })
#define reciprocal(...) ARCSPAN_AS_ONE(kDivide, reciprocal(__VA_ARGS__))
#define wide_reciprocal(...) ARCSPAN_AS_ONE(kDivide, wide_reciprocal(__VA_ARGS__))
#define integer_root(...) ARCSPAN_AS_ONE(kRoot, integer_root(__VA_ARGS__))
#define reciprocal_root(...) ARCSPAN_AS_ONE(kRoot, reciprocal_root(__VA_ARGS__))
