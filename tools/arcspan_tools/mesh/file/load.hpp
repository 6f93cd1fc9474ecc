// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace arcspan::tools {

/// Largest model file: the longest text of kMaxTriangles triangles, of an STL file, needs half of this.
inline constexpr std::size_t kMostFileBytes = std::size_t{512} << 20;

enum class MeshFormat { kObj, kPly, kStl, kOff, kGltf, kCollada, kFbx, k3ds };

/// The format that a file name's extension stands for, in either case.
[[nodiscard]] std::optional<MeshFormat> mesh_format(const std::filesystem::path& path);

/// Loads a model from a file (.obj, .ply, .stl, .off, .gltf, .glb, .dae, .zae, .fbx, .3ds, or .bin for a mesh
/// or model binary), or generates one (`sphere:32x16`, `torus:48x24`; see generate.hpp). Throws Failure for
/// everything that is wrong with it. Where a file leaves normals open, edges above `crease_degrees` are
/// sharp.
[[nodiscard]] Model load_model_file(const std::string& name,
                                    TexturePointsOf points = TexturePointsOf::kTexturedParts,
                                    VertexColours colours = VertexColours::kMean,
                                    double crease_degrees = kCreaseOfFiles);

/// The same for the bytes of a file that was already read; `subject` names it in messages, and files that it
/// refers to are missing. The loader library runs in this very process, so its crashes are the caller's.
[[nodiscard]] Model load_model_from_memory(std::string_view bytes, MeshFormat format,
                                           const std::string& subject);

/// load_model_file(), with all parts as one mesh.
[[nodiscard]] MeshData load_mesh(const std::string& name, double crease_degrees = kCreaseOfFiles);

/// The model of a mesh binary (docs/mesh-binary.md), in its object units, or of a model binary
/// (docs/model-binary.md). Throws Failure for a foreign, truncated or corrupted one, and one that has no or
/// too many triangles.
[[nodiscard]] Model model_from_binary(std::string_view bytes, const std::string& subject);

}  // namespace arcspan::tools
