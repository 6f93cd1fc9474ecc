// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/node_transform.hpp>

#include <array>

namespace arcspan::tools {
namespace {

/// The quaternion of a rotation's columns, from the largest of the four sums of its diagonal, whose root
/// loses no digits.
Quaternion quaternion_of(Vec3 x, Vec3 y, Vec3 z) {
  const std::array<double, 4> sums = {1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z,
                                      1 + x.x + y.y + z.z};
  std::size_t largest = 0;
  for (std::size_t i = 1; i < sums.size(); ++i) largest = sums[i] > sums[largest] ? i : largest;
  const double a = y.z - z.y;
  const double b = z.x - x.z;
  const double c = x.y - y.x;
  const double xy = x.y + y.x;
  const double xz = x.z + z.x;
  const double yz = y.z + z.y;
  switch (largest) {
    case 0:
      return unit_length(Quaternion{sums[0], xy, xz, a});
    case 1:
      return unit_length(Quaternion{xy, sums[1], yz, b});
    case 2:
      return unit_length(Quaternion{xz, yz, sums[2], c});
    default:
      return unit_length(Quaternion{a, b, c, sums[3]});
  }
}

}  // namespace

std::optional<NodeTransform> split(const Affine& affine) {
  constexpr double kStraight = 1e-4;  // the matrices of files are floats
  NodeTransform out;
  out.translation = affine.translation;
  out.scale = {length(affine.x), length(affine.y), length(affine.z)};
  if (!(out.scale.x > 0 && out.scale.y > 0 && out.scale.z > 0)) return std::nullopt;
  if (affine.mirrors()) out.scale.x = -out.scale.x;
  const Vec3 x = affine.x * (1 / out.scale.x);
  const Vec3 y = affine.y * (1 / out.scale.y);
  const Vec3 z = affine.z * (1 / out.scale.z);
  for (const double cosine : {dot(x, y), dot(y, z), dot(z, x)}) {
    if (!(std::abs(cosine) <= kStraight)) return std::nullopt;
  }
  out.rotation = quaternion_of(x, y, z);
  return out;
}

}  // namespace arcspan::tools
