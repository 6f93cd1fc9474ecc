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

/// `xml` with the name in each texture's `texcoord` replaced by the number of the set that a
/// `bind_vertex_input` binds to it, less the lowest set of the file; 0 if none does. Of such a name Assimp
/// reads only digits.
[[nodiscard]] std::string with_numbered_sets(std::string_view xml);

}  // namespace arcspan::tools
