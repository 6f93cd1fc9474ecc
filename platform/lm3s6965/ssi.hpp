// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace arcspan::lm3s6965 {

/// Switches on the clocks of SSI0 and of the ports A, C and D (LM3S6965 data sheet, 5.4: RCGC1, RCGC2).
void start_clocks();

/// SSI0 as SPI master, mode 0, 8 bits, on the pins PA2...PA5 (data sheet, 13).
class Ssi {
 public:
  /// The clocks must be on.
  Ssi();
  /// Sends the bytes and returns when the last bit is out; what comes back is dropped. Blocks as long as it
  /// takes.
  void write(std::span<const std::uint8_t> bytes);
};

}  // namespace arcspan::lm3s6965
