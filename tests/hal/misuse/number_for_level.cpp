// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>

using namespace arcspan;
using namespace arcspan::hal;

Status wrong(OutputPin& pin) { return pin.set(1); }
