// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/st7789.hpp>

#include <tests/examples/checked_board.hpp>
#include <tests/examples/host/simulated_devices.hpp>

namespace arcspan {

struct St7789Devices : example::SimulatedDevices {
  St7789Devices() : SimulatedDevices(hal::kSt7789Module) {}
};
using St7789Board = example::CheckedBoard<hal::St7789, St7789Devices>;

}  // namespace arcspan
