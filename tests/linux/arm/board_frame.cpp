// SPDX-License-Identifier: MIT
#include "board_frame.hpp"

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/hal/panel/command_port.hpp>
#include <arcspan/hal/panel/mipi_dcs.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>

namespace arcspan::test {
namespace {

using hal::Level;
namespace dcs = hal::dcs;

constexpr std::uint16_t kWidth = 96;
constexpr std::uint16_t kHeight = 64;
constexpr std::int16_t kR = 32000;
constexpr ObjectPosition kPositions[] = {{kR, 0, 0},  {-kR, 0, 0}, {0, kR, 0},
                                         {0, -kR, 0}, {0, 0, kR},  {0, 0, -kR}};
constexpr std::uint8_t kIndices[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

std::uint16_t frame_memory[hal::Framebuffer<Rgb565>::words(kWidth, kHeight)];
std::uint8_t wire_memory[kWidth * kHeight * 2];

Status draw(hal::Framebuffer<Rgb565>& frame) {
  PackedNormal normals[6];
  for (int i = 0; i < 6; ++i) normals[i] = pack_normal(kPositions[i].x, kPositions[i].y, kPositions[i].z);
  MeshView mesh;
  Status status = MeshView::make(kPositions, normals, std::span(kIndices), mesh);
  if (!ok(status)) return status;
  Placement placement{Rotation::about_x({5000}) * Rotation::about_y({5000}), {}};
  placement.translation[2] = ObjectLength::of(-90000);
  ClipTransform transform;
  status =
      ClipTransform::make(placement, {PixelLength::of(90), ObjectLength::of(40000), ObjectLength::of(140000)},
                          {kWidth, kHeight}, transform);
  if (!ok(status)) return status;
  Material material;
  material.ambient = {Coefficient::of(0.1), Coefficient::of(0.2), Coefficient::of(0.3)};
  material.diffuse = {Coefficient::of(0.8), Coefficient::of(0.5), Coefficient::of(0.2)};
  material.specular = {Coefficient::of(0.4), Coefficient::of(0.4), Coefficient::of(0.4)};
  using Light = Illumination<1, Highlight::kBlinn>;
  Light light;
  status = Light::make(material, {DirectionalLight{placement.rotation.to_object(normalised(-2, 3, 4))}},
                       placement.rotation.to_object(normalised(0, 0, 1)), light);
  if (!ok(status)) return status;
  frame.clear({10, 20, 30});
  return draw_mesh<Arc<Light>>(mesh, transform, light, frame, NoDepth{}).status;
}

// rgb565 in the order of the wire.
std::span<const std::uint8_t> wire_bytes() {
  std::size_t at = 0;
  for (const std::uint16_t code : frame_memory) {
    wire_memory[at++] = static_cast<std::uint8_t>(code >> 8);
    wire_memory[at++] = static_cast<std::uint8_t>(code & 0xFF);
  }
  return wire_memory;
}

Status reset(const BoardWires& wires) {
  for (const Level level : {Level::kHigh, Level::kLow, Level::kHigh}) {
    const Status status = wires.reset.set(level);
    if (!ok(status)) return status;
    wires.clock.delay_ms(1);
  }
  return Status::kOk;
}

}  // namespace

Status send_frame(const BoardWires& wires) {
  hal::Framebuffer<Rgb565> frame(frame_memory, kWidth, kHeight);
  Status status = draw(frame);
  if (ok(status)) status = reset(wires);
  hal::CommandPort port(wires.spi, wires.data_or_command);
  const dcs::Command before[] = {dcs::kSleepOut, dcs::kPixelFormatRgb565, dcs::columns(0, kWidth - 1),
                                 dcs::rows(0, kHeight - 1), dcs::kMemoryWrite};
  for (const dcs::Command& command : before) {
    if (ok(status)) status = port.command(command.opcode, command.parameters());
  }
  if (ok(status)) status = port.data(wire_bytes());
  if (ok(status)) status = port.command(dcs::kDisplayOn.opcode);
  if (ok(status)) status = wires.backlight.set(Level::kHigh);
  if (ok(status)) status = port.command(dcs::kSleepIn.opcode);
  if (ok(status)) status = wires.backlight.set(Level::kLow);
  return status;
}

}  // namespace arcspan::test
