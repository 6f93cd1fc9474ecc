// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/bare/registers.hpp>
#include <arcspan/hal/output_pin.hpp>

#include <cstdint>

namespace arcspan::lm3s6965 {

/// Base addresses of GPIO ports (LM3S6965 data sheet, table 8-8).
enum class Port : std::uint32_t { kA = 0x40004000, kC = 0x40006000, kD = 0x40007000 };

/// A push-pull output, initially low. Call start_clocks() first. Setting it cannot fail.
class PortPin final : public hal::OutputPin {
 public:
  /// `bit`: 0 ... 7.
  PortPin(Port port, unsigned bit) : base_(static_cast<std::uint32_t>(port)), mask_(1u << bit) {
    bare::set_bits(base_ + kDirection, mask_);
    bare::set_bits(base_ + kDigitalEnable, mask_);
    drive(false);
  }

 private:
  Status do_set(hal::Level level) override {
    drive(level == hal::Level::kHigh);
    return Status::kOk;
  }
  /// Bits 9 ... 2 of the data register's address select the pins to change (8.2.1.2), so other pins keep
  /// their level.
  void drive(bool high) { bare::reg32(base_ + (mask_ << 2)) = high ? mask_ : 0u; }

  static constexpr std::uint32_t kDirection = 0x400;
  static constexpr std::uint32_t kDigitalEnable = 0x51C;

  std::uint32_t base_;
  std::uint32_t mask_;
};

}  // namespace arcspan::lm3s6965
