// SPDX-License-Identifier: MIT
#include <arcspan_tools/counting/begin_counted.hpp>
//
#include <arcspan/draw.hpp>

#include <tests/artefacts/dichotomy_variants.hpp>
//
#include <arcspan_tools/counting/end_counted.hpp>
//
#include <arcspan_tools/counting/count_with.hpp>

namespace arcspan_counting {

#define ARCSPAN_COUNT(name, Class)                                                \
  CountFunction count_##Class;                                                    \
  CountedDraw count_##Class(const CountJob& job) {                                \
    return count_lit<arcspan_counted::Class, 1, counted::Highlight::kBlinn>(job); \
  }
ARCSPAN_FOR_EACH_DICHOTOMY_VARIANT(ARCSPAN_COUNT)
#undef ARCSPAN_COUNT

}  // namespace arcspan_counting
