// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/compare/reference.hpp>
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/render/scene.hpp>

#include <string>
#include <utility>
#include <vector>

/// Small scenes that show what the papers say of the methods' artefacts, and what is measured on them.
namespace arcspan::tools {

/// Position of a pixel and its brightness (green, 8-bit steps).
using Profile = std::vector<std::pair<double, double>>;

/// A scene that any shading can draw, seen along -z; the mesh stays with it.
class ArtefactScene {
 public:
  /// One triangle; its normals lean 25 degrees outwards at the corners, so that the middle alone mirrors the
  /// light.
  [[nodiscard]] static ArtefactScene highlight();
  /// A strip of two rectangles with a common upright edge in the picture's middle. Normals turn from -30 over
  /// 0 to +30 degrees; diffuse only, light from the front.
  [[nodiscard]] static ArtefactScene fold();
  /// One triangle whose normals are `apart` degrees from one another, turned by `turn` degrees in the image
  /// plane; the picture's middle always shows the same point of it. Highlight of exponent 16.
  [[nodiscard]] static ArtefactScene turned(double apart, double turn);

  /// The middle row of the picture.
  [[nodiscard]] Profile middle_row(const std::string& shading) const;
  [[nodiscard]] Profile middle_row(ReferenceKind kind) const;
  /// The brightness of the middle pixel.
  [[nodiscard]] double middle(const std::string& shading) const;
  [[nodiscard]] double middle(ReferenceKind kind) const;
  /// The normal that the middle pixel is shaded by, calculated from its brightness under three lights at
  /// right angles: within 0.2 degrees, for that is as far as 8 bits go.
  [[nodiscard]] Vec3 middle_normal(const std::string& shading) const;
  [[nodiscard]] Vec3 middle_normal(ReferenceKind kind) const;

 private:
  ArtefactScene(const MeshData& mesh, Scene scene);
  [[nodiscard]] Image drawn(const std::string& shading, const Scene& scene) const;
  [[nodiscard]] ReferencePicture reference(ReferenceKind kind) const;

  FixedMesh mesh_;
  Scene scene_;
};

/// The brightest pixel.
[[nodiscard]] double peak(const Profile& profile);

/// Mach bands: the slope of the profile right of `x` less that left of it, over `reach` pixels each, in steps
/// a pixel. Zero where the brightness has no kink.
[[nodiscard]] double kink(const Profile& profile, double x, int reach);

/// How much one point changes while the picture is turned by 360 degrees in steps of 5.
struct RotationSpread {
  double steps = 0;    ///< brightest less darkest, 8-bit steps
  double degrees = 0;  ///< largest angle between two of the normals it is shaded by
};
[[nodiscard]] RotationSpread rotation_spread(const std::string& shading, double apart);
[[nodiscard]] RotationSpread rotation_spread(ReferenceKind kind, double apart);

}  // namespace arcspan::tools
