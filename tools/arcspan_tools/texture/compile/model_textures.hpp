// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/texture/compile/make_texture.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// The textures of a model, all in one format.
struct ModelTextures {
  std::vector<MadeTexture> textures{};
  /// For each part an index into `textures`, if it has one. Empty if no part has a texture.
  std::vector<std::optional<std::size_t>> of_part{};

  [[nodiscard]] std::size_t bytes() const;
};

/// Makes the textures of a model's parts. If a part is masked or blended, the format is the one of this
/// layout with alpha bits; the opacity of others is left out. Throws Failure as make_texture() does.
[[nodiscard]] ModelTextures make_textures(const FixedModel& model, const TextureOptions& options);

/// The model with its textures as `made` holds them, in their sizes and with their levels.
[[nodiscard]] FixedModel with_made_textures(FixedModel model, const ModelTextures& made);

}  // namespace arcspan::tools
