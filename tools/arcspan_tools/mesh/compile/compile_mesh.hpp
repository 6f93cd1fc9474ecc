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
};

/// Bytes that so many vertices and triangles take in the wanted output.
using BytesOf = std::function<std::size_t(std::size_t vertices, std::size_t triangles)>;

struct CompiledMesh {
  FixedMesh mesh;
  Simplification how = Simplification::kNone;
  double error = 0;                ///< how far simplification moved the surface, in the mesh's units
  double cache_misses_before = 0;  ///< per triangle, in the order of the file (after simplification)
  double cache_misses = 0;         ///< per triangle, now
};

/// Simplifies `mesh` until it is within `limits`, keeping as many triangles as they allow, and converts it to
/// fixed point; vertices are joined and ordered. `tried` is called with the number of simplifications that
/// were tried so far. Throws Failure about `subject` if the limits cannot be met.
[[nodiscard]] CompiledMesh compile_mesh(const MeshData& mesh, const MeshLimits& limits,
                                        const BytesOf& bytes_of, const std::string& subject,
                                        const std::function<void(std::size_t)>& tried);

}  // namespace arcspan::tools
