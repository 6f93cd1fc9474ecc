// SPDX-License-Identifier: MIT
// Two threads draw the bands of docs/bands.md; together they are the picture drawn at once.
#include "two_cores.hpp"

#include <cstddef>
#include <iterator>
#include <thread>

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
