// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/sim/wire_tap.hpp>

#include <string_view>

namespace arcspan::hal::sim {

/// Mock wires for unit tests of drivers: they expect the events of a script (WireEvent) and answer as it
/// says.
///
/// The first deviation is recorded as the difference. From then on every call fails with kTransferFailed, so
/// that the driver stops. A test checks once at its end:
///   CHECK(mock.finish() == "");
class MockWires final : public WireTap {
 public:
  /// If the script cannot be parsed, the parse error is the difference.
  explicit MockWires(std::string_view script);

  /// "" if everything was as expected; otherwise for example
  /// "line 3: expected 'data 00 00 00 ef', byte 4 (ef), but it was 'data f0'".
  [[nodiscard]] const std::string& difference() const { return difference_; }

  /// As difference(), but events that are still expected count as a difference, too.
  [[nodiscard]] const std::string& finish();

 private:
  Status on(WireEvent& event) override;
  Status on_bytes(const WireEvent& event);
  Status on_delay(const WireEvent& event);
  Status on_whole(WireEvent& event);

  /// The next expected event, or null at the end of the script.
  [[nodiscard]] const WireEvent* due() const { return next_ < events_.size() ? &events_[next_] : nullptr; }
  Status take();
  Status differ(const std::string& what);
  [[nodiscard]] std::string expectation() const;

  std::vector<WireEvent> events_;
  std::size_t next_ = 0;
  std::size_t done_bytes_ = 0;  ///< of the next expected event
  std::uint64_t done_us_ = 0;
  std::string difference_;
};

}  // namespace arcspan::hal::sim
