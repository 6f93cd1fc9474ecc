// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/method.hpp>

#include <cstdint>

namespace arcspan {

/// The pixels of a row by one run after another (PiecewiseRun). `Inner` is the type of these runs; its
/// length() is the number of pixels after which the row needs a new one, at least 1. `Walker` has
/// start_run(start), which returns the Inner that begins at a pixel.
template <class Walker, class Inner>
class RestartedRun : public Inner {
 public:
  /// The walker must outlive the run.
  constexpr RestartedRun(const Walker& walker, const RowStart& start)
      : Inner(walker.start_run(start)), walker_(&walker), next_(start) {}

  template <class Lighting>
  [[nodiscard]] constexpr std::int32_t enter(const Lighting&, std::int32_t left) {
    if (is_started_) static_cast<Inner&>(*this) = walker_->start_run(next_);
    is_started_ = true;
    const std::int32_t count = left < Inner::length() ? left : Inner::length();
    next_ = next_.moved(count);
    return count;
  }

 private:
  const Walker* walker_;
  RowStart next_;  ///< of the next run
  bool is_started_ = false;
};

}  // namespace arcspan
