// SPDX-License-Identifier: MIT
// The pixel format of docs/add-a-pixel-format.md, plain and dithered.
#include "rgb444.hpp"

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/surface/arc.hpp>

using namespace arcspan;
using Light = Illumination<1, Highlight::kBlinn>;

constexpr std::int32_t kWidth = 64;
constexpr std::int32_t kHeight = 48;
constexpr std::int16_t kR = 32000;
constexpr ObjectPosition kPositions[] = {{kR, 0, 0},  {-kR, 0, 0}, {0, kR, 0},
                                         {0, -kR, 0}, {0, 0, kR},  {0, 0, -kR}};
constexpr std::uint8_t kIndices[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
constexpr ClipTransform kCamera = ClipTransform::of(
    {Rotation::about_x({5000}), {{}, {}, ObjectLength::of(-90000)}},
    {PixelLength::of(60), ObjectLength::of(40000), ObjectLength::of(140000)}, {kWidth, kHeight});
constexpr ChannelCoefficients kCopper{Coefficient::of(0.7), Coefficient::of(0.4), Coefficient::of(0.2)};
constexpr Light kLight =
    Light::of({{}, kCopper, kCopper, 20}, {{{normalised(-2, 3, 4)}}}, normalised(0, 0, 1));

template <class Format>
Status draw(hal::Framebuffer<Format>& frame) {
  PackedNormal normals[6];
  for (int i = 0; i < 6; ++i) normals[i] = pack_normal(kPositions[i].x, kPositions[i].y, kPositions[i].z);
  MeshView mesh;
  const Status status = MeshView::make(kPositions, normals, std::span(kIndices), mesh);
  if (!ok(status)) return status;
  frame.clear({0, 0, 0});
  return draw_mesh<Arc<Light>>(mesh, kCamera, kLight, frame, NoDepth{}).status;
}

template <class Format>
int differences(const hal::Framebuffer<Rgb888>& reference) {
  static typename Format::Word memory[hal::Framebuffer<Format>::words(kWidth, kHeight)];
  hal::Framebuffer<Format> frame(memory, kWidth, kHeight);
  if (!ok(draw(frame))) return -1;
  int count = 0;
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const Rgb8 colour = reference.pixel(x, y);
      const auto wanted = Format::kDithers ? Format::encode_dithered(colour, x, y) : Format::encode(colour);
      if (frame.pixel(x, y) != Format::decode(wanted)) ++count;
    }
  }
  return count;
}

int main() {
  for (int value = 0; value < 4096; ++value) {
    const auto encoded = static_cast<std::uint16_t>(value);
    if (Rgb444::encode(Rgb444::decode(encoded)) != encoded) return 1;
  }
  static Rgb8 memory[hal::Framebuffer<Rgb888>::words(kWidth, kHeight)];
  hal::Framebuffer<Rgb888> reference(memory, kWidth, kHeight);
  if (!ok(draw(reference)) || reference.pixel(kWidth / 2, kHeight / 2) == Rgb8{}) return 2;
  if (differences<Rgb444>(reference) != 0) return 3;
  return differences<Dithered<Rgb444>>(reference) == 0 ? 0 : 4;
}
