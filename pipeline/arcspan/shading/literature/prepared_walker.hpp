// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/restarted_run.hpp>

#include <type_traits>

namespace arcspan {

/// Row walker of a method whose prepared part goes down the rows itself, by next_row() and enter_lower().
/// `MethodRun::of_row(prepared, start)` makes the run of a row, or of a part of it if the run has a length()
/// (RestartedRun).
template <class Prepared, class MethodRun>
class PreparedWalker {
 public:
  static constexpr bool kRestarts = requires(const MethodRun& run) { run.length(); };
  using Run =
      typename std::conditional_t<kRestarts, std::type_identity<RestartedRun<PreparedWalker, MethodRun>>,
                                  std::type_identity<MethodRun>>::type;
  constexpr explicit PreparedWalker(Prepared& prepared) : prepared_(&prepared) {}
  [[nodiscard]] constexpr MethodRun start_run(const RowStart& start) const {
    return MethodRun::of_row(*prepared_, start);
  }
  [[nodiscard]] constexpr Run row(const RowStart& start) const {
    if constexpr (kRestarts) {
      return Run(*this, start);
    } else {
      return start_run(start);
    }
  }
  constexpr void next_row() { prepared_->next_row(); }
  constexpr void enter_lower() { prepared_->enter_lower(); }

 private:
  Prepared* prepared_;
};

}  // namespace arcspan
