// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/sim/wire_tap.hpp>

namespace arcspan::hal::sim {

/// Wires that record what a driver does to them, as a script that MockWires can replay.
///
/// By default every call succeeds and input pins are low. A bus, pin or clock that is attached, real or
/// simulated, receives every call as well, and its answers are returned and recorded. Attached objects must
/// outlive the recorder.
class WireRecorder final : public WireTap {
 public:
  WireRecorder() = default;

  void attach(SpiBus& bus) { spi_.attached = &bus; }
  void attach(I2cBus& bus) { i2c_.attached = &bus; }
  void attach(Clock& clock) { clock_.attached = &clock; }
  void attach(const std::string& name, OutputPin& pin);
  void attach(const std::string& name, InputPin& pin);

  /// Events so far. Successive bytes with the same D/C level are joined, and so are successive delays.
  [[nodiscard]] const std::vector<WireEvent>& events() const { return events_; }
  [[nodiscard]] std::string script() const { return to_script(events_); }
  void forget() { events_.clear(); }

 private:
  Status on(WireEvent& event) override;
  std::vector<WireEvent> events_;
};

}  // namespace arcspan::hal::sim
