// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

namespace detail {

/// The difference of two vertex positions in object units, each component below 2^16 in magnitude.
struct ObjectVector {
  std::int32_t x;
  std::int32_t y;
  std::int32_t z;
};

[[nodiscard]] constexpr ObjectVector vector_to(const ObjectPosition& to, const ObjectPosition& from) {
  // Widened first, because a difference of two 16-bit numbers need not fit the int of an 8-bit machine.
  return {std::int32_t{to.x} - from.x, std::int32_t{to.y} - from.y, std::int32_t{to.z} - from.z};
}

/// A vector of products, as cross() returns.
struct WideVector {
  std::int64_t x;
  std::int64_t y;
  std::int64_t z;
};
/// The cross product u x v, exact.
[[nodiscard]] constexpr WideVector cross(const ObjectVector& u, const ObjectVector& v) {
  const auto component = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return a * b - c * d;
  };
  return {component(u.y, v.z, u.z, v.y), component(u.z, v.x, u.x, v.z), component(u.x, v.y, u.y, v.x)};
}

/// The unit vector along u x v, by 64-bit products.
[[nodiscard]] ARCSPAN_OUTLINE constexpr Direction normal_along_wide(const ObjectVector& u,
                                                                    const ObjectVector& v) {
  const WideVector normal = cross(u, v);
  return wide_unit_along(normal.x, normal.y, normal.z, nearly_normalised);
}
/// The unit vector along u x v, by 32-bit products if all components are below 2^15 in magnitude, as in fine
/// meshes.
[[nodiscard]] constexpr Direction normal_along(const ObjectVector& u, const ObjectVector& v) {
  const auto raised = [](std::int32_t c) { return static_cast<std::uint32_t>(c + 0x7FFF); };
  if ((raised(u.x) | raised(u.y) | raised(u.z) | raised(v.x) | raised(v.y) | raised(v.z)) > 0xFFFF) {
    return normal_along_wide(u, v);
  }
  return nearly_normalised(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
}

}  // namespace detail

/// The nearly_normalised() normal of the triangle a, b, c, pointing to the side from which the vertices are
/// counter-clockwise. Zero if the triangle has no area.
[[nodiscard]] constexpr Direction face_normal(const ObjectPosition& a, const ObjectPosition& b,
                                              const ObjectPosition& c) {
  return detail::normal_along(detail::vector_to(b, a), detail::vector_to(c, a));
}

}  // namespace arcspan
