// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/bare/console.hpp>
#include <arcspan/bare/stack.hpp>
#include <arcspan/hal/panel/ili9341.hpp>

#include <tests/examples/checked_spi.hpp>

#include <cstdint>

namespace arcspan {

/// Stands for a board with a panel, on emulators that have none. Sends to nobody; prints a summary at the
/// end.
class Ili9341Board {
 public:
  Ili9341Board() = default;
  Ili9341Board(const Ili9341Board&) = delete;
  Ili9341Board& operator=(const Ili9341Board&) = delete;
  ~Ili9341Board() {
    bare::print_line("bytes: ", bus_.bytes(), ", hash: ", bus_.hash());
    bare::print_line("stack: ", bare::deepest_stack(), " of ", bare::stack_size(), " bytes");
  }

  Status start() { return panel_.start(); }
  [[nodiscard]] hal::Ili9341& panel() { return panel_; }

 private:
  class NoPin final : public hal::OutputPin {
    Status do_set(hal::Level) override { return Status::kOk; }
  };
  class NoTime final : public hal::Clock {
    std::uint32_t do_now_us() override { return now_; }
    void do_delay_us(std::uint32_t us) override { now_ += us; }
    std::uint32_t now_ = 0;
  };

  NoTime clock_;
  NoPin data_or_command_;
  example::CheckedSpi bus_;
  hal::Ili9341 panel_{bus_, data_or_command_, nullptr, clock_};
};

}  // namespace arcspan
