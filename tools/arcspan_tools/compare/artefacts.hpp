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
  /// The same strip with a right rectangle of 0.3 times the width, so that normals turn faster there, lit at
  /// 45 degrees from the right: the brightness rises through the edge, and its slope changes there by any
  /// method.
  [[nodiscard]] static ArtefactScene narrow_fold();
  /// A disc whose middle vertex has a normal that mirrors the light. Its ten neighbours are 1 and 0.4 away in
  /// turn; normals lean as on a paraboloid, so that the exact highlight is a circle.
  [[nodiscard]] static ArtefactScene star();
  /// A sphere of 12 x 6, turned by `turn` degrees about its axis, lit from the front: the highlight stays
  /// where it is on the screen while vertices pass through it.
  [[nodiscard]] static ArtefactScene turning_sphere(double turn);
  /// The polygon of S1's figure 26.3: corners Q on top, R and S at the bottom, and P between them where the
  /// outline turns inwards. Its normals are such that P is dark and the others are bright. Two triangles that
  /// share the edge PQ.
  [[nodiscard]] static ArtefactScene concave();
  /// One triangle whose normals are `apart` degrees from one another, turned by `turn` degrees in the image
  /// plane; the picture's middle always shows the same point of it. Highlight of exponent 16.
  [[nodiscard]] static ArtefactScene turned(double apart, double turn);

  /// The whole picture.
  [[nodiscard]] Image picture(const std::string& shading) const { return drawn(shading, scene_); }
  [[nodiscard]] Image picture(ReferenceKind kind) const;

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

/// The brightest pixel of a picture (green).
[[nodiscard]] double peak(const Image& picture);

/// The shape of the highlight in the picture's middle: the largest distance from there at which the
/// brightness falls below half of the middle's, divided by the least. 1 for a circle.
[[nodiscard]] double highlight_elongation(const Image& picture);

/// The largest difference between two pixels above one another in column x (green), where both are brighter
/// than the background (0), and the row of the lower one.
struct ColumnStep {
  double steps = 0;
  std::int32_t row = 0;
};
[[nodiscard]] ColumnStep largest_step(const Image& picture, std::int32_t x);

/// How the brightest pixel of turning_sphere() changes while the sphere turns by the angle of one segment, in
/// steps of a degree: brightest less darkest, 8-bit steps.
[[nodiscard]] double flicker(const std::string& shading);
[[nodiscard]] double flicker(ReferenceKind kind);

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
