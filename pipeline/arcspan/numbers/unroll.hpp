// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>

namespace arcspan {

/// Calls f(i) for i = 0 ... Count - 1, written out: what it indexes can live in registers at any -O level.
template <std::size_t Count, class F>
constexpr void unrolled(F&& f) {
  [&f]<std::size_t... I>(std::index_sequence<I...>) { (f(std::integral_constant<std::size_t, I>{}), ...); }
  (std::make_index_sequence<Count>{});
}

}  // namespace arcspan
