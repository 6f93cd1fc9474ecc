// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/render/render.hpp>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace arcspan::tools {

/// The figures of one rendered picture.
struct RenderReport {
  std::string mesh_name;
  std::string output;
  std::string shading;
  std::string format;
  std::size_t vertices = 0;
  std::size_t mesh_triangles = 0;
  std::size_t parts = 1;
  std::size_t dropped_faces = 0;
  std::optional<double> crease_degrees{};  ///< as in Model
  std::size_t mesh_bytes = 0;
  std::int32_t width = 0;
  std::int32_t height = 0;
  double load_milliseconds = 0;
  std::string outlines;  ///< what is done with them: "smoothed", or nothing
  RenderStats stats;

  /// Everything the pipeline works on: mesh, frame or band, depth, vertex cache, outlines.
  [[nodiscard]] std::size_t memory_bytes() const {
    return mesh_bytes + stats.frame_bytes + stats.depth_bytes + stats.cache_bytes + stats.outline_bytes;
  }
};

/// What reports say of Model::crease_degrees.
[[nodiscard]] std::string crease_text(const std::optional<double>& degrees);
[[nodiscard]] nlohmann::ordered_json crease_json(const std::optional<double>& degrees);

/// For people, several lines.
[[nodiscard]] std::string to_text(const RenderReport& report);

/// For machines: one object, keys as written below.
[[nodiscard]] std::string to_json(const RenderReport& report);

}  // namespace arcspan::tools
