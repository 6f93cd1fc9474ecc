// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/material.hpp>
#include <arcspan/model/model_binary.hpp>

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/mesh/compile/mesh_figures.hpp>
#include <arcspan_tools/texture/compile/model_textures.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// The form in which a compiled mesh or texture is written: a header of constexpr arrays, or a binary that is
/// used in place.
enum class CompiledOutput { kHeader, kBinary };

/// The form of `arcspan mesh`: for_c is a C++ source (.cpp, cpp:-), or a binary in a C header (.h, h:-);
/// otherwise as compiled_output(). Throws a Failure for another extension.
[[nodiscard]] CompiledOutput compiled_mesh_output(const std::filesystem::path& path, bool for_c);

/// By the extension: .hpp or .h, .bin. On standard output a header; `bin:-` is the other. Throws a Failure
/// about a compiled `kind`.
[[nodiscard]] CompiledOutput compiled_output(const std::filesystem::path& path, const std::string& kind);

/// Bytes that the mesh takes in a firmware, with planes, texture points and colours or without: the arrays,
/// and in a binary what is around them.
[[nodiscard]] std::size_t mesh_bytes(CompiledOutput output, std::size_t vertices, std::size_t triangles,
                                     bool planes, bool texture_points = false, bool colours = false);

/// Bytes that the model takes in a firmware, materials and textures included.
[[nodiscard]] std::size_t model_bytes(CompiledOutput output, const FixedModel& model, bool planes,
                                      const ModelTextures& textures = {});

/// What the bytes of a model are for. Their sum is model_bytes().
struct ByteShare {
  const char* name;
  std::size_t bytes;
};
[[nodiscard]] std::vector<ByteShare> byte_shares(CompiledOutput output, const FixedModel& model,
                                                 const ModelTextures& textures);

/// Whether the model is a single mesh without a material, which is written as a mesh.
[[nodiscard]] bool is_plain_mesh(const FixedModel& model);

/// Whether a part with this material is opaque, masked or blended.
[[nodiscard]] PartAlpha part_alpha(const FileMaterial& material);

/// The header. A single mesh: its arrays and `make_view` in namespace `name`, which must be an identifier
/// (see identifier()), and its material if it has one. Several parts: each in a namespace of its own within
/// `name`, and `kParts`, the list of them. Unit and origin are constants. `origin` says in a comment what it
/// was made from.
[[nodiscard]] std::string model_header(const FixedModel& model, const std::string& name,
                                       const std::string& origin, const ModelTextures& textures = {});

/// A C++ source that defines the model `name` for the C interface: its arrays, and its materials prepared,
/// for light in `toon_steps` unless that is 0.
[[nodiscard]] std::string model_c_source(const FixedModel& model, const std::string& name,
                                         const std::string& origin, const ModelTextures& textures,
                                         std::int32_t toon_steps);

/// A C header with the binary of a model as the array `name`.
[[nodiscard]] std::string model_c_header(const FixedModel& model, const std::string& name,
                                         const std::string& origin, const ModelTextures& textures = {});

/// The binary of docs/mesh-binary.md.
[[nodiscard]] std::string mesh_binary_file(const FixedMesh& mesh, const MeshFigures& figures);

/// The same without its checksum, as a chunk of a model binary.
[[nodiscard]] std::string mesh_chunk(const FixedMesh& mesh, const MeshFigures& figures);

/// The binary of docs/model-binary.md, or of a plain mesh without neighbours that of docs/mesh-binary.md.
[[nodiscard]] std::string model_binary_file(const FixedModel& model, const ModelTextures& textures = {});

/// Names of the parts for people, no two alike.
[[nodiscard]] std::vector<std::string> part_names(const FixedModel& model);

/// The material of a part as a firmware takes it: what its file says, with the shares of light that pictures
/// have by default; white where it states no colour, and white plastic, as the C interface draws a mesh
/// binary, if it states nothing.
[[nodiscard]] Material material_of(const PartLook& look);

/// A C++ identifier that resembles `text`: `big bunny` gives big_bunny, `3` and `class` get mesh_ in front.
[[nodiscard]] std::string identifier(std::string_view text);

/// Whether `text` is an identifier that may name a namespace.
[[nodiscard]] bool is_identifier(std::string_view text);

}  // namespace arcspan::tools
