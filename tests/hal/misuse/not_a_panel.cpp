// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>
#include <arcspan/pixel/mono.hpp>

using namespace arcspan;
using namespace arcspan::hal;

struct Nothing {};
Status wrong(Nothing& panel, const Framebuffer<Mono>& frame, std::span<std::uint8_t> wire) {
  return send_area(panel, frame, {0, 0, 8, 8}, wire);
}
