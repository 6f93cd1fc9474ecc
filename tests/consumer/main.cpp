// SPDX-License-Identifier: MIT
// Draws one triangle and counts its pixels: fails if the installed headers or libraries are not whole.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <cstdio>

using namespace arcspan;

int main() {
  static constexpr ObjectPosition kPositions[] = {{-20000, -20000, 0}, {20000, -20000, 0}, {0, 20000, 0}};
  const PackedNormal front = pack_normal(0, 0, 1);
  const PackedNormal normals[] = {front, front, front};
  static constexpr std::uint16_t kIndices[] = {0, 1, 2};
  MeshView mesh;
  if (!ok(MeshView::make(kPositions, normals, std::span(kIndices), mesh))) return 1;

  Placement placement{};
  placement.rotation = Rotation::identity();
  placement.translation[2] = ObjectLength::of(-80000.0);
  const Projection projection{PixelLength::of(80.0), ObjectLength::of(10000.0), ObjectLength::of(100000.0)};
  ClipTransform transform;
  if (!ok(ClipTransform::make(placement, projection, {64, 48}, transform))) return 2;

  const Direction towards{DirectionComponent{}, DirectionComponent{}, DirectionComponent::of(1.0)};
  Material material;
  material.diffuse = {Coefficient::of(1.0), Coefficient::of(0.5), Coefficient::of(0.0)};
  using Light = Illumination<1, Highlight::kBlinn>;
  Light light;
  if (!ok(Light::make(material, {DirectionalLight{towards}}, towards, light))) return 3;

  static std::uint16_t memory[64 * 48];
  hal::Framebuffer<Rgb565> frame(memory, 64, 48);
  if (!ok(draw_mesh<Arc<Light>>(mesh, transform, light, frame, NoDepth{}).status)) return 4;
  int lit = 0;
  for (const std::uint16_t pixel : memory) lit += pixel != 0;
  std::printf("%d pixels\n", lit);
  // 40 pixels wide and high: half of 40 x 40, but for a pixel at each end of a row.
  return lit > 760 && lit < 840 ? 0 : 5;
}
