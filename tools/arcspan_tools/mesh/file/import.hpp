// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/load.hpp>

#include <string>
#include <string_view>

namespace arcspan::tools {

/// Reads a Collada, FBX or 3DS file with the loader library. Polygons are triangulated; points and lines are
/// ignored. The only file of this project that knows the library, which should not run in a process that
/// matters. scene_model() makes a model of what it returns, and is the only reader of it: the scene as JSON
/// in CBOR, with lists of numbers as the bytes of arrays.
[[nodiscard]] std::string import_scene(std::string_view bytes, MeshFormat format, const std::string& subject);

}  // namespace arcspan::tools
