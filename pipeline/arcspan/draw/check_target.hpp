// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/scissor.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

namespace arcspan::detail {

/// Returns the reason why nothing can be drawn into a sink and a depth buffer, or kOk.
template <class Sink, class Depth>
[[nodiscard]] constexpr Status check_target(const Scissor& scissor, const Sink& sink, const Depth& depth) {
  if constexpr (ChecksItself<Sink>) {
    if (!ok(sink.status())) return sink.status();
  }
  if constexpr (Depth::kTests) {
    if (!ok(depth.status())) return depth.status();
    if (!scissor.is_within(depth.bounds())) return Status::kDepthMismatch;
  }
  return Status::kOk;
}

}  // namespace arcspan::detail
