// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/texture/plain/made_texture.hpp>

#include <filesystem>
#include <string>

namespace arcspan::tools {

/// The arrays of a texture and the texture itself as C++ constants `kTexels`, `kPalette` and `kTexture`.
[[nodiscard]] std::string texture_arrays(const MadeTexture& texture);

/// A header with the texture in namespace `name`, which must be an identifier (see identifier()). `origin`
/// says in a comment what it was made from.
[[nodiscard]] std::string texture_header(const MadeTexture& texture, const std::string& name,
                                         const std::string& origin);

/// The binary of docs/texture-binary.md.
[[nodiscard]] std::string texture_binary_file(const MadeTexture& texture);

/// The same without its checksum, as a chunk of a model binary.
[[nodiscard]] std::string texture_chunk(const MadeTexture& texture);

}  // namespace arcspan::tools
