// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/load.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace arcspan::tools {

/// Of a face in a PLY or OFF file.
inline constexpr std::int64_t kMostCorners = 4096;

/// Checks the bytes of a mesh file before the loader library sees them, and returns what the library is to be
/// given. The library takes words for zeros, skips what it does not understand and has been seen to crash on
/// damaged files; after this every number is one and finite, every index exists and every announced element
/// is there. Lines that do not matter to a shape (materials, groups, texture coordinates) are left out where
/// the format allows it. Throws a Failure that names the line.
[[nodiscard]] std::string screened(std::string_view bytes, MeshFormat format, const std::string& subject);

[[nodiscard]] std::string screened_obj(std::string_view bytes, const std::string& subject);
[[nodiscard]] std::string screened_ply(std::string_view bytes, const std::string& subject);
[[nodiscard]] std::string screened_stl(std::string_view bytes, const std::string& subject);
[[nodiscard]] std::string screened_off(std::string_view bytes, const std::string& subject);

}  // namespace arcspan::tools
