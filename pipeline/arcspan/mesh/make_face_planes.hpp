// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/face_normal.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/root.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

namespace detail {

/// |v|^2.
[[nodiscard]] constexpr std::int64_t squared_length(const ObjectVector& v) {
  return std::int64_t{v.x} * v.x + std::int64_t{v.y} * v.y + std::int64_t{v.z} * v.z;
}

/// value / 2^bits, rounded to nearest.
[[nodiscard]] constexpr std::int64_t rounded_down(std::int64_t value, int bits) {
  return bits == 0 ? value : (value + (std::int64_t{1} << (bits - 1))) >> bits;
}

/// A triangle's plane before it is rounded to bytes, 16 more fraction bits.
struct FinePlane {
  WideVector normal;
  std::int64_t offset;
};

/// The plane of a triangle as FacePlane defines it, for `normal_bits` and offset_bits = 0. The error of the
/// root scales normal and offset alike, which does not move the plane.
[[nodiscard]] constexpr FinePlane fine_plane(const MeshView& mesh, std::size_t triangle, int normal_bits) {
  const TriangleIndices t = mesh.triangle(triangle);
  const ObjectPosition& a = mesh.position(t.a);
  const ObjectVector u = vector_to(mesh.position(t.b), a);
  const ObjectVector v = vector_to(mesh.position(t.c), a);
  const std::int64_t sides[3] = {squared_length(u), squared_length(v),
                                 squared_length(vector_to(mesh.position(t.c), mesh.position(t.b)))};
  std::int64_t longest = sides[0] > sides[1] ? sides[0] : sides[1];
  if (sides[2] > longest) longest = sides[2];
  if (longest == 0) return {};
  // Below 2^36. The shift is even, so that the root is shifted by half of it.
  const int shift = longest >> 32 != 0 ? 4 : 0;
  const ReciprocalRoot root = reciprocal_root(static_cast<std::uint32_t>(longest >> shift));
  const int down = root.exponent + shift / 2 - 16 - normal_bits;
  // |u x v| is twice the area; divided by the longest side it is the least altitude.
  const auto scaled = [&](std::int64_t component) {
    const std::int64_t product = component * root.mantissa;  // below 2^52
    return down >= 0 ? rounded_down(product, down) : product * (std::int64_t{1} << -down);
  };
  const WideVector along = cross(u, v);
  const WideVector normal{scaled(along.x), scaled(along.y), scaled(along.z)};
  return {normal, normal.x * a.x + normal.y * a.y + normal.z * a.z};
}

/// max(most, |v|).
[[nodiscard]] constexpr std::int64_t larger_magnitude(std::int64_t most, std::int64_t v) {
  const std::int64_t magnitude = v < 0 ? -v : v;
  return magnitude > most ? magnitude : most;
}

/// The largest normal_bits with which every normal fits a byte.
[[nodiscard]] constexpr int plane_normal_bits(const MeshView& mesh) {
  std::int64_t most = 0;  // largest component of a normal, 16 fraction bits, below 2^34
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const WideVector normal = fine_plane(mesh, i, 0).normal;
    most = larger_magnitude(larger_magnitude(larger_magnitude(most, normal.x), normal.y), normal.z);
  }
  constexpr int kSpare = -PlaneScale::kLeastNormalBits;
  int bits = PlaneScale::kMostNormalBits;
  while (most << (bits + kSpare) > std::int64_t{127} << (16 + kSpare)) --bits;
  return bits;
}

/// The least offset_bits with which every offset fits a byte.
[[nodiscard]] constexpr int plane_offset_bits(const MeshView& mesh, int normal_bits) {
  std::int64_t most = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    most = larger_magnitude(most, fine_plane(mesh, i, normal_bits).offset);
  }
  int bits = 0;
  while (rounded_down(most, 16 + bits) > 127) ++bits;
  return bits;
}

/// The distance of the farthest vertex from the object's origin, rounded up to a whole unit or one more.
[[nodiscard]] constexpr std::uint16_t radius_of(const MeshView& mesh) {
  std::uint32_t most = 0;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const std::uint32_t squared = squared_distance(mesh.position(i));
    if (squared > most) most = squared;
  }
  return static_cast<std::uint16_t>(integer_root(most) + 1);
}

}  // namespace detail

/// Writes the planes of a mesh's triangles to `memory` and their scale to `scale`, for MeshView::attach().
/// Takes a few hundred instructions per triangle, and is usually called by a tool or in a constant
/// expression.
///
/// Returns kBufferTooSmall if `memory` has fewer elements than the mesh has triangles; nothing is changed
/// then.
constexpr Status make_face_planes(const MeshView& mesh, std::span<FacePlane> memory, PlaneScale& scale) {
  if (memory.size() < mesh.triangle_count()) return Status::kBufferTooSmall;
  const int normal_bits = detail::plane_normal_bits(mesh);
  const int offset_bits = detail::plane_offset_bits(mesh, normal_bits);
  const auto byte = [](std::int64_t v, int bits) {
    return static_cast<std::int8_t>(detail::rounded_down(v, bits));
  };
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const detail::FinePlane plane = detail::fine_plane(mesh, i, normal_bits);
    memory[i] = {byte(plane.normal.x, 16), byte(plane.normal.y, 16), byte(plane.normal.z, 16),
                 byte(plane.offset, 16 + offset_bits)};
  }
  scale = {static_cast<std::int8_t>(normal_bits), static_cast<std::uint8_t>(offset_bits),
           detail::radius_of(mesh)};
  return Status::kOk;
}

}  // namespace arcspan
