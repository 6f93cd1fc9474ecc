// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/spi_bus.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <span>

namespace arcspan::hal {

/// 4-wire SPI port of a panel: D/C is low for command bytes, high for parameters and pixels.
///
/// Every transfer sets D/C first, so a failure has no effect on the next call. Every call returns the first
/// failure of the pin or the bus (OutputPin::set, SpiBus) and then sends nothing more. While a transfer is
/// under way it returns kBusy and leaves D/C alone, because a change would reinterpret the bytes being sent.
class CommandPort {
 public:
  constexpr CommandPort(SpiBus& bus, OutputPin& data_or_command) : bus_(bus), dc_(data_or_command) {}

  /// Sends `opcode` and its `parameters`, which may be empty. Blocks.
  Status command(std::uint8_t opcode, std::span<const std::uint8_t> parameters = {});

  /// Sends pixels, at least one byte. Blocks.
  Status data(std::span<const std::uint8_t> bytes);

  /// Begins to send pixels, at least one byte. The caller keeps `bytes` unchanged until bus() reports the
  /// result.
  Status start_data(std::span<const std::uint8_t> bytes);

  [[nodiscard]] SpiBus& bus() { return bus_; }

 private:
  Status select(Level level);

  SpiBus& bus_;
  OutputPin& dc_;
};

}  // namespace arcspan::hal
