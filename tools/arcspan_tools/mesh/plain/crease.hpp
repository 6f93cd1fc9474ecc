// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>

#include <string>

namespace arcspan::tools {

/// `mesh` with normals of its own making: a corner gets the area-weighted average over those faces at its
/// position that lie within `degrees` of its own face, so edges sharper than that stay sharp. 180 smooths
/// everything, 0 shades every face flat. Whatever normals the mesh had are dropped; vertices are joined
/// afterwards. Throws Failure about `subject` if there are too many of them then.
[[nodiscard]] MeshData with_crease(const MeshData& mesh, double degrees, const std::string& subject);

/// The same for a model; faces of other parts count as neighbours too.
[[nodiscard]] Model with_crease(const Model& model, double degrees, const std::string& subject);

/// Files without normals have sharp edges above this angle, in degrees.
inline constexpr double kCreaseOfFiles = 40;
inline constexpr double kSmoothEverything = 180;

/// Gives corners that have no normal, of triangles whose smoothing the file leaves open (RawMesh::kSmooth),
/// the average over such triangles, as with_crease() does. Returns whether there are any; none at 180
/// degrees, where weld() averages.
bool add_creased_normals(RawMesh& mesh, double degrees);

}  // namespace arcspan::tools
