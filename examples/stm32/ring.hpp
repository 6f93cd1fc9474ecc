// SPDX-License-Identifier: MIT
// A copper ring, as ring_spi.cpp and ring_ltdc.cpp draw it.
#pragma once

#include "model.h"

#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/shading/surface/arc.hpp>

namespace ring {

using namespace arcspan;
using Method = Arc<Illumination<1, Highlight::kPhong>>;

inline constexpr MeshView kMesh = MeshView::of(model::kPositions, model::kNormals, model::kIndices)
                                      .with(model::kPlanes, model::kPlaneScale);
inline constexpr SceneLight kSun[] = {SceneLight::directional(normalised(-2, 3, 4))};
inline constexpr auto kCopper = PreparedMaterial<Method>::of(plastic({220, 130, 70}), {kSun});

consteval Camera camera_of(Viewport picture) {
  return Camera::of({WorldPoint::of(0, 0.5, 3), {}},
                    Lens::field_of_view(Turn{8000}, WorldLength::of(1), WorldLength::of(5)), picture);
}

}  // namespace ring
