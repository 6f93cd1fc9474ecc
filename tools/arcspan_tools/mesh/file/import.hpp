// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/load.hpp>

#include <string>
#include <string_view>

namespace arcspan::tools {

/// Reads a Collada, FBX or 3DS file with the loader library. Polygons are triangulated; points and lines are
/// ignored. No other file knows the library, whose bugs end the process that calls this. Returns the scene as
/// JSON in CBOR, with lists of numbers as the bytes of arrays, for scene_model().
[[nodiscard]] std::string import_scene(std::string_view bytes, MeshFormat format, const std::string& subject);

}  // namespace arcspan::tools
