// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/spi_bus.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <span>

namespace arcspan::hal {

/// A panel on a 4-wire serial interface: bytes sent with D/C low are commands, with D/C high parameters or
/// pixels.
///
/// D/C is driven before every transfer and its level is never remembered, so a transfer or a pin that failed
/// leaves nothing behind that the next call could trip over. Every call returns the first status that is not
/// kOk, of the pin or of the bus (see OutputPin::set, SpiBus), and sends nothing after it; kBusy, with D/C
/// untouched, while a transfer is under way: it would change the meaning of the bytes on the wire.
class CommandPort {
 public:
  constexpr CommandPort(SpiBus& bus, OutputPin& data_or_command) : bus_(bus), dc_(data_or_command) {}

  /// Sends `opcode` and then its `parameters`, of which there may be none. Blocks.
  Status command(std::uint8_t opcode, std::span<const std::uint8_t> parameters = {});

  /// Sends at least one byte of pixels. Blocks.
  Status data(std::span<const std::uint8_t> bytes);

  /// Begins to send at least one byte of pixels, which must stay unchanged until `bus()` tells the result.
  Status start_data(std::span<const std::uint8_t> bytes);

  [[nodiscard]] SpiBus& bus() { return bus_; }

 private:
  Status select(Level level);

  SpiBus& bus_;
  OutputPin& dc_;
};

}  // namespace arcspan::hal
