// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// How many pixels of a run are taken at once where the machine has vectors: 8 by default on hosts with
// 128-bit ones, 1 elsewhere: small cores get the plain loop and no table. Define ARCSPAN_LANES to choose (1
// or 8), the same for the whole program. The pixels are the same.
#ifndef ARCSPAN_LANES
#if defined(__SSE2__) || (defined(__aarch64__) && defined(__ARM_NEON))
#define ARCSPAN_LANES 8
#else
#define ARCSPAN_LANES 1
#endif
#endif

namespace arcspan {

inline constexpr std::int32_t kHostLanes = ARCSPAN_LANES;
static_assert(kHostLanes == 1 || kHostLanes == 8);

/// Pixels at once for a sink: its own choice (kLanes) if it has one.
template <class Sink>
[[nodiscard]] consteval std::int32_t lanes_for() {
  if constexpr (requires { Sink::kLanes; }) {
    return Sink::kLanes;
  } else {
    return kHostLanes;
  }
}

}  // namespace arcspan
