// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/input_pin.hpp>
#include <arcspan/hal/spi_bus.hpp>

namespace arcspan::hal {

/// How a display says that it takes no bytes.
struct BusyLine {
  Level busy = Level::kHigh;           ///< what the wire carries while it does not
  std::uint32_t limit_us = 1'000'000;  ///< a device that is busy for longer is given up, 0 ... 2^31 - 1
};

/// An SPI bus to a display with a busy line: no transfer begins before the line says that it is over.
///
/// None of the panels here has such a line; bridge controllers and modules with a controller of their own do,
/// and every driver of this library works on this bus as on any other. Statuses are those of SpiBus, and of
/// the line: kTimeout if the display stays busy for longer than the limit, kTransferFailed if the line cannot
/// be read. Nothing is sent then. `start` may block for as long as the limit.
class BusyLineSpi final : public SpiBus {
 public:
  /// Everything referred to must outlive this.
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
