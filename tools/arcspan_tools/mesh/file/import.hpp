// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/load.hpp>

#include <string>
#include <string_view>

namespace arcspan::tools {

/// Reads a Collada or 3DS file with the loader library. Polygons are triangulated; points and lines are
/// ignored. The only file of this project that knows the library, which should not run in a process that
/// matters.
///
/// Returns JSON in CBOR: `triangles` are the bytes of arrays of three RawMesh::Corner, moved by the
/// transforms of their nodes; `look_of` those of 32-bit indices into `looks`, an array of objects with names,
/// material, diffuse, specular, emission, shininess, texture and two_sided.
[[nodiscard]] std::string import_scene(std::string_view bytes, MeshFormat format, const std::string& subject);

}  // namespace arcspan::tools
