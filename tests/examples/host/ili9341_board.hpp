// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/ili9341.hpp>

#include <tests/examples/checked_board.hpp>
#include <tests/examples/host/simulated_devices.hpp>

namespace arcspan {

struct Ili9341Devices : example::SimulatedDevices {
  Ili9341Devices() : SimulatedDevices(hal::kIli9341Module) {}
};
using Ili9341Board = example::CheckedBoard<hal::Ili9341, Ili9341Devices>;

}  // namespace arcspan
