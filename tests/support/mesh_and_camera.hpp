// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <tests/support/vec3.hpp>

#include <cstdint>
#include <vector>

namespace arcspan::test {

/// A mesh that owns its memory.
struct TestMesh {
  std::vector<ObjectPosition> positions;
  std::vector<PackedNormal> normals;
  std::vector<std::uint16_t> indices;

  std::uint16_t add(Vec3 position, Vec3 normal);
  /// Counter-clockwise seen from the front.
  void triangle(std::uint16_t a, std::uint16_t b, std::uint16_t c);
  [[nodiscard]] MeshView view() const;
  /// The same surface seen from its other side: faces turned, normals opposite.
  [[nodiscard]] TestMesh inside_out() const;
};

/// A sphere of rings and segments, poles included; positions jittered by up to `jitter` of the radius.
[[nodiscard]] TestMesh make_sphere(int rings, int segments, double radius, double jitter, Random& random);
/// A cube with one normal per corner: 70 to 109 degrees between neighbours.
[[nodiscard]] TestMesh make_smooth_cube(double half_edge);
/// A regular tetrahedron with one normal per corner: 109 degrees between all.
[[nodiscard]] TestMesh make_smooth_tetrahedron(double half_edge);

/// Camera and object in double precision.
struct TestCamera {
  Vec3 right{1, 0, 0};
  Vec3 up{0, 1, 0};
  Vec3 back{0, 0, 1};  ///< the camera looks along -back
  Vec3 translation{};  ///< view = rotation * object + translation
  double focal = 200;
  double near_plane = 16;
  double far_plane = 200000;
  std::int32_t width = 160;
  std::int32_t height = 120;

  [[nodiscard]] Vec3 to_view(Vec3 point) const;
  [[nodiscard]] ClipTransform transform() const;
  void look_in_random_direction(Random& random);
};

/// White lights from the upper right over the eye's shoulder.
template <std::size_t Lights, Highlight Model>
[[nodiscard]] Illumination<Lights, Model> make_light(const TestCamera& camera) {
  Material material;
  material.ambient = {Coefficient::of(0.1), Coefficient::of(0.1), Coefficient::of(0.1)};
  material.diffuse = {Coefficient::of(0.7), Coefficient::of(0.5), Coefficient::of(0.3)};
  material.specular = {Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5)};
  material.shininess = 24;
  std::array<DirectionalLight, Lights> lights;
  for (std::size_t i = 0; i < Lights; ++i) {
    const double turn = 2.1 * static_cast<double>(i) + 0.7;
    const Vec3 towards = camera.back + 0.8 * (std::cos(turn) * camera.right + std::sin(turn) * camera.up);
    lights[i].towards = to_direction(normalised(towards));
    lights[i].strength = Lights == 1 ? Coefficient::of(1.0) : Coefficient::of(0.6);
  }
  Illumination<Lights, Model> illumination;
  static_cast<void>(
      Illumination<Lights, Model>::make(material, lights, to_direction(camera.back), illumination));
  return illumination;
}

}  // namespace arcspan::test
