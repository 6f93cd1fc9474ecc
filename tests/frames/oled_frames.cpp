// SPDX-License-Identifier: MIT
// oled_frames: writes the host's OLED frames to standard output, one byte (0...15) a pixel, frame after
// frame.
#include <arcspan/pixel/gray4.hpp>

#include <tests/frames/oled_frames.hpp>

#include <cstdio>
#include <vector>

using namespace arcspan;

int main() {
  std::vector<std::uint8_t> pixels(hal::Framebuffer<Gray4>::words(scenes::kOledWidth, scenes::kOledHeight));
  std::vector<std::uint16_t> depths(DepthBuffer::words(scenes::kOledWidth, scenes::kOledHeight));
  for (std::int32_t i = 0; i < scenes::kOledFrames; ++i) {
    hal::Framebuffer<Gray4> frame(pixels, scenes::kOledWidth, scenes::kOledHeight);
    if (!ok(scenes::draw_oled_frame(i, frame, depths))) return 1;
    for (std::int32_t y = 0; y < scenes::kOledHeight; ++y) {
      for (std::int32_t x = 0; x < scenes::kOledWidth; ++x) std::putchar(frame.pixel(x, y).r >> 4);
    }
  }
}
