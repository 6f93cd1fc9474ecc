// SPDX-License-Identifier: MIT
#include <arcspan_tools/counting/counters.hpp>
#include <arcspan_tools/shading_method_list.hpp>

namespace arcspan_counting {

// Each is defined by a translation unit of its own, which is count_method.hpp for this method.
#define ARCSPAN_DECLARE(name, Class, header) CountFunction count_##Class;
ARCSPAN_FOR_EACH_SHADING_METHOD(ARCSPAN_DECLARE)
#undef ARCSPAN_DECLARE

std::span<const Counter> counters() {
#define ARCSPAN_ENTRY(name, Class, header) {name, &count_##Class},
  static constexpr Counter kCounters[] = {ARCSPAN_FOR_EACH_SHADING_METHOD(ARCSPAN_ENTRY)};
#undef ARCSPAN_ENTRY
  return kCounters;
}

}  // namespace arcspan_counting
