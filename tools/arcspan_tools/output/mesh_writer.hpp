// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/mesh/compile/mesh_figures.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace arcspan::tools {

/// The form in which a compiled mesh is written: a header of constexpr arrays, or a binary that is used in
/// place.
enum class MeshOutput { kHeader, kBinary };

/// By the extension: .hpp or .h, .bin. On standard output a header; `bin:-` is the other. Throws Failure.
[[nodiscard]] MeshOutput mesh_output(const std::filesystem::path& path);

/// Bytes that the mesh takes in a firmware, with its `planes` or without: the arrays, and in a binary what is
/// around them.
[[nodiscard]] std::size_t mesh_bytes(MeshOutput output, std::size_t vertices, std::size_t triangles,
                                     bool planes);

/// The header: the mesh's arrays and `make_view` in namespace `name`, which must be an identifier (see
/// identifier()). `origin` says in a comment what it was made from.
[[nodiscard]] std::string mesh_header(const FixedMesh& mesh, const MeshFigures& figures,
                                      const std::string& name, const std::string& origin);

/// The binary of docs/mesh-binary.md.
[[nodiscard]] std::string mesh_binary_file(const FixedMesh& mesh, const MeshFigures& figures);

/// A C++ identifier that resembles `text`: `big bunny` gives big_bunny, `3` and `class` get mesh_ in front.
[[nodiscard]] std::string identifier(std::string_view text);

/// Whether `text` is an identifier that may name a namespace.
[[nodiscard]] bool is_identifier(std::string_view text);

}  // namespace arcspan::tools
