// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>
#include <arcspan/pixel/mono.hpp>

using namespace arcspan;
using namespace arcspan::hal;

// The control: all that the others do wrong, done right.
Status right(Ssd1306& panel, const Framebuffer<Mono>& frame, std::span<std::uint8_t> wire, SpiBus& bus,
             OutputPin& pin, Clock& clock) {
  Ili9341 colour(bus, pin, &pin, clock);
  const Status status = colour.start();
  return ok(status) ? send_area(panel, frame, panel.bounds(), wire) : status;
}
