// SPDX-License-Identifier: MIT
// How many functions a reader follows from draw_mesh() to the one that stores a pixel (docs/one-pixel.md): a
// sink counts the calls on the stack. Only a build without optimisation has them all (preset dev).
#include <arcspan/draw.hpp>
#include <arcspan/pixel/cursor.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <execinfo.h>
#include <tests/support/mesh_and_camera.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

[[gnu::noinline]] int calls_on_stack() {
  std::array<void*, 200> calls{};
  return ::backtrace(calls.data(), static_cast<int>(calls.size()));
}

int deepest_stack = 0;

/// Notes how deep the stack is where a pixel is stored.
struct CountingCursor : WordCursor<std::uint8_t> {
  using WordCursor::WordCursor;
  void write(std::uint8_t encoded) {
    deepest_stack = std::max(deepest_stack, calls_on_stack());
    WordCursor::write(encoded);
  }
};

struct CountingFormat : Gray8 {
  using Cursor = CountingCursor;
};

struct CountingSink {
  using Format = CountingFormat;
  [[nodiscard]] Rect bounds() const { return {0, 0, 160, 120}; }
  [[nodiscard]] CountingCursor open(const Span& run) { return {pixels[run.y], run.x}; }
  [[nodiscard]] Status close(const Span&) { return Status::kOk; }

  std::uint8_t pixels[120][160] = {};
};

/// Returns the number of functions from draw_mesh() to the one that calls the sink's cursor.
template <class Method, DrawFeatures Features>
int functions_to_a_pixel(bool cached) {
  TestMesh triangle;
  triangle.add({-2000, -2000, 0}, {0, 0, 1});
  triangle.add({2000, -2000, 0}, normalised(Vec3{0.05, 0, 1}));
  triangle.add({0, 2000, 0}, normalised(Vec3{0, 0.05, 1}));
  triangle.triangle(0, 1, 2);
  TestCamera camera;
  camera.translation = {0, 0, -12000};
  const typename Method::Lighting lighting(make_light<1, Highlight::kPhong>(camera));
  const MeshView mesh = triangle.view();
  std::vector<CachedVertex<Method>> memory(mesh.vertex_count());
  VertexCache<Method> cache(memory);
  CountingSink sink;
  deepest_stack = 0;
  const int outside = calls_on_stack();
  const DrawResult result =
      cached ? draw_mesh<Method, Features>(mesh, camera.transform(), lighting, sink, NoDepth{}, cache)
             : draw_mesh<Method, Features>(mesh, camera.transform(), lighting, sink, NoDepth{}, NoCache{});
  REQUIRE(ok(result.status));
  REQUIRE(deepest_stack > outside);
  return deepest_stack - outside - 1;  // without write()
}

}  // namespace

TEST_CASE("from draw_mesh() to a pixel there are at most 14 functions") {
  using Method = Arc<Illumination<1, Highlight::kPhong>>;
  static constexpr DrawFeatures kLarge{.small_triangles = false};
  const int functions = functions_to_a_pixel<Method, kLarge>(false);
  CHECK(functions <= 14);
#ifndef __OPTIMIZE__
  CHECK(functions == 14);  // if this fails, the page and this number are to be mended
#endif
  CHECK(functions_to_a_pixel<Method, kLarge>(true) <= 14);
}
