// SPDX-License-Identifier: MIT
// Draws model.bin, of the folder in which it is run, as docs/model-binary.md shows.
#include "draw_model.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>

constexpr std::int32_t kWidth = 120;
constexpr std::int32_t kHeight = 120;
Frame::Word frame_memory[Frame::words(kWidth, kHeight)];
std::uint16_t depth_memory[DepthBuffer::words(kWidth, kHeight)];

// Stands for a partition of a microcontroller's flash.
alignas(4) std::uint8_t flash[16384];

int main() {
  std::FILE* const file = std::fopen("model.bin", "rb");
  if (file == nullptr || std::fread(flash, 1, sizeof flash, file) == 0) return 1;
  std::fclose(file);

  constexpr std::int32_t kLongest = 65534;  // of every model that `arcspan mesh` writes
  Placement placement{Rotation::about_y({4000}), {}};
  placement.translation[2] = ObjectLength::of(-2 * kLongest);
  ClipTransform transform;
  if (!ok(ClipTransform::make(
          placement, {PixelLength::of(kWidth), ObjectLength::of(kLongest), ObjectLength::of(3 * kLongest)},
          {kWidth, kHeight}, transform))) {
    return 2;
  }
  const DirectionalLight sun{placement.rotation.to_object(normalised(2, 3, 4)), Coefficient::of(1.0)};
  Frame frame(frame_memory, kWidth, kHeight);
  DepthBuffer depth(depth_memory, kWidth, kHeight);
  frame.clear({0, 0, 40});
  depth.clear();
  if (!ok(draw(flash, transform, sun, placement.rotation.to_object(normalised(0, 0, 1)), frame, depth))) {
    return 3;
  }
  for (const std::uint16_t one : depth_memory) {
    if (one != 65535) return 0;
  }
  return 4;  // nothing was drawn
}
