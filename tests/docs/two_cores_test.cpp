// SPDX-License-Identifier: MIT
// Two threads draw the bands of docs/bands.md; together they are the picture drawn at once.
#include "two_cores.hpp"

#include <cstddef>
#include <iterator>
#include <thread>

// An octahedron.
constexpr ObjectPosition kCorners[] = {{9000, 0, 0},  {-9000, 0, 0}, {0, 9000, 0},
                                       {0, -9000, 0}, {0, 0, 9000},  {0, 0, -9000}};
constexpr std::uint8_t kTriangles[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                       2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

PackedNormal normals[6];

Status set_up() {
  for (std::size_t i = 0; i < 6; ++i) {
    normals[i] = pack_normal(kCorners[i].x, kCorners[i].y, kCorners[i].z);
  }
  Placement placement{Rotation::about_x({4000}) * Rotation::about_y({5000}), {}};
  placement.translation[2] = ObjectLength::of(-30000);
  const Projection projection{PixelLength::of(140), ObjectLength::of(1000), ObjectLength::of(60000)};
  Status status = MeshView::make(kCorners, normals, kTriangles, shared.mesh);
  if (ok(status)) status = ClipTransform::make(placement, projection, {kWidth, kHeight}, shared.transform);
  const Material grey{{}, {Coefficient::of(0.7), Coefficient::of(0.7), Coefficient::of(0.7)}, {}, 16};
  const DirectionalLight sun{placement.rotation.to_object(normalised(3, 4, 5))};
  Light light;
  if (ok(status)) status = Light::make(grey, {sun}, placement.rotation.to_object(normalised(0, 0, 1)), light);
  if (!ok(status)) return status;
  shared.lighting = Method::Lighting(light);
  return shared.cache.fill(shared.mesh, shared.transform, shared.lighting);
}

// Compares the bands with the picture drawn at once.
bool is_the_whole_picture() {
  static Band::Word whole_memory[Band::words(kWidth, kHeight)];
  static std::uint16_t depth_memory[DepthBuffer::words(kWidth, kHeight)];
  Band whole(whole_memory, kWidth, kHeight);
  DepthBuffer depth(depth_memory, kWidth, kHeight);
  whole.clear({0, 0, 40});
  depth.clear();
  const DrawResult drawn = draw_mesh<Method>(shared.mesh, shared.transform, shared.lighting, whole, depth);
  bool same = ok(drawn.status) && drawn.triangles > 0;
  for (std::size_t i = 0; i < std::size(picture); ++i) same = same && picture[i] == whole_memory[i];
  return same;
}

int main() {
  if (!ok(set_up())) return 1;
  Status second = Status::kNotReady;
  std::thread other([&second] { second = draw_bands(1); });
  const Status first = draw_bands(0);
  other.join();
  return ok(first) && ok(second) && is_the_whole_picture() ? 0 : 2;
}
