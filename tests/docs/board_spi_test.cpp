// SPDX-License-Identifier: MIT
// The bus and the pin of docs/add-a-board.md, with plain memory in place of the registers.
#include "board_spi.hpp"

using namespace arcspan;

int main() {
  static volatile SpiRegisters spi{};
  PolledSpi bus(spi);
  const std::uint8_t bytes[] = {0x12, 0x34};
  spi.status = 1u << 1;  // empty, not busy
  if (bus.write(bytes) != Status::kOk || spi.data != 0x34) return 1;
  spi.status = (1u << 1) | (1u << 7);  // always busy
  if (bus.write(bytes) != Status::kTransferFailed) return 2;
  spi.status = 0;  // never empty
  if (bus.write(bytes) != Status::kTransferFailed) return 3;

  static volatile std::uint32_t set_reset = 0;
  PortPin pin(set_reset, 5);
  if (!ok(pin.set(hal::Level::kHigh)) || set_reset != 0x20) return 4;
  if (!ok(pin.set(hal::Level::kLow)) || set_reset != 0x200000) return 5;
  return 0;
}
