// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/counting/count_job.hpp>

#include <span>
#include <string_view>

namespace arcspan_counting {

/// A shading method in the pipeline that counts.
struct Counter {
  std::string_view shading;
  CountFunction* function;
};

/// One counter for each entry of shading_method_list.hpp, in its order.
[[nodiscard]] std::span<const Counter> counters();

}  // namespace arcspan_counting
