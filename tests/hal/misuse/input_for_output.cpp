// SPDX-License-Identifier: MIT
#include <arcspan/hal/input_pin.hpp>
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>

using namespace arcspan;
using namespace arcspan::hal;

void wrong(SpiBus& bus, InputPin& busy, Clock& clock) {
  Ili9341 panel(bus, busy, nullptr, clock);
  (void)panel;
}
