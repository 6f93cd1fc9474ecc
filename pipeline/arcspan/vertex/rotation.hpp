// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/formats.hpp>

#include <cstdint>

namespace arcspan {

/// An angle in 65536ths of a full turn; wraps around by itself.
struct Turn {
  std::uint16_t raw = 0;

  friend constexpr Turn operator+(Turn a, Turn b) { return {static_cast<std::uint16_t>(a.raw + b.raw)}; }
  friend constexpr Turn operator-(Turn a) { return {static_cast<std::uint16_t>(-a.raw)}; }
};

/// Sine and cosine, absolute error at most 2^-28 (swept in the tests). For object set-up: 64-bit products.
[[nodiscard]] RotationEntry sine(Turn angle);
[[nodiscard]] RotationEntry cosine(Turn angle);

/// A rotation of object space into view space: rows are the view's axes in object space.
struct Rotation {
  RotationEntry m[3][3];

  /// No rotation. (1 itself does not leave room for a sum, so unit entries are 1 - 2^-30.)
  [[nodiscard]] static Rotation identity();
  /// Right-handed rotations about the axes of the space they are applied in.
  [[nodiscard]] static Rotation about_x(Turn angle);
  [[nodiscard]] static Rotation about_y(Turn angle);
  [[nodiscard]] static Rotation about_z(Turn angle);

  /// First `b`, then `a`.
  friend Rotation operator*(const Rotation& a, const Rotation& b);

  /// A view-space direction (a light, the eye) in object space: the transpose applied, normalised.
  [[nodiscard]] Direction to_object(const Direction& view) const;
};

}  // namespace arcspan
