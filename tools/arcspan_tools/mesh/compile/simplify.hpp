// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>

#include <string>

namespace arcspan::tools {

/// How triangles are taken away, from the gentlest to the one that always gets there.
enum class Simplification {
  kNone,
  kWithNormals,  ///< edges collapse; vertices keep their normals, creases stay where they are
  kByPosition,   ///< the same for the positions alone; normals are made anew
  kByCells,      ///< vertices of a cell of space become one, whatever that does to holes; normals made anew
};

/// For the report: "edge collapse", ...
[[nodiscard]] const char* to_string(Simplification how);

struct Simplified {
  Model model;
  double error = 0;  ///< the library's estimate of how far the surface moved, in the mesh's units
};

/// `model` with about `triangles` triangles or fewer, or more if `how` gets no further: check. Borders
/// between parts stay where they are, except kByCells, which simplifies each part by itself. Normals made
/// anew have creases at `crease_degrees`. No parts in the result mean that nothing was left.
[[nodiscard]] Simplified simplify(const Model& model, Simplification how, std::size_t triangles,
                                  double crease_degrees, const std::string& subject);

}  // namespace arcspan::tools
