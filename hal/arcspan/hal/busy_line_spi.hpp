// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/input_pin.hpp>
#include <arcspan/hal/spi_bus.hpp>

namespace arcspan::hal {

/// Busy line of a display: its active level, and how long to wait for it.
struct BusyLine {
  Level busy = Level::kHigh;           ///< level while the display accepts no bytes
  std::uint32_t limit_us = 1'000'000;  ///< longest wait for the line, 0 ... 2^31 - 1
};

/// An SPI bus to a display with a busy line, which every transfer first waits for. Drivers use it as any
/// other bus.
///
/// If the display stays busy for longer than `limit_us`, calls return kTimeout, and if the line cannot be
/// read, kTransferFailed. Nothing is sent then. `start` may block for `limit_us`. No controller supported
/// here has a busy line; bridge controllers have one.
class BusyLineSpi final : public SpiBus {
 public:
  /// All referenced objects must outlive this one.
  constexpr BusyLineSpi(SpiBus& bus, InputPin& pin, Clock& clock, const BusyLine& line = {})
      : bus_(bus), pin_(pin), clock_(clock), line_(line) {}

 private:
  Status do_write(std::span<const std::uint8_t> bytes) override;
  Status do_start(std::span<const std::uint8_t> bytes) override;
  Status do_poll() override { return bus_.poll(); }
  void do_abort() override;
  Status wait_until_ready();

  SpiBus& bus_;
  InputPin& pin_;
  Clock& clock_;
  BusyLine line_;
};

}  // namespace arcspan::hal
