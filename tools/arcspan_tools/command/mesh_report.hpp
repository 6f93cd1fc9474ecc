// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/compile/animation_error.hpp>
#include <arcspan_tools/mesh/compile/compile_mesh.hpp>
#include <arcspan_tools/mesh/compile/mesh_figures.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/simulate/forecast.hpp>
#include <arcspan_tools/texture/plain/made_texture.hpp>

#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// The figures of one compiled model.
struct MeshReport {
  std::string model;
  std::string output;
  std::size_t model_vertices = 0;
  std::size_t model_triangles = 0;
  std::size_t model_bytes = 0;  ///< what it would have taken as it was
  double model_extent = 0;      ///< its largest, in its own units
  std::size_t dropped_faces = 0;
  std::optional<double> crease_degrees{};  ///< as in Model
  std::size_t bytes = 0;
  std::vector<ByteShare> shares{};  ///< of `bytes`
  bool shrunk_textures = false;     ///< to keep --max-bytes
  CompiledModel compiled;
  std::vector<MadeTexture> textures{};
  MeshFigures figures;
  std::optional<AnimationError> animation{};  ///< of a model that moves
  std::int32_t error_pixels = 240;            ///< of the model's extent in a picture
  std::optional<Forecast> forecast{};         ///< if it was asked for
};

/// For people, several lines.
[[nodiscard]] std::string to_text(const MeshReport& report);

/// For machines: one object.
[[nodiscard]] std::string to_json(const MeshReport& report);

/// Warnings: triangles whose normals are more than 60 degrees apart, clips that mirror nodes, names that are
/// cut.
[[nodiscard]] std::vector<std::string> warnings(const MeshReport& report);

}  // namespace arcspan::tools
