// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <type_traits>

namespace arcspan::detail {

/// Changes the light of a method's `lighting` and keeps the rest, where possible without a copy of 2 KB on
/// the stack.
template <class Lighting, class L>
constexpr void relight(Lighting& lighting, const L& light) {
  if constexpr (requires { lighting.relight(light); }) {
    lighting.relight(light);
  } else if constexpr (std::is_same_v<Lighting, L>) {
    lighting = light;
  } else {
    lighting = Lighting(light);
  }
}

}  // namespace arcspan::detail
