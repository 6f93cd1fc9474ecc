// SPDX-License-Identifier: MIT
// Draws the frames of tests/frames/oled_frames.hpp on the board's OLED through the driver of hal/, says
// "shown N" after each and waits for a character, so that oled_test.py can take the emulator's display and
// compare it with the host's frame.
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/console.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/pixel/gray4.hpp>

#include <oled.hpp>
#include <tests/frames/oled_frames.hpp>

using namespace arcspan;

namespace {

std::uint8_t pixels[hal::Framebuffer<Gray4>::words(scenes::kOledWidth, scenes::kOledHeight)];
std::uint8_t wire[512];  // 8 rows, of which one half is sent while the other is packed
std::uint16_t depths[scenes::kOledWidth * scenes::kOledHeight];

/// Blocks until the console delivers a character (semihosting SYS_READC).
void wait_for_character() {
  register std::uint32_t r0 __asm("r0") = 7;
  register std::uint32_t r1 __asm("r1") = 0;
  __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

}  // namespace

int main() {
  lm3s6965::start_clocks();
  lm3s6965::Oled oled;
  if (!ok(oled.start())) return 2;
  for (std::int32_t i = 0; i < scenes::kOledFrames; ++i) {
    hal::Framebuffer<Gray4> frame(pixels, scenes::kOledWidth, scenes::kOledHeight);
    if (!ok(scenes::draw_oled_frame(i, frame, depths))) return 1;
    if (!ok(hal::send_area(oled.panel(), frame, frame.bounds(), wire))) return 3;
    bare::print_line("shown ", static_cast<std::uint32_t>(i));
    wait_for_character();
  }
  return 0;
}
