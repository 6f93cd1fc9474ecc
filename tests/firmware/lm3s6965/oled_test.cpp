// SPDX-License-Identifier: MIT
// Draws the frames of tests/scenes/oled_frames.hpp on the board's OLED, says "shown N" after each and waits
// for a character, so that oled_test.py can take the emulator's display and compare it with the host's frame.
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/console.hpp>

#include <pins.hpp>
#include <ssi.hpp>
#include <tests/scenes/oled_frames.hpp>

#include <array>

using namespace arcspan;

namespace {

std::uint8_t pixels[hal::Framebuffer<Gray4>::units(scenes::kOledWidth, scenes::kOledHeight)];
std::uint16_t depths[scenes::kOledWidth * scenes::kOledHeight];

/// SSD0323 (Solomon Systech, rev 1.8, table 9): commands go out with D/C low, pixels with it high.
class Oled {
 public:
  void start() {
    select_.set(true);  // PD0 chooses the display on the bus it shares with the SD card
    constexpr std::array<std::uint8_t, 3> kRemapNoneAndOn{0xA0, 0x00, 0xAF};
    command(kRemapNoneAndOn);
  }
  void show(std::span<const std::uint8_t> frame) {
    constexpr std::array<std::uint8_t, 6> kWindow{0x15, 0, 63, 0x75, 0, scenes::kOledHeight - 1};
    command(kWindow);
    bus_.write(frame);
  }

 private:
  void command(std::span<const std::uint8_t> bytes) {
    data_.set(false);
    bus_.write(bytes);
    data_.set(true);
  }
  lm3s6965::Ssi bus_;
  lm3s6965::OutputPin data_{lm3s6965::Port::kC, 7};
  lm3s6965::OutputPin select_{lm3s6965::Port::kD, 0};
};

/// Blocks until the console delivers a character (semihosting SYS_READC).
void wait_for_character() {
  register std::uint32_t r0 __asm("r0") = 7;
  register std::uint32_t r1 __asm("r1") = 0;
  __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

}  // namespace

int main() {
  lm3s6965::start_clocks();
  Oled oled;
  oled.start();
  for (std::int32_t i = 0; i < scenes::kOledFrames; ++i) {
    hal::Framebuffer<Gray4> frame(pixels, scenes::kOledWidth, scenes::kOledHeight);
    if (!ok(scenes::draw_oled_frame(i, frame, depths))) return 1;
    oled.show(pixels);
    bare::print_line("shown ", static_cast<std::uint32_t>(i));
    wait_for_character();
  }
  return 0;
}
