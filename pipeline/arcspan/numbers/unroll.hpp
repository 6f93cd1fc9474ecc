// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstddef>
#include <utility>

namespace arcspan {

/// Calls f(i) for i = 0 ... Count - 1 without a loop, `i` being an integral_constant. Arrays that it indexes
/// can live in registers at any optimisation level.
template <std::size_t Count, class F>
ARCSPAN_INLINE constexpr void unrolled(F&& f) {
  [&f]<std::size_t... I>(std::index_sequence<I...>) { (f(std::integral_constant<std::size_t, I>{}), ...); }
  (std::make_index_sequence<Count>{});
}

}  // namespace arcspan
