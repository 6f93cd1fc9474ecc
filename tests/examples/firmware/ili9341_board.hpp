// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/ili9341.hpp>

#include <tests/examples/checked_board.hpp>
#include <tests/examples/firmware/no_devices.hpp>

namespace arcspan {

using Ili9341Board = example::CheckedBoard<hal::Ili9341, example::NoDevices>;

}  // namespace arcspan
