// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/spi_bus.hpp>

#include <cstdint>
#include <span>

namespace arcspan::lm3s6965 {

/// Switches on the clocks of SSI0 and of the ports A, C and D (LM3S6965 data sheet, 5.4: RCGC1, RCGC2).
void start_clocks();

/// SSI0 as SPI master, mode 0, 8 bits, on the pins PA2...PA5 (data sheet, 13). Bytes go out by polling, and
/// what comes back is dropped. kTimeout if the port does not take a byte within some thousand looks at it,
/// which only a stopped clock can bring about.
class Ssi final : public hal::SpiBus {
 public:
  /// The clocks must be on.
  Ssi();

 private:
  Status do_write(std::span<const std::uint8_t> bytes) override;
};

}  // namespace arcspan::lm3s6965
