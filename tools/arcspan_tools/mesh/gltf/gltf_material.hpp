// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/gltf/gltf_texture.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

namespace arcspan::tools {

/// A material of a glTF file, converted to Phong's model (docs/conventions.md).
struct GltfMaterial {
  FileMaterial material;
  /// Linear factor of a vertex's linear colour; the display value of the product replaces `material.colour`.
  Vec3 base{1, 1, 1};
  GltfMapping mapping{};  ///< of `material.texture`
};

/// Phong's model of a surface of linear base colour `base`, 0...1, with metallic and roughness factors 0...1:
///
///   colour    = base · (1 − metallic/2)          a metal keeps half its colour in place of what it mirrors
///   n         = 2/roughness⁴ − 2, 1...256        Blinn's exponent of the same width
///   specular  = (0.04·(1 − metallic) + base·metallic) · (n + 2)/8, at most 1     the peak of that lobe
///
/// colour and specular as display values of sRGB.
[[nodiscard]] GltfMaterial phong_of(Vec3 base, double metallic, double roughness);

/// The material of the file, an element of `materials`, with the texture of its base colour.
[[nodiscard]] GltfMaterial read_gltf_material(GltfFile& file, const JsonView& json, GltfTextures& textures,
                                              LeftOut& left_out);

}  // namespace arcspan::tools
