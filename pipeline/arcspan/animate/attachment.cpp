// SPDX-License-Identifier: MIT
#include <arcspan/animate/attachment.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/unit_vector.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace {

/// Components below 2^30 in magnitude.
std::array<std::int64_t, 3> cross(const std::array<std::int64_t, 3>& a,
                                  const std::array<std::int64_t, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::array<std::int64_t, 3> widened(const std::array<std::int32_t, 3>& v) { return {v[0], v[1], v[2]}; }

std::array<std::int64_t, 3> column(const NodeMatrix& matrix, std::size_t j) {
  return {matrix.entries[0][j], matrix.entries[1][j], matrix.entries[2][j]};
}

/// The axes of a node at right angles.
Rotation rotation_of(const NodeMatrix& node) {
  const std::array<std::int32_t, 3> x = unit_vector30<3>(column(node, 0));
  const std::array<std::int32_t, 3> z = unit_vector30<3>(cross(column(node, 0), column(node, 1)));
  if (is_zero(x) || is_zero(z)) return Rotation::identity();
  // x and z are at right angles, so their product has unit length but for rounding.
  const std::array<std::int32_t, 3> y = unit_vector30<3>(cross(widened(z), widened(x)));
  Rotation rotation{};
  for (std::size_t i = 0; i < 3; ++i) {
    rotation.m[i][0] = detail::rotation_entry(x[i]);
    rotation.m[i][1] = detail::rotation_entry(y[i]);
    rotation.m[i][2] = detail::rotation_entry(z[i]);
  }
  return rotation;
}

}  // namespace

Placement attached(const Placement& body, const NodeMatrix& node) {
  Placement placement{body.rotation * rotation_of(node), {}};
  for (std::size_t i = 0; i < 3; ++i) {
    std::int64_t sum = std::int64_t{body.translation[i].raw()} << RotationEntry::kFraction;
    for (std::size_t j = 0; j < 3; ++j)
      sum += std::int64_t{body.rotation.m[i][j].raw()} * node.offset[j].raw();
    placement.translation[i] = ObjectLength::from_raw(limited(sum >> RotationEntry::kFraction, INT32_MAX));
  }
  return placement;
}

}  // namespace arcspan
