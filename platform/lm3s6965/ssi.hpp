// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/spi_bus.hpp>

#include <cstdint>
#include <span>

namespace arcspan::lm3s6965 {

/// Enables the clocks of SSI0 and of ports A, C and D (LM3S6965 data sheet, 5.4: RCGC1, RCGC2).
void start_clocks();

/// SSI0 as SPI master, mode 0, 8 bits, on pins PA2 ... PA5 (data sheet, 13). It polls and discards received
/// bytes. kTimeout if the port does not accept a byte within 10,000 polls, which means that its clock is
/// stopped.
class Ssi final : public hal::SpiBus {
 public:
  /// Call start_clocks() first.
  Ssi();

 private:
  Status do_write(std::span<const std::uint8_t> bytes) override;
};

}  // namespace arcspan::lm3s6965
