// SPDX-License-Identifier: MIT
// Prints a shaded ball to the serial monitor as characters, so that no display is needed.

#include <arcspan.h>

using namespace arcspan;
using Light = Illumination<1, Highlight::kBlinn>;

// An octahedron whose normals point from the centre to the vertices, so it is shaded like a ball.
constexpr int16_t kR = 32000;
constexpr ObjectPosition kPositions[] = {{kR, 0, 0}, {-kR, 0, 0}, {0, kR, 0}, {0, -kR, 0}, {0, 0, kR}, {0, 0, -kR}};
constexpr uint8_t kIndices[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
constexpr int kWidth = 56;
constexpr int kHeight = 24;

uint8_t frame_memory[hal::Framebuffer<Gray4>::words(kWidth, kHeight)];

Status draw(hal::Framebuffer<Gray4>& frame) {
  PackedNormal normals[6];
  for (int i = 0; i < 6; ++i) normals[i] = pack_normal(kPositions[i].x, kPositions[i].y, kPositions[i].z);
  MeshView mesh;
  Status status = MeshView::make(kPositions, normals, std::span(kIndices), mesh);
  if (!ok(status)) return status;

  Placement placement{Rotation::about_x({5000}) * Rotation::about_y({5000}), {}};
  placement.translation[2] = ObjectLength::of(-90000);  // the camera looks along -z
  ClipTransform transform;
  status = ClipTransform::make(placement, {PixelLength::of(34), ObjectLength::of(40000), ObjectLength::of(140000)},
                               {kWidth, kHeight}, transform);
  if (!ok(status)) return status;

  const Direction to_eye = placement.rotation.to_object(normalised(0, 0, 1));
  const Direction to_light = placement.rotation.to_object(normalised(-2, 3, 4));
  Material material;
  material.ambient = {Coefficient::of(0.2), Coefficient::of(0.2), Coefficient::of(0.2)};
  material.diffuse = material.specular = {Coefficient::of(0.6), Coefficient::of(0.6), Coefficient::of(0.6)};
  static Light light;
  status = Light::make(material, {DirectionalLight{to_light}}, to_eye, light);
  if (!ok(status)) return status;
  return draw_mesh<Arc<Light>>(mesh, transform, light, frame, NoDepth{}).status;
}

void setup() {
  Serial.begin(115200);
  hal::Framebuffer<Gray4> frame(frame_memory, kWidth, kHeight);
  const Status status = draw(frame);
  if (!ok(status)) {
    Serial.println(to_string(status));
    return;
  }
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) Serial.print(" .,:;-~=+*oxX#%@"[frame.pixel(x, y).r >> 4]);
    Serial.println();
  }
}

void loop() {}
