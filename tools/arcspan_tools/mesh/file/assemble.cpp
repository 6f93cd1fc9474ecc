// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/assemble.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <utility>

namespace arcspan::tools {
namespace {

/// The colour of a triangle: that of its face, or those of its corners if all have one.
TriangleColour colour_of(const TriangleSource& source, const FaceTag& tag, const ScreenedMesh& file) {
  if (tag.colour) return {true, {*tag.colour, *tag.colour, *tag.colour}};
  TriangleColour colour{!file.vertex_colours.empty(), {}};
  for (std::size_t i = 0; i < 3 && colour.known; ++i) {
    const std::optional<Vec3>& corner = file.vertex_colours[source.vertices[i]];
    colour.known = corner.has_value();
    if (corner) colour.corners[i] = *corner;
  }
  return colour;
}

}  // namespace

RawModel assembled(ImportedMesh mesh, ScreenedMesh file, const std::string& subject) {
  RawModel model;
  model.mesh.triangles = std::move(mesh.triangles);
  model.looks = file.looks;
  model.warnings = std::move(file.warnings);
  model.look_of.resize(model.mesh.triangles.size());
  if (file.faces.empty()) return model;
  if (mesh.sources.size() != model.mesh.triangles.size()) throw Failure(subject, "the loader lost its faces");
  for (std::size_t i = 0; i < mesh.sources.size(); ++i) {
    const TriangleSource& source = mesh.sources[i];
    const bool known = source.face < file.faces.size();
    if (!known) throw Failure(subject, "the loader made up a face");
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = source.vertices[k];
      if ((!file.vertex_colours.empty() && vertex >= file.vertex_colours.size()) ||
          (!file.texture_points.empty() && vertex >= file.texture_points.size())) {
        throw Failure(subject, "the loader made up a vertex");
      }
      if (!file.texture_points.empty()) {
        model.mesh.triangles[i][k].texture_point = file.texture_points[vertex];
      }
    }
    const FaceTag& tag = file.faces[source.face];
    model.look_of[i] = tag.look;
    model.mesh.smoothing.push_back(tag.smoothing);
    model.colours.push_back(colour_of(source, tag, file));
  }
  return model;
}

}  // namespace arcspan::tools
