// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/reference_method.hpp>
#include <arcspan_tools/plot/worked_example.hpp>

namespace arcspan::tools {
namespace {

/// S1's model: Ia ka + Il (kd N·L + ks (R·S)^n) / (d + K).
double intensity(Vec3 normal) {
  const Vec3 light{0, 0, 1};
  const Vec3 eye = normalised({1, 1, 1});
  const double normal_light = dot(normal, light);
  const Vec3 mirrored = normal * (2 * normal_light) - light;
  const double cosine = dot(mirrored, eye);
  return 1 * 0.15 + 10 * (0.15 * normal_light + 0.8 * cosine * cosine) / (0 + 1);
}

double mix(double a, double b, double t) { return (1 - t) * a + t * b; }

/// The normal at P: Q on AB, R on BC, P between them. `u` and `w` are the weights of A and of B.
Vec3 normal_at_p(ReferenceKind kind, Vec3 a, Vec3 b, Vec3 c, double u = 0.4, double w = 0.7) {
  const Vec3 q = between_normals(kind, b, a, u);
  const Vec3 r = between_normals(kind, c, b, w);
  return between_normals(kind, q, r, 0.5);
}

/// The intensity at P by Gouraud's method, with the same weights.
double intensity_at_p(const std::array<double, 3>& vertices, double u, double w) {
  return mix(mix(vertices[1], vertices[0], u), mix(vertices[2], vertices[1], w), 0.5);
}

}  // namespace

WorkedExample worked_example() {
  const Vec3 n1{0, 0, 2};
  const Vec3 n2{-1, 1.732, 7.5};
  const Vec3 n3{-2.25, 3.897, 10};
  const Vec3 n4{0, 0, 5.5};
  const Vec3 a = normalised(n2 + n3);
  const Vec3 b = normalised(n1 + n2 + n3 + n4);
  const Vec3 c = normalised(n3 + n4);
  WorkedExample example;
  example.flat = intensity(normalised(n3));
  example.vertices = {intensity(a), intensity(b), intensity(c)};
  example.gouraud = intensity_at_p(example.vertices, 0.4, 0.7);
  example.gouraud_as_defined = intensity_at_p(example.vertices, 1 - 0.4, 1 - 0.7);
  example.phong_as_defined =
      intensity(normalised(normal_at_p(ReferenceKind::kPhong, a, b, c, 1 - 0.4, 1 - 0.7)));
  const Vec3 chord = normal_at_p(ReferenceKind::kPhong, a, b, c);
  example.phong_not_normalised = intensity(chord);
  example.phong = intensity(normalised(chord));
  example.arc = intensity(normal_at_p(ReferenceKind::kSlerp, a, b, c));
  return example;
}

}  // namespace arcspan::tools
