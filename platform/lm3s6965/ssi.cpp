// SPDX-License-Identifier: MIT
#include "ssi.hpp"

#include <arcspan/bare/registers.hpp>

namespace arcspan::lm3s6965 {
namespace {

using bare::reg32;
using bare::set_bits;

constexpr std::uint32_t kRunModeClocks1 = 0x400FE104;
constexpr std::uint32_t kRunModeClocks2 = 0x400FE108;
constexpr std::uint32_t kSsi0Clock = 1u << 4;
constexpr std::uint32_t kPortClocksAcd = 0xD;
constexpr std::uint32_t kPortA = 0x40004000;
constexpr std::uint32_t kAlternateFunction = kPortA + 0x420;
constexpr std::uint32_t kDigitalEnable = kPortA + 0x51C;
constexpr std::uint32_t kSsiPins = 0x3C;  // PA2 clock, PA3 frame, PA4 receive, PA5 transmit

constexpr std::uint32_t kControl0 = 0x40008000;
constexpr std::uint32_t kControl1 = 0x40008004;
constexpr std::uint32_t kData = 0x40008008;
constexpr std::uint32_t kStatus = 0x4000800C;
constexpr std::uint32_t kPrescale = 0x40008010;
constexpr std::uint32_t kEightBits = 7;
constexpr std::uint32_t kEnable = 2;
constexpr std::uint32_t kTransmitNotFull = 2;
constexpr std::uint32_t kReceiveNotEmpty = 4;
constexpr std::uint32_t kBusy = 0x10;

void drop_received() {
  while ((reg32(kStatus) & kReceiveNotEmpty) != 0) {
    [[maybe_unused]] const std::uint32_t dropped = reg32(kData);
  }
}

// The least even divisor that keeps the bus within the 4 MHz of the SSD0323, whatever the internal oscillator
// runs at: 12 MHz +-30 % (5.2.4), so that it is 2.1 to 3.9 MHz.
constexpr std::uint32_t kPrescaler = 4;
static_assert(15'600'000 / kPrescaler <= 4'000'000);

// The FIFO of 8 bytes drains within 256 processor clocks.
constexpr int kMostLooks = 10'000;

[[nodiscard]] bool wait_for(std::uint32_t mask, std::uint32_t wanted) {
  for (int i = 0; i < kMostLooks; ++i) {
    if ((reg32(kStatus) & mask) == wanted) return true;
  }
  return false;
}

}  // namespace

void start_clocks() {
  set_bits(kRunModeClocks1, kSsi0Clock);
  set_bits(kRunModeClocks2, kPortClocksAcd);
}

Ssi::Ssi() {
  set_bits(kAlternateFunction, kSsiPins);
  set_bits(kDigitalEnable, kSsiPins);
  reg32(kControl1) = 0;  // the port must be disabled while it is set up (13.3)
  reg32(kPrescale) = kPrescaler;
  reg32(kControl0) = kEightBits;
  reg32(kControl1) = kEnable;
}

Status Ssi::do_write(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    if (!wait_for(kTransmitNotFull, kTransmitNotFull)) return Status::kTimeout;
    reg32(kData) = byte;
    drop_received();
  }
  if (!wait_for(kBusy, 0)) return Status::kTimeout;
  drop_received();
  return Status::kOk;
}

}  // namespace arcspan::lm3s6965
