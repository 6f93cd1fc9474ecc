// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/mesh_data.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace arcspan::tools {

enum class MeshFormat { kObj, kPly, kStl, kOff };

/// The format that a file name's extension stands for, in either case.
[[nodiscard]] std::optional<MeshFormat> mesh_format(const std::filesystem::path& path);

/// Loads a mesh from a file (.obj, .ply, .stl, .off, or .bin for a mesh binary), or generates one
/// (`sphere:32x16`, `torus:48x24`; see generate.hpp). Throws Failure for everything that is wrong with it.
[[nodiscard]] MeshData load_mesh(const std::string& name);

/// The same for the bytes of a file that was already read; `subject` names it in messages. The loader library
/// runs in this very process, so its crashes are the caller's.
[[nodiscard]] MeshData load_mesh_from_memory(std::string_view bytes, MeshFormat format,
                                             const std::string& subject);

/// The mesh of a mesh binary (docs/mesh-binary.md), in its object units. Throws Failure for a foreign,
/// truncated or corrupted one, and one that has no or too many triangles.
[[nodiscard]] MeshData mesh_from_binary(std::string_view bytes, const std::string& subject);

}  // namespace arcspan::tools
