// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/texture/texture.hpp>

#include <arcspan_tools/mesh/plain/model.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace arcspan::tools {

/// The picture as a surface of this material shows it: opaque if it is neither masked nor blended; if masked,
/// pixels are opaque or fully transparent.
[[nodiscard]] RgbaImage picture_of(const FileMaterial& material);

/// A texture for drawing on this machine, in rgb565 with all mip levels.
struct SurfaceTexture {
  std::vector<std::uint16_t> texels;
  Texture<DirectTexels<>> view;  ///< of `texels`
};

/// The texture of a picture, in the size that is nearest to it.
[[nodiscard]] std::shared_ptr<const SurfaceTexture> surface_texture(const RgbaImage& picture);

}  // namespace arcspan::tools
