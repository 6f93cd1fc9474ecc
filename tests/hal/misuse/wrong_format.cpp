// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>
#include <arcspan/pixel/rgb565.hpp>

using namespace arcspan;
using namespace arcspan::hal;

Status wrong(Ssd1306& panel, const Framebuffer<Rgb565>& frame, std::span<std::uint8_t> wire) {
  return send_area(panel, frame, panel.bounds(), wire);  // one bit a pixel
}
