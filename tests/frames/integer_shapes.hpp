// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/make_face_planes.hpp>
#include <arcspan/mesh/mesh_view.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// Meshes made by the compiler, in integers, so that they are the same bits on every host and lie in flash.
namespace arcspan::scenes {

/// Object units of a sphere's radius and of a torus' outer radius.
inline constexpr std::int32_t kRadius = 16384;

/// sin(turn * 2 pi / 2^32) with 30 fraction bits, error below 2^-27: quadrant folding and Taylor's series to
/// x^11.
constexpr std::int64_t sine30(std::uint32_t turn) {
  const bool negative = turn >= 0x80000000u;
  std::uint32_t half = turn & 0x7FFFFFFFu;
  if (half > 0x40000000u) half = 0x80000000u - half;
  // A quarter turn is 2^30; x = half * pi / 2 with 30 fraction bits.
  const std::int64_t x = (std::int64_t{half} * 1686629713) >> 30;
  const std::int64_t square = (x * x) >> 30;
  std::int64_t term = x;
  std::int64_t sum = x;
  for (std::int64_t n = 2; n <= 12; n += 2) {
    term = -((term * square) >> 30) / (n * (n + 1));
    sum += term;
  }
  return negative ? -sum : sum;
}
constexpr std::int64_t cosine30(std::uint32_t turn) { return sine30(turn + 0x40000000u); }

/// The octahedral map of PackedNormal for a vector with 30 fraction bits, by the rounding of pack_normal().
constexpr PackedNormal packed(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto magnitude = [](std::int64_t v) { return v < 0 ? -v : v; };
  const std::int64_t sum = magnitude(x) + magnitude(y) + magnitude(z);
  const auto scaled = [sum](std::int64_t c) {
    return (c * 32767 >= 0 ? c * 32767 + sum / 2 : c * 32767 - sum / 2) / sum;
  };
  std::int64_t u = scaled(x);
  std::int64_t v = scaled(y);
  if (z < 0) {
    const std::int64_t folded = 32767 - magnitude(v);
    const std::int64_t other = 32767 - magnitude(u);
    u = u < 0 ? -folded : folded;
    v = v < 0 ? -other : other;
  }
  return {static_cast<std::int16_t>(u), static_cast<std::int16_t>(v)};
}

template <std::size_t Vertices, std::size_t Triangles>
struct Shape {
  std::array<ObjectPosition, Vertices> positions;
  std::array<PackedNormal, Vertices> normals;
  std::array<std::uint16_t, 3 * Triangles> indices;

  constexpr void vertex(std::size_t i, std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto rounded = [](std::int64_t v) {
      return static_cast<std::int16_t>((v + (std::int64_t{1} << 15)) >> 16);
    };
    positions[i] = {rounded(x), rounded(y), rounded(z)};
  }
  constexpr void triangle(std::size_t i, std::size_t a, std::size_t b, std::size_t c) {
    indices[3 * i] = static_cast<std::uint16_t>(a);
    indices[3 * i + 1] = static_cast<std::uint16_t>(b);
    indices[3 * i + 2] = static_cast<std::uint16_t>(c);
  }
  [[nodiscard]] constexpr Status view(MeshView& mesh) const {
    return MeshView::make(positions, normals, std::span<const std::uint16_t>(indices), mesh);
  }
};

/// The planes of a shape's triangles.
template <std::size_t Triangles>
struct Planes {
  std::array<FacePlane, Triangles> planes;
  PlaneScale scale;

  [[nodiscard]] constexpr Status attach_to(MeshView& mesh) const { return mesh.attach(planes, scale); }
};

template <std::size_t Vertices, std::size_t Triangles>
[[nodiscard]] consteval Planes<Triangles> planes_of(const Shape<Vertices, Triangles>& shape) {
  Planes<Triangles> made{};
  MeshView mesh;
  if (!ok(shape.view(mesh)) || !ok(make_face_planes(mesh, made.planes, made.scale))) {
    detail::refused::constant_refused();
  }
  return made;
}

/// Writes a UV sphere of radius kRadius with its poles on the y axis; poles and seam shared, smooth normals.
/// It has sectors * (stacks - 1) + 2 vertices and 2 * sectors * (stacks - 1) triangles, the first ones of
/// `shape`.
template <std::size_t Vertices, std::size_t Triangles>
constexpr void set_sphere(std::uint32_t sectors, std::uint32_t stacks, Shape<Vertices, Triangles>& shape) {
  std::size_t v = 0;
  const auto add = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    shape.normals[v] = packed(x, y, z);
    shape.vertex(v++, x, y, z);  // 30 fraction bits, 16 dropped: 2^14 units
  };
  add(0, std::int64_t{1} << 30, 0);
  for (std::uint32_t stack = 1; stack < stacks; ++stack) {
    const auto polar = static_cast<std::uint32_t>((std::uint64_t{stack} << 31) / stacks);
    for (std::uint32_t sector = 0; sector < sectors; ++sector) {
      const auto around = static_cast<std::uint32_t>((std::uint64_t{sector} << 32) / sectors);
      const std::int64_t ring = sine30(polar);
      add((ring * sine30(around)) >> 30, cosine30(polar), (ring * cosine30(around)) >> 30);
    }
  }
  add(0, -(std::int64_t{1} << 30), 0);
  std::size_t t = 0;
  const auto per_ring = static_cast<std::size_t>(sectors);
  for (std::size_t s = 0; s < per_ring; ++s) {
    const std::size_t next = (s + 1) % per_ring;
    shape.triangle(t++, 0, 1 + s, 1 + next);
    for (std::size_t r = 0; r + 2 < stacks; ++r) {
      const std::size_t upper = 1 + r * per_ring;
      const std::size_t lower = upper + per_ring;
      shape.triangle(t++, upper + s, lower + s, lower + next);
      shape.triangle(t++, upper + s, lower + next, upper + next);
    }
    const std::size_t last = v - 1 - per_ring;
    shape.triangle(t++, last + s, v - 1, last + next);
  }
}

/// The sphere of set_sphere() as a constant.
template <std::uint32_t Sectors, std::uint32_t Stacks>
consteval auto make_sphere() {
  Shape<Sectors*(Stacks - 1) + 2, 2 * Sectors*(Stacks - 1)> shape{};
  set_sphere(Sectors, Stacks, shape);
  return shape;
}

/// A cube with edges of kRadius and a normal per face: 4 vertices for each of its 6 faces.
consteval auto make_cube() {
  Shape<24, 12> shape{};
  constexpr std::int64_t kHalf = std::int64_t{1} << 29;
  std::size_t v = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const std::int64_t side : {-kHalf, kHalf}) {
      for (const std::int64_t corner : {0, 1, 2, 3}) {  // around the face
        const std::int64_t along = corner == 1 || corner == 2 ? side : -side;
        const std::int64_t across = corner >= 2 ? kHalf : -kHalf;
        std::int64_t p[3] = {};
        std::int64_t normal[3] = {};
        p[axis] = normal[axis] = side;
        p[(axis + 1) % 3] = along;
        p[(axis + 2) % 3] = across;
        shape.normals[v + static_cast<std::size_t>(corner)] = packed(normal[0], normal[1], normal[2]);
        shape.vertex(v + static_cast<std::size_t>(corner), p[0], p[1], p[2]);
      }
      shape.triangle(v / 2, v, v + 1, v + 2);
      shape.triangle(v / 2 + 1, v, v + 2, v + 3);
      v += 4;
    }
  }
  return shape;
}

/// A torus about the y axis, outer radius kRadius, its tube 3/8 of the ring's radius.
template <std::size_t Sectors, std::size_t Sides>
consteval auto make_torus() {
  Shape<Sectors * Sides, 2 * Sectors * Sides> shape{};
  constexpr std::int64_t kRing = (std::int64_t{1} << 30) * 8 / 11;
  std::size_t t = 0;
  for (std::size_t sector = 0; sector < Sectors; ++sector) {
    const auto around = static_cast<std::uint32_t>((std::uint64_t{sector} << 32) / Sectors);
    for (std::size_t side = 0; side < Sides; ++side) {
      const auto tube = static_cast<std::uint32_t>((std::uint64_t{side} << 32) / Sides);
      const std::int64_t nx = (cosine30(tube) * sine30(around)) >> 30;
      const std::int64_t nz = (cosine30(tube) * cosine30(around)) >> 30;
      const std::int64_t from_axis = kRing + cosine30(tube) * 3 / 11;
      const std::size_t v = sector * Sides + side;
      shape.normals[v] = packed(nx, sine30(tube), nz);
      shape.vertex(v, (from_axis * sine30(around)) >> 30, sine30(tube) * 3 / 11,
                   (from_axis * cosine30(around)) >> 30);
      const std::size_t right = (sector + 1) % Sectors * Sides;
      const std::size_t up = (side + 1) % Sides;
      shape.triangle(t++, v, right + side, right + up);
      shape.triangle(t++, v, right + up, sector * Sides + up);
    }
  }
  return shape;
}

}  // namespace arcspan::scenes
