// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/spi_bus.hpp>

namespace arcspan::test {

/// What a panel hangs on.
struct BoardWires {
  hal::SpiBus& spi;
  hal::OutputPin& data_or_command;
  hal::OutputPin& reset;
  hal::OutputPin& backlight;
  hal::Clock& clock;
};

/// Resets a panel, sends it one shaded frame, lights it, and puts it to sleep. The first status that is not
/// kOk.
[[nodiscard]] Status send_frame(const BoardWires& wires);

}  // namespace arcspan::test
