// SPDX-License-Identifier: MIT
// Scenes of several methods and of posed objects, as all_stages.cpp has draw_mesh().
#include <arcspan/animate/skinned_mesh.hpp>
#include <arcspan/drawn_rect.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pick.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>

namespace arcspan {

using SceneLighting = Illumination<2, Highlight::kBlinn>;
using SingleLighting = Illumination<1, Highlight::kBlinn>;
using Methods = MethodList<Gouraud<SceneLighting>, Unlit, Use<Flat<SingleLighting>, DrawFeatures{}, true>>;

template SceneResult draw_scene(const Scene&, hal::Framebuffer<Rgb565>&, const DepthBuffer&,
                                SceneMemory<Methods, 4, 100>&);

template Rect drawn_rect(SceneMemory<Methods, 4, 100>&);
template Rect drawn_rect(SceneMemory<Methods, 4>&, const Object&);
template Picked pick(SceneMemory<Methods, 4, 100>&, std::int32_t, std::int32_t);

using PosedMemory = SceneMemory<MethodList<Posed<Gouraud<SceneLighting>, SkinnedMesh>>, 4, 100>;
template SceneResult draw_scene(const Scene&, hal::Framebuffer<Rgb565>&, const DepthBuffer&, PosedMemory&);
template Rect drawn_rect(PosedMemory&);
template Picked pick(PosedMemory&, std::int32_t, std::int32_t);

Status make_camera(const LookAt& view, const Lens& lens, const Viewport& viewport, Camera& camera) {
  return Camera::make(view, lens, viewport, camera);
}

Status make_material(const Material& material, const LightList& lights,
                     PreparedMaterial<Gouraud<SceneLighting>>& prepared) {
  return PreparedMaterial<Gouraud<SceneLighting>>::make(material, lights, {}, prepared);
}

Object make_object(const MeshView& mesh, std::span<const Part> parts, const Quaternion& orientation) {
  Object object(mesh, parts);
  object.rotation = rotation_of(orientation);
  return object;
}

}  // namespace arcspan
