// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// The text of Collada files, where Assimp does not read it as it is meant.
namespace arcspan::tools {

/// `xml` without the blanks between a tag and its first number, which some exporters write. Assimp takes
/// none.
[[nodiscard]] std::string without_blanks_before_numbers(std::string_view xml);

/// The number of joints that have the sid of an earlier one, as those of a second character may. Assimp looks
/// for a mesh's joints in the whole scene and takes the first of each sid, which may be another character's.
[[nodiscard]] std::size_t count_shared_joints(std::string_view xml);

/// `xml` with numbers in place of the names by which textures refer to texture coordinates (`texcoord`):
/// which of those that a mesh has, from 0 on, as `bind_vertex_input` says. Assimp reads digits of the name
/// alone.
[[nodiscard]] std::string with_numbered_sets(std::string_view xml);

}  // namespace arcspan::tools
