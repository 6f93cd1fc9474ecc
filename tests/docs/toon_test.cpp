// SPDX-License-Identifier: MIT
// A picture by the method of docs/add-a-shading-method.md has its three tones only, also through an
// operation.
#include "toon.hpp"

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/pixel_operation.hpp>
#include <arcspan/shading/with_operation.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iterator>

using namespace arcspan;

constexpr std::int16_t kR = 32000;
constexpr ObjectPosition kPositions[] = {{kR, 0, 0},  {-kR, 0, 0}, {0, kR, 0},
                                         {0, -kR, 0}, {0, 0, kR},  {0, 0, -kR}};
constexpr std::uint8_t kIndices[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
std::uint8_t frame_memory[hal::Framebuffer<Gray8>::words(64, 48)];
std::uint8_t opaque_memory[std::size(frame_memory)];

int main() {
  PackedNormal normals[6];
  for (int i = 0; i < 6; ++i) normals[i] = pack_normal(kPositions[i].x, kPositions[i].y, kPositions[i].z);
  MeshView mesh;
  if (!ok(MeshView::make(kPositions, normals, std::span(kIndices), mesh))) return 1;

  Placement placement{Rotation::about_x({5000}) * Rotation::about_y({5000}), {}};
  placement.translation[2] = ObjectLength::of(-90000);
  ClipTransform transform;
  if (!ok(ClipTransform::make(placement,
                              {PixelLength::of(60), ObjectLength::of(40000), ObjectLength::of(140000)},
                              {64, 48}, transform)))
    return 1;

  const auto grey = [](std::uint32_t level) { return PackedRgb::of(4 * level, 4 * level, 4 * level); };
  const Toon::Lighting toon{placement.rotation.to_object(normalised(-2, 3, 4)),
                            {grey(60), grey(140), grey(230)}};
  hal::Framebuffer<Gray8> frame(frame_memory, 64, 48);
  if (!ok(draw_mesh<Toon>(mesh, transform, toon, frame, NoDepth{}).status)) return 1;

  using Opaque = WithOperation<Toon, Opacity<>>;
  hal::Framebuffer<Gray8> opaque(opaque_memory, 64, 48);
  const Opaque::Lighting opaque_toon(toon, Opacity<>{32});
  if (!ok(draw_mesh<Opaque>(mesh, transform, opaque_toon, opaque, NoDepth{}).status)) return 1;
  if (!std::equal(std::begin(frame_memory), std::end(frame_memory), opaque_memory)) return 3;

  int count[256] = {};
  for (const std::uint8_t pixel : frame_memory) ++count[pixel];
  std::printf("shadow %d, half-light %d, light %d pixels\n", count[60], count[140], count[230]);
  const bool only_tones = count[0] + count[60] + count[140] + count[230] == 64 * 48;
  return only_tones && count[60] > 50 && count[140] > 50 && count[230] > 50 ? 0 : 2;
}
