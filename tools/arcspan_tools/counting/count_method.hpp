// SPDX-License-Identifier: MIT
// The counter of one shading method's operations. The build compiles this file once for each entry of
// shading_method_list.hpp, with ARCSPAN_METHOD and ARCSPAN_METHOD_HEADER defined.
// No #pragma once: a source may hold several methods.

#include <arcspan_tools/counting/begin_counted.hpp>
//
#include <arcspan/draw.hpp>
#include ARCSPAN_METHOD_HEADER
//
#include <arcspan_tools/counting/end_counted.hpp>
//
#include <arcspan_tools/counting/count_with.hpp>
#include <arcspan_tools/shading_method_list.hpp>

namespace arcspan_counting {

CountFunction ARCSPAN_METHOD_FUNCTION(count, ARCSPAN_METHOD);

CountedDraw ARCSPAN_METHOD_FUNCTION(count, ARCSPAN_METHOD)(const CountJob& job) {
  return count_with<arcspan_counted::ARCSPAN_METHOD>(job);
}

}  // namespace arcspan_counting
