// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/sim/wire_tap.hpp>

namespace arcspan::hal::sim {

/// Wires that write down what is done to them, as a script that MockWires can replay.
///
/// Alone, they take everything and input pins are low. What is attached to one of them, a real device or a
/// simulated one, gets all that is done to it, and its answers are passed on and written down.
class WireRecorder final : public WireTap {
 public:
  WireRecorder() = default;

  void attach(SpiBus& bus) { spi_.attached = &bus; }
  void attach(I2cBus& bus) { i2c_.attached = &bus; }
  void attach(Clock& clock) { clock_.attached = &clock; }
  void attach(const std::string& name, OutputPin& pin);
  void attach(const std::string& name, InputPin& pin);

  /// What has happened so far; bytes with the same D/C level, and delays, that follow each other are joined.
  [[nodiscard]] const std::vector<WireEvent>& events() const { return events_; }
  [[nodiscard]] std::string script() const { return to_script(events_); }
  void forget() { events_.clear(); }

 private:
  Status on(WireEvent& event) override;
  std::vector<WireEvent> events_;
};

}  // namespace arcspan::hal::sim
