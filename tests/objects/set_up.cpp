// SPDX-License-Identifier: MIT
// What sets a scene up at run time, and what is done with its pixels, as all_stages.cpp has the stages.
#include <arcspan/convert_drawn.hpp>
#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/lighting/illumination.hpp>
#include <arcspan/mesh/face_normal.hpp>
#include <arcspan/mesh/make_face_planes.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/bgr888.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/texture/texture_binary.hpp>
#include <arcspan/vertex/clip_transform.hpp>

namespace arcspan {

Status make_transform(Turn x, Turn y, Turn z, ObjectLength distance, const Projection& projection,
                      const Viewport& viewport, ClipTransform& transform) {
  const Rotation rotation = Rotation::about_x(x) * Rotation::about_y(y) * Rotation::about_z(z);
  return ClipTransform::make({rotation, {{}, {}, distance}}, projection, viewport, transform);
}

Status make_light(const Material& material, const Rotation& rotation, const Direction& towards,
                  Illumination<1, Highlight::kPhong>& light) {
  const Direction sun = rotation.to_object(towards);
  return Illumination<1, Highlight::kPhong>::make(material, {{{sun}}},
                                                  rotation.to_object(normalised(0, 0, 1)), light);
}

Status set_tolerance(std::int32_t tolerance, Illumination<1, Highlight::kPhong>& light) {
  return light.set_tolerance(tolerance);
}

Status make_mesh(std::span<const ObjectPosition> positions, std::span<const PackedNormal> normals,
                 std::span<const std::uint16_t> indices, MeshView& mesh) {
  return MeshView::make(positions, normals, indices, mesh);
}
Status make_small_mesh(std::span<const ObjectPosition> positions, std::span<const PackedNormal> normals,
                       std::span<const std::uint8_t> indices, MeshView& mesh) {
  return MeshView::make(positions, normals, indices, mesh);
}

// A constant must not overflow, so that this would not compile for AVR if differences were taken in its int.
static_assert(face_normal({-32768, -32768, 0}, {32767, -32768, 0}, {-32768, 32767, 0}).z.raw() >= 32768);

Status make_planes(std::span<FacePlane> memory, MeshView& mesh) {
  PlaneScale scale;
  const Status made = make_face_planes(mesh, memory, scale);
  return ok(made) ? mesh.attach(memory, scale) : made;
}

Status make_texture(std::span<const std::uint8_t> binary, Texture<Palette4Texels<Alpha1Colour>>& texture) {
  return view_texture_binary(binary, texture);
}

Status convert(const hal::Framebuffer<Rgb565>& band, const DepthBuffer& depth,
               hal::FramebufferWindow<Dithered<Gray4>>& target) {
  return convert_drawn(band, depth, target);
}
Status convert(const hal::Framebuffer<Rgb565>& band, const DepthBuffer& depth,
               hal::FramebufferWindow<Bgr888>& target) {
  return convert_drawn(band, depth, target);
}

}  // namespace arcspan
