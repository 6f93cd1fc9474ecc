// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>

#include <arcspan_tools/fixed_point/fixed_animation.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace arcspan::tools {

/// A mesh as the pipeline takes it. An object unit is `unit` long in the world, the object's origin lies at
/// `centre`; the axes are the world's, so that directions need no change.
struct FixedMesh {
  std::vector<ObjectPosition> positions;
  std::vector<PackedNormal> normals;
  std::vector<std::uint16_t> indices;
  std::vector<FacePlane> planes;  ///< none, or one for each triangle
  PlaneScale plane_scale;
  std::vector<TexturePoint> texture_points;  ///< none, or one for each vertex
  TextureScale texture_scale;
  std::vector<Rgb8> colours;             ///< none, or one for each vertex
  std::vector<std::uint8_t> neighbours;  ///< none, or those of arcspan::MeshNeighbours
  std::vector<std::uint32_t> sources;    ///< none, or for each vertex one of the rig, as in MeshData
  double unit = 1;
  Vec3 centre;

  [[nodiscard]] std::size_t bytes() const {
    return positions.size() * sizeof(ObjectPosition) + normals.size() * sizeof(PackedNormal) +
           indices.size() * sizeof(std::uint16_t) + planes.size() * sizeof(FacePlane) +
           texture_points.size() * sizeof(TexturePoint) + colours.size() * sizeof(Rgb8) + neighbours.size();
  }
  /// Valid as long as this object is; throws Failure if the pipeline does not take it.
  [[nodiscard]] MeshView view(const std::string& subject) const;
};

/// A model as the pipeline takes it: one mesh for each part, several for one of more than kMaxVertices. All
/// meshes have the same unit and centre, so that one transform places them.
struct FixedModel {
  std::vector<FixedMesh> meshes;
  std::vector<PartLook> looks;                        ///< of each mesh
  std::shared_ptr<const Rig> rig{};                   ///< null if the model stands still
  std::shared_ptr<const FixedAnimation> animation{};  ///< what of the rig is stored, once it was made

  [[nodiscard]] std::size_t vertex_count() const;
  [[nodiscard]] std::size_t triangle_count() const;
  [[nodiscard]] std::size_t bytes() const;
};

/// The meshes of a model, one or more, or a single mesh.
class FixedMeshes : public std::span<const FixedMesh> {
 public:
  FixedMeshes(const FixedModel& model) : span(model.meshes) {}  // NOLINT(google-explicit-constructor)
  FixedMeshes(const FixedMesh& mesh) : span(&mesh, 1) {}        // NOLINT(google-explicit-constructor)

  [[nodiscard]] double unit() const { return front().unit; }
  [[nodiscard]] const Vec3& centre() const { return front().centre; }
};

/// The smallest box around both.
[[nodiscard]] Box joined(const Box& a, const Box& b);

/// The smallest box around all parts of `model`.
[[nodiscard]] Box box_of(const Model& model);

/// Centres and scales `mesh` so that its largest extent fills 16 bits, and rounds. Texture points are moved
/// by whole widths and heights of the texture, by even ones where it is mirrored and not at all where it is
/// clamped, so that they have as many fraction bits as possible. They must be in the range of weld_parts();
/// there must be at most kMaxVertices.
[[nodiscard]] FixedMesh to_fixed(const MeshData& mesh);

/// Centres and scales all parts of `model` alike, so that its largest extent, or that of all its poses, and
/// of curves if it has some, fills 16 bits, and rounds.
[[nodiscard]] FixedModel to_fixed(const Model& model);

/// The same for a model within `box`, whose largest extent fills 16 bits.
[[nodiscard]] FixedModel to_fixed(const Model& model, const Box& box);

/// The same mesh with the planes of its triangles; throws as FixedMesh::view() does.
[[nodiscard]] FixedMesh with_planes(FixedMesh mesh, const std::string& subject);

}  // namespace arcspan::tools
