// SPDX-License-Identifier: MIT
#include <tests/firmware/cost_spheres.hpp>
#include <tests/frames/integer_shapes.hpp>

namespace arcspan {
namespace {

constexpr auto kCoarsest = scenes::make_sphere<8, 4>();
constexpr auto kCoarse = scenes::make_sphere<16, 8>();
constexpr auto kMiddle = scenes::make_sphere<32, 16>();
constexpr auto kFine = scenes::make_sphere<64, 32>();
constexpr auto kCoarsestPlanes = scenes::planes_of(kCoarsest);
constexpr auto kCoarsePlanes = scenes::planes_of(kCoarse);
constexpr auto kMiddlePlanes = scenes::planes_of(kMiddle);
constexpr auto kFinePlanes = scenes::planes_of(kFine);

template <class Shape, class Planes>
bool make_views(const Shape& shape, const Planes& planes, SphereMeshes& meshes) {
  if (!ok(shape.view(meshes.plain))) return false;
  if (!ok(MeshView::make(shape.positions, shape.normals, std::span<const std::uint16_t>{}, meshes.vertices)))
    return false;
  meshes.planed = meshes.plain;
  return ok(planes.attach_to(meshes.planed));
}

}  // namespace

bool make_sphere_meshes(SphereFineness fineness, SphereMeshes& meshes) {
  switch (fineness) {
    case SphereFineness::k8x4:
      return make_views(kCoarsest, kCoarsestPlanes, meshes);
    case SphereFineness::k16x8:
      return make_views(kCoarse, kCoarsePlanes, meshes);
    case SphereFineness::k32x16:
      return make_views(kMiddle, kMiddlePlanes, meshes);
    case SphereFineness::k64x32:
      return make_views(kFine, kFinePlanes, meshes);
  }
  return false;
}

}  // namespace arcspan
