// SPDX-License-Identifier: MIT
// The templates of hal/ for every format: their code is inspected, too.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/ssd0323.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>
#include <arcspan/hal/panel/ssd1351.hpp>
#include <arcspan/hal/panel/st7789.hpp>
#include <arcspan/pixel/pixel_format_list.hpp>

namespace arcspan::hal {

#define ARCSPAN_INSTANTIATE(name, Format) \
  template class Framebuffer<Format>;     \
  template class FramebufferWindow<Format>;
ARCSPAN_FOR_EACH_PIXEL_FORMAT(ARCSPAN_INSTANTIATE)
#undef ARCSPAN_INSTANTIATE

template class DamageSink<Framebuffer<Rgb565>>;
template class PageMode<Ili9341>;
template class PageMode<Ssd0323>;
template class PageMode<Ssd1306>;
using DrawWindow = Status (*)(PageMode<Ssd1306>::Window&);
template Status PageMode<Ssd1306>::show_areas(const Rect&, const Rect&, DrawWindow&&);
template Status send_area(Ili9341&, const Framebuffer<Rgb565>&, const Rect&, std::span<std::uint8_t>);
template Status send_area(St7789&, const Framebuffer<Rgb565>&, const Rect&, std::span<std::uint8_t>);
template Status send_area(Ssd1351&, const Framebuffer<Rgb565>&, const Rect&, std::span<std::uint8_t>);
template Status send_area(Ssd0323&, const Framebuffer<Gray4>&, const Rect&, std::span<std::uint8_t>);
template Status send_area(Ssd1306&, const Framebuffer<Mono>&, const Rect&, std::span<std::uint8_t>);

}  // namespace arcspan::hal
