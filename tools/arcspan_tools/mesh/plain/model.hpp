// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/texture/texture.hpp>

#include <arcspan_tools/image/rgba_image.hpp>
#include <arcspan_tools/mesh/plain/mesh_data.hpp>
#include <arcspan_tools/mesh/plain/rig.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// How the opacity of a texture is meant.
enum class AlphaMode : std::uint8_t {
  kOpaque,  ///< not at all
  kMask,    ///< texels below FileMaterial::alpha_cutoff are not drawn
  kBlend    ///< as the share of the surface in what is seen
};

/// A picture that a model file maps onto its surfaces.
struct FileTexture {
  std::string name{};  ///< of its file, or of the file that it is in
  RgbaImage picture{};
  /// The mip levels below `picture` that the file stores; none of them if it has one level. Only model
  /// binaries store levels: without a value they are computed from `picture`.
  std::optional<std::vector<RgbaImage>> smaller{};
};

/// The look of a surface as a model file states it. Colours are display values 0...1 per channel, 1 being a
/// channel of 255 (docs/conventions.md). Unset members are left to the options of the command.
struct FileMaterial {
  std::string name{};
  std::optional<Vec3> colour{};                  ///< of diffuse light
  std::optional<Vec3> ambient_colour{};          ///< of ambient light; `colour` if unset
  std::optional<Vec3> specular{};                ///< of the highlight; black means none
  std::optional<std::int32_t> shininess{};       ///< exponent of the highlight, 1...256
  Vec3 emission{};                               ///< added to every pixel
  bool unlit = false;                            ///< the colour is shown as it is, without light
  bool two_sided = false;                        ///< back faces are drawn too
  std::shared_ptr<const FileTexture> texture{};  ///< multiplies `colour`; null if there is none
  TextureSampler sampler{};                      ///< of the texture
  AlphaMode alpha_mode = AlphaMode::kOpaque;     ///< of the texture
  double alpha_cutoff = 0.5;
  double opacity = 1;  ///< of the whole surface, 0...1

  friend bool operator==(const FileMaterial&, const FileMaterial&) = default;
};

/// kOpaque for a picture without transparent pixels, kMask if all are opaque or fully transparent, else
/// kBlend.
[[nodiscard]] AlphaMode alpha_mode_of(const RgbaImage& picture);

/// What the triangles of a part have in common.
struct PartLook {
  /// Names of the object, mesh and groups that the part belongs to, by which it can be selected.
  std::vector<std::string> names{};
  FileMaterial material{};

  friend bool operator==(const PartLook&, const PartLook&) = default;
};

/// A part of a model: the triangles of one group with one material.
struct ModelPart {
  PartLook look{};
  MeshData mesh{};
};

/// A model binary that moves, from which a model was read.
struct MovingBinary {
  std::vector<std::uint32_t> words{};  ///< the file, in words for its alignment
  std::size_t bytes = 0;
  std::vector<std::size_t> part_numbers{};  ///< in the binary, of each part of the model
};

/// The contents of a model file: parts in one coordinate system.
struct Model {
  std::vector<ModelPart> parts{};
  /// Faces of the file that have no area, left out of the parts.
  std::size_t dropped_faces = 0;
  /// Set if the file leaves normals open: edges above so many degrees are sharp.
  std::optional<double> crease_degrees{};
  /// A line for each kind of content of the file that is not drawn, such as its textures.
  std::vector<std::string> warnings{};
  /// What moves the vertices; null if nothing does. They are where it is at rest.
  std::shared_ptr<const Rig> rig{};
  /// The model binary whose joints or morph targets move the vertices, which are where it stores them; null
  /// if the model is none, or nothing moves.
  std::shared_ptr<const MovingBinary> binary{};
  /// Set if the vertices are where the rig stores them: around them in all poses.
  std::optional<Box> reach{};
  /// Curves over outlines shall fit the 16 bits of positions, too.
  bool has_curves = false;

  [[nodiscard]] std::size_t vertex_count() const;
  [[nodiscard]] std::size_t triangle_count() const;
};

/// The colours of a triangle's corners, display values 0...1.
struct TriangleColour {
  bool known = false;
  std::array<Vec3, 3> corners{};
};

/// The triangles of a model as loaders give them.
struct RawModel {
  RawMesh mesh{};
  std::vector<PartLook> looks{};
  /// For each triangle an index into `looks`.
  std::vector<std::uint32_t> look_of{};
  std::vector<std::string> warnings{};
  /// Empty, or the colours of each triangle; not yet part of mesh or looks.
  std::vector<TriangleColour> colours{};
  /// What moves the corners; null if nothing does.
  std::shared_ptr<const Rig> rig{};
};

/// Which parts of a model keep their texture points. Vertices are split where these differ.
enum class TexturePointsOf : std::uint8_t { kTexturedParts, kAllParts };

/// How a triangle whose vertices differ in colour is drawn: in the mean of the colours (kMean), or with the
/// colours interpolated (kKept).
enum class VertexColours : std::uint8_t { kMean, kKept };

/// Joins corners into vertices as weld() does, part by part and with texture points; normals are averaged
/// across parts. Parts without triangles are left out. The limit of vertices holds for each part that
/// moves, that of triangles for the model. The texture of a part that has no texture points, or some that are
/// more than kMostTextures apart or half of it away from a clamped texture, is left out, with a warning.
/// Texture points must be finite.
[[nodiscard]] Model weld_parts(const RawModel& raw, const std::string& subject,
                               TexturePointsOf points = TexturePointsOf::kTexturedParts);

/// The model of a mesh without materials.
[[nodiscard]] Model to_model(MeshData mesh);

/// The triangles of a model, with the normals of their corners and without its rig.
[[nodiscard]] RawModel to_raw(const Model& model);

/// The parts that have `name` among their names. Throws a Failure about `subject` that lists the names if
/// there is none.
[[nodiscard]] Model select_parts(Model model, const std::string& name, const std::string& subject);

}  // namespace arcspan::tools
