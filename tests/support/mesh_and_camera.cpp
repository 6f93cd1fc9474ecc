// SPDX-License-Identifier: MIT
#include <tests/support/mesh_and_camera.hpp>

#include <cstdlib>

namespace arcspan::test {

std::uint16_t TestMesh::add(Vec3 position, Vec3 normal) {
  const auto whole = [](double v) { return static_cast<std::int16_t>(std::lround(v)); };
  const auto big = [](double v) { return static_cast<std::int32_t>(std::lround(v * (1 << 28))); };
  positions.push_back({whole(position.x), whole(position.y), whole(position.z)});
  normals.push_back(pack_normal(big(normal.x), big(normal.y), big(normal.z)));
  return static_cast<std::uint16_t>(positions.size() - 1);
}

void TestMesh::triangle(std::uint16_t a, std::uint16_t b, std::uint16_t c) {
  indices.insert(indices.end(), {a, b, c});
}

MeshView TestMesh::view() const {
  MeshView view;
  const std::span<const std::uint16_t> triangles(indices);
  if (!ok(MeshView::make(positions, normals, triangles, view))) std::abort();
  return view;
}

TestMesh TestMesh::inside_out() const {
  TestMesh turned = *this;
  for (std::size_t i = 0; i < turned.indices.size(); i += 3)
    std::swap(turned.indices[i + 1], turned.indices[i + 2]);
  for (PackedNormal& normal : turned.normals) {
    const Direction n = unpack_normal(normal);
    normal = pack_normal(-n.x.raw(), -n.y.raw(), -n.z.raw());
  }
  return turned;
}

TestMesh make_sphere(int rings, int segments, double radius, double jitter, Random& random) {
  TestMesh mesh;
  const auto place = [&](Vec3 n) { return mesh.add(radius * (1 - jitter * random.unit()) * n, n); };
  const std::uint16_t top = place({0, 1, 0});
  std::vector<std::uint16_t> ring;
  for (int i = 1; i < rings; ++i) {
    for (int j = 0; j < segments; ++j) {
      const double theta = std::numbers::pi * i / rings;
      const double phi = 2 * std::numbers::pi * j / segments;
      ring.push_back(
          place({std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi)}));
    }
  }
  const std::uint16_t bottom = place({0, -1, 0});
  const auto at = [&](int i, int j) {
    return ring[static_cast<std::size_t>((i - 1) * segments + j % segments)];
  };
  for (int j = 0; j < segments; ++j) {
    mesh.triangle(top, at(1, j), at(1, j + 1));
    for (int i = 1; i + 1 < rings; ++i) {
      mesh.triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
    mesh.triangle(at(rings - 1, j), bottom, at(rings - 1, j + 1));
  }
  return mesh;
}

TestMesh make_smooth_cube(double half_edge) {
  TestMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner{(i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0};
    mesh.add(half_edge * corner, normalised(corner));
  }
  const std::uint16_t faces[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                     {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
  for (const auto& f : faces) {
    mesh.triangle(f[0], f[1], f[2]);
    mesh.triangle(f[0], f[2], f[3]);
  }
  return mesh;
}

TestMesh make_smooth_tetrahedron(double half_edge) {
  TestMesh mesh;
  const Vec3 corners[4] = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
  for (const Vec3 corner : corners) mesh.add(half_edge * corner, normalised(corner));
  mesh.triangle(0, 2, 1);
  mesh.triangle(0, 1, 3);
  mesh.triangle(0, 3, 2);
  mesh.triangle(1, 2, 3);
  return mesh;
}

Vec3 TestCamera::to_view(Vec3 point) const {
  return Vec3{dot(right, point), dot(up, point), dot(back, point)} + translation;
}

ClipTransform TestCamera::transform() const {
  const auto entry = [](double v) {
    return RotationEntry::from_raw(
        static_cast<std::int32_t>(std::lround(std::ldexp(v, RotationEntry::kFraction))));
  };
  const auto object_length = [](double v) {
    return ObjectLength::from_raw(
        static_cast<std::int32_t>(std::lround(std::ldexp(v, ObjectLength::kFraction))));
  };
  Placement placement;
  const Vec3 rows[3] = {right, up, back};
  const double shift[3] = {translation.x, translation.y, translation.z};
  for (int i = 0; i < 3; ++i) {
    placement.rotation.m[i][0] = entry(rows[i].x);
    placement.rotation.m[i][1] = entry(rows[i].y);
    placement.rotation.m[i][2] = entry(rows[i].z);
    placement.translation[i] = object_length(shift[i]);
  }
  Projection projection;
  projection.focal = PixelLength::from_raw(
      static_cast<std::int32_t>(std::lround(std::ldexp(focal, PixelLength::kFraction))));
  projection.near_plane = object_length(near_plane);
  projection.far_plane = object_length(far_plane);
  ClipTransform transform;
  if (!ok(ClipTransform::make(placement, projection, {width, height}, transform))) std::abort();
  return transform;
}

void TestCamera::look_in_random_direction(Random& random) {
  back = random_unit(random);
  right = normalised(cross(tilted(random, back, 1.2), back));
  up = cross(back, right);
}

}  // namespace arcspan::test
