// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/checked.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan::detail {

/// Whether the memory of a depth buffer was cleared, in builds with ARCSPAN_CHECKED. In others it is empty.
class DepthChecks {
 public:
  constexpr void note_move() { state_.set(kMoved); }
  constexpr void note_clear() { state_.set(kCleared); }

  /// Reports memory that was not cleared, once. Drawing leaves depths of 256 and more, so that memory with
  /// zeros and without anything farthest never was.
  constexpr void check([[maybe_unused]] std::span<const std::uint16_t> depths) {
    if constexpr (kIsChecked) {
      if (state_.get() == kCleared) return;
      [[maybe_unused]] std::size_t zeros = 0;
      [[maybe_unused]] std::size_t farthest = 0;
      for (const std::uint16_t depth : depths) {
        if (depth == 0) ++zeros;
        if (depth == 0xFFFF) ++farthest;
      }
      [[maybe_unused]] const bool moved = state_.get() == kMoved;
      ARCSPAN_CHECK(!moved || farthest == depths.size(),
                    "draw: the depth buffer was moved to another band, but not cleared");
      ARCSPAN_CHECK(moved || zeros == 0 || farthest > 0, "draw: the depth buffer was never cleared");
      state_.set(kCleared);
    }
  }

 private:
  static constexpr unsigned kMoved = 1;
  static constexpr unsigned kCleared = 2;

  [[no_unique_address]] CheckedState state_{};
};

}  // namespace arcspan::detail
