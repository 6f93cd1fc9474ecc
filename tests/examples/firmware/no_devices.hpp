// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/bare/console.hpp>
#include <arcspan/bare/stack.hpp>
#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/spi_bus.hpp>

#include <cstdint>

namespace arcspan::example {

/// Devices of emulators that have no panel: the bytes go to nobody.
struct NoDevices {
  class Pin final : public hal::OutputPin {
    Status do_set(hal::Level) override { return Status::kOk; }
  };
  class Time final : public hal::Clock {
    std::uint32_t do_now_us() override { return now_; }
    void do_delay_us(std::uint32_t us) override { now_ += us; }
    std::uint32_t now_ = 0;
  };

  Time clock;
  Pin data_or_command;
  hal::OutputPin* reset = nullptr;
  hal::SpiBus* bus = nullptr;

  void report(std::uint32_t bytes, std::uint32_t hash) const {
    bare::print_line("bytes: ", bytes, ", hash: ", hash);
    bare::print_line("stack: ", bare::deepest_stack(), " of ", bare::stack_size(), " bytes");
  }
};

}  // namespace arcspan::example
