// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <arcspan_tools/texture/compile/make_texture.hpp>

#include <optional>
#include <string>

namespace arcspan::tools {

/// rgb565, one level, the size nearest to the picture's.
[[nodiscard]] TextureOptions default_texture_options();

/// The defaults for textures that are embedded in models: pal8, at most 128x128 texels, one level.
[[nodiscard]] TextureOptions default_model_texture_options();

/// Adds --texture, a picture for all parts of a model.
void add_texture(CLI::App& app, std::string& picture);

/// Adds the option `name` that takes the name of a texel format.
void add_texture_format(CLI::App& app, const std::string& name, TextureFormat& format);

/// Adds the option `name` that takes the sides of a texture: N, or WIDTHxHEIGHT.
void add_texture_size(CLI::App& app, const std::string& name, const std::string& otherwise,
                      std::optional<Size>& size);

/// Adds --wrap and --filter, which say how a texture is meant to be shown.
void add_sampler(CLI::App& app, TextureSampler& sampler);

/// Adds the option `name` that takes a number of mip levels, or `all`.
void add_texture_levels(CLI::App& app, const std::string& name, std::int32_t& levels);

}  // namespace arcspan::tools
