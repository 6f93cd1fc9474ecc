// SPDX-License-Identifier: MIT
#include <arcspan/animate/node_matrix.hpp>
#include <arcspan/animate/short_quaternion.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>

namespace arcspan {

namespace {

constexpr int kOneBits = animation_binary::kMatrixBits;

/// Saturated so that a sum of three products of two such numbers fits 64 bits.
std::int32_t saturated(std::int64_t value) { return limited(value, (std::int32_t{1} << 30) - 1); }

/// Sets the entries to the rotation by a quaternion of any length:
///
///   R = 2 / |q|^2 times the matrix of (w^2 + x^2 - |q|^2 / 2, xy - zw, ...)
///
/// No product in it is above |q|^2 / 2 < 2^31 in magnitude.
void set_rotation(const std::int32_t (&q)[4], std::int32_t (&entries)[3][3]) {
  const auto square = [](std::int32_t c) { return static_cast<std::uint32_t>(c * c); };
  const std::uint32_t squares[4] = {square(q[0]), square(q[1]), square(q[2]), square(q[3])};
  const std::uint32_t length = squares[0] + squares[1] + squares[2] + squares[3];  // below 2^32
  const WideReciprocal inverse = wide_reciprocal(length);
  const auto mantissa = static_cast<std::int32_t>(inverse.mantissa - (inverse.mantissa >> 31));
  // Twice the quotient with kOneBits fraction bits.
  const int down = inverse.exponent - 1 - kOneBits;
  const auto quotient = [=](std::int32_t c) {
    return static_cast<std::int32_t>((std::int64_t{c} * mantissa + (std::int64_t{1} << (down - 1))) >> down);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = i == 2 ? 0 : i + 1;
    const std::size_t k = 3 - i - j;
    entries[i][i] = quotient(static_cast<std::int32_t>(squares[3] + squares[i] - (length >> 1)));
    entries[i][j] = quotient(q[i] * q[j] - q[k] * q[3]);
    entries[j][i] = quotient(q[i] * q[j] + q[k] * q[3]);
  }
}

void set_identity(std::int32_t (&entries)[3][3]) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) entries[i][j] = i == j ? std::int32_t{1} << kOneBits : 0;
  }
}

/// Multiplies column j by scale[j].
void scale_columns(const std::int32_t (&scale)[3], std::int32_t (&entries)[3][3]) {
  for (std::size_t j = 0; j < 3; ++j) {
    if (scale[j] == std::int32_t{1} << WorldLength::kFraction) continue;
    for (std::size_t i = 0; i < 3; ++i)
      entries[i][j] = saturated((std::int64_t{entries[i][j]} * scale[j]) >> WorldLength::kFraction);
  }
}

/// `a` + (b - a) * weight / 65536; both are below 2^30 in magnitude.
std::int32_t mixed(std::int32_t a, std::int32_t b, std::uint32_t weight) {
  return a + scaled_down(b - a, weight, 16);
}

}  // namespace

NodePose rest_pose(const StoredNode& node) {
  const StoredRotation& q = node.rotation;
  return {{node.translation.x.raw(), node.translation.y.raw(), node.translation.z.raw()},
          {q.x, q.y, q.z, q.w},
          {node.scale.x, node.scale.y, node.scale.z}};
}

NodePose blended(const NodePose& a, const NodePose& b, std::uint32_t weight) {
  NodePose pose;
  for (std::size_t i = 0; i < 3; ++i) {
    pose.translation[i] = mixed(a.translation[i], b.translation[i], weight);
    pose.scale[i] = mixed(a.scale[i], b.scale[i], weight);
  }
  std::int32_t from[4];
  std::int32_t to[4];
  detail::make_unit(a.rotation, from);
  detail::make_unit(b.rotation, to);
  detail::interpolate(from, to, static_cast<std::int32_t>(weight >> 1), pose.rotation);
  return pose;
}

NodeMatrix matrix_of(const NodePose& pose) {
  NodeMatrix matrix;
  const std::int32_t(&q)[4] = pose.rotation;
  if ((q[0] | q[1] | q[2]) == 0) {
    set_identity(matrix.entries);
  } else {
    set_rotation(q, matrix.entries);
  }
  scale_columns(pose.scale, matrix.entries);
  for (std::size_t i = 0; i < 3; ++i) matrix.offset[i] = ObjectLength::from_raw(pose.translation[i]);
  return matrix;
}

NodeMatrix operator*(const NodeMatrix& outer, const NodeMatrix& inner) {
  NodeMatrix product;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int32_t(&row)[3] = outer.entries[i];
    const auto sum = [&row](std::int32_t x, std::int32_t y, std::int32_t z) {
      return (std::int64_t{row[0]} * x + std::int64_t{row[1]} * y + std::int64_t{row[2]} * z) >> kOneBits;
    };
    for (std::size_t j = 0; j < 3; ++j)
      product.entries[i][j] = saturated(sum(inner.entries[0][j], inner.entries[1][j], inner.entries[2][j]));
    const std::int64_t moved =
        sum(inner.offset[0].raw(), inner.offset[1].raw(), inner.offset[2].raw()) + outer.offset[i].raw();
    product.offset[i] = ObjectLength::from_raw(saturated(moved));
  }
  return product;
}

NodeMatrix matrix_of(const StoredJoint& joint) {
  NodeMatrix matrix;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) matrix.entries[i][j] = joint.rows[i].entries[j];
    matrix.offset[i] = joint.rows[i].offset;
  }
  return matrix;
}

}  // namespace arcspan
