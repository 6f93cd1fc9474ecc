// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/model/model_binary.hpp>
#include <arcspan/model/model_neighbours.hpp>

#include <arcspan_c/scene.hpp>

#include <cstddef>

namespace arcspan::c {

/// That of NULL for a look.
inline constexpr arcspan_look kUsualLook = {ARCSPAN_ARC, 1, 0, nullptr, 0};

[[nodiscard]] inline Material material_of(const arcspan_material& material) {
  return {coefficients(material.ambient), coefficients(material.diffuse), coefficients(material.specular),
          material.shininess};
}

/// The source of the material of a part.
[[nodiscard]] inline MaterialSource source_of(const arcspan_look& look, const Material& material,
                                              bool two_sided, const StoredTexture& texture) {
  MaterialSource source{material, texture, {two_sided || look.two_sided != 0}, look.method, look.tolerance};
#if ARCSPAN_C_TOON
  source.toon_steps = look.toon_steps;
#endif
  if (look.material != nullptr) source.material = material_of(*look.material);
  return source;
}

/// Sets `neighbours` to those of part `i` if outlines are compiled and the model has some.
[[nodiscard]] inline Status find_neighbours([[maybe_unused]] const StoredModel& model,
                                            [[maybe_unused]] std::size_t i,
                                            [[maybe_unused]] MeshNeighbours& neighbours) {
#if ARCSPAN_C_OUTLINES
  const Status status = view_neighbours(model, i, neighbours);
  if (status != Status::kUnsupported) return status;
#endif
  return Status::kOk;
}

}  // namespace arcspan::c
