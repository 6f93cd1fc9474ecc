// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/st7789.hpp>

#include <tests/examples/checked_board.hpp>
#include <tests/examples/firmware/no_devices.hpp>

namespace arcspan {

using St7789Board = example::CheckedBoard<hal::St7789, example::NoDevices>;

}  // namespace arcspan
