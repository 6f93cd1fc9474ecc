// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

namespace detail {

/// Where a vertex lies from another, in object units: each below 2^16 in magnitude.
struct ObjectVector {
  std::int32_t x;
  std::int32_t y;
  std::int32_t z;
};

[[nodiscard]] constexpr ObjectVector vector_to(const ObjectPosition& to, const ObjectPosition& from) {
  // Widened first: a difference of 16 bits need not fit the int of an 8-bit machine.
  return {std::int32_t{to.x} - from.x, std::int32_t{to.y} - from.y, std::int32_t{to.z} - from.z};
}

/// u x v.
struct WideVector {
  std::int64_t x;
  std::int64_t y;
  std::int64_t z;
};
[[nodiscard]] constexpr WideVector cross(const ObjectVector& u, const ObjectVector& v) {
  const auto component = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return a * b - c * d;
  };
  return {component(u.y, v.z, u.z, v.y), component(u.z, v.x, u.x, v.z), component(u.x, v.y, u.y, v.x)};
}

/// The unit vector along u x v.
[[nodiscard]] ARCSPAN_OUTLINE constexpr Direction normal_along_wide(const ObjectVector& u,
                                                                    const ObjectVector& v) {
  const WideVector normal = cross(u, v);
  return normalised_wide(normal.x, normal.y, normal.z);
}
/// The same, by products of 32 bits if the components are within 2^15, as a fine mesh's are.
[[nodiscard]] constexpr Direction normal_along(const ObjectVector& u, const ObjectVector& v) {
  const auto raised = [](std::int32_t c) { return static_cast<std::uint32_t>(c + 0x7FFF); };
  if ((raised(u.x) | raised(u.y) | raised(u.z) | raised(v.x) | raised(v.y) | raised(v.z)) > 0xFFFF) {
    return normal_along_wide(u, v);
  }
  return normalised(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
}

}  // namespace detail

/// The unit normal of the triangle a, b, c, counter-clockwise seen from where it points; zero if it has no
/// area.
[[nodiscard]] constexpr Direction face_normal(const ObjectPosition& a, const ObjectPosition& b,
                                              const ObjectPosition& c) {
  return detail::normal_along(detail::vector_to(b, a), detail::vector_to(c, a));
}

}  // namespace arcspan
