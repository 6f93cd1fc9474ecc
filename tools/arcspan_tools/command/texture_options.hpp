// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <arcspan_tools/texture/make_texture.hpp>

#include <optional>
#include <string>

namespace arcspan::tools {

/// rgb565, one level, the size nearest to the picture's.
[[nodiscard]] TextureOptions default_texture_options();

/// Adds the option `name` that takes the name of a texel format.
void add_texture_format(CLI::App& app, const std::string& name, TextureFormat& format);

/// Adds the option `name` that takes the sides of a texture: N, or WIDTHxHEIGHT.
void add_texture_size(CLI::App& app, const std::string& name, std::optional<Size>& size);

/// Adds the option `name` that takes a number of mip levels, or `all`.
void add_texture_levels(CLI::App& app, const std::string& name, std::int32_t& levels);

}  // namespace arcspan::tools
