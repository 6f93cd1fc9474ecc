// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/sim/wire_tap.hpp>

#include <string_view>

namespace arcspan::hal::sim {

/// Wires that expect a script (WireEvent) and answer as it says, for unit tests of drivers.
///
/// The first thing that is done otherwise is the difference; from then on every call fails with
/// kTransferFailed, so that a driver comes to an end. A test asks once, at its end:
///   CHECK(mock.finish() == "");
class MockWires final : public WireTap {
 public:
  /// A script that cannot be read is the difference.
  explicit MockWires(std::string_view script);

  /// "" as long as all was as expected; otherwise e.g.
  /// "line 3: expected 'data 00 00 00 ef', byte 4 (ef), but it was 'data f0'".
  [[nodiscard]] const std::string& difference() const { return difference_; }

  /// The difference, also if part of the script has not happened.
  [[nodiscard]] const std::string& finish();

 private:
  Status on(WireEvent& event) override;
  Status on_bytes(const WireEvent& event);
  Status on_delay(const WireEvent& event);
  Status on_whole(WireEvent& event);

  /// The event that is due; null at the end of the script.
  [[nodiscard]] const WireEvent* due() const { return next_ < events_.size() ? &events_[next_] : nullptr; }
  Status take();
  Status differ(const std::string& what);
  [[nodiscard]] std::string expectation() const;

  std::vector<WireEvent> events_;
  std::size_t next_ = 0;
  std::size_t done_bytes_ = 0;  ///< of the event that is due
  std::uint64_t done_us_ = 0;
  std::string difference_;
};

}  // namespace arcspan::hal::sim
