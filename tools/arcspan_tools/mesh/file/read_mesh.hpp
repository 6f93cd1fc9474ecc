// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/side_files.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <string>
#include <string_view>

namespace arcspan::tools {

// One reader for each format without nodes. They return the triangles of a file's faces, and throw a Failure
// that names the line. FileMesh says what of a file may be wrong without an error. `files` reads the files
// that this one refers to.
[[nodiscard]] RawModel read_obj(std::string_view bytes, const std::string& subject, const SideFiles& files);
[[nodiscard]] RawModel read_off(std::string_view bytes, const std::string& subject);
[[nodiscard]] RawModel read_ply(std::string_view bytes, const std::string& subject);
[[nodiscard]] RawModel read_stl(std::string_view bytes, const std::string& subject);

}  // namespace arcspan::tools
