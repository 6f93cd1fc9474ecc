// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/mesh/compile/simplify.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace arcspan::tools {

/// Limits that a compiled mesh must keep.
struct MeshLimits {
  std::optional<std::size_t> max_triangles;
  std::optional<std::size_t> max_bytes;
  std::optional<double> crease_degrees;  ///< make normals anew; else they stay
  bool curves = false;                   ///< make Model::has_curves
};

/// Bytes that a model takes in the wanted output.
using BytesOf = std::function<std::size_t(const FixedModel&)>;

struct CompiledModel {
  FixedModel model;
  Simplification how = Simplification::kNone;
  double error = 0;                ///< how far simplification moved the surface, in the mesh's units
  double cache_misses_before = 0;  ///< per triangle, in the order of the file (after simplification)
  double cache_misses = 0;         ///< per triangle, now
};

/// Simplifies `model` until it is within `limits`, keeping as many triangles as they allow, and converts it
/// to fixed point; the vertices of each part are joined and ordered. `tried` is called with the number of
/// simplifications that were tried so far. Throws Failure about `subject` if the limits cannot be met.
[[nodiscard]] CompiledModel compile_model(const Model& model, const MeshLimits& limits,
                                          const BytesOf& bytes_of, const std::string& subject,
                                          const std::function<void(std::size_t)>& tried);

}  // namespace arcspan::tools
