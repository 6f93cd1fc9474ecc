// SPDX-License-Identifier: MIT
// Page mode: a picture drawn in bands of any height is bit for bit the picture drawn at once.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstdlib>

using namespace arcspan;
using namespace arcspan::test;
using Blinn1 = Illumination<1, Highlight::kBlinn>;
using Phong2 = Illumination<2, Highlight::kPhong>;

namespace {

constexpr std::int32_t kWidth = 97;
constexpr std::int32_t kHeight = 61;

struct Scene {
  TestMesh mesh;
  TestCamera camera;
};

/// A sphere in view, one cut by the near plane and the guard band, the inside of one, wide normals.
std::vector<Scene> scenes() {
  Random random(77);
  TestCamera camera;
  camera.width = kWidth;
  camera.height = kHeight;
  camera.focal = 80;
  std::vector<Scene> list;
  for (int i = 0; i < 6; ++i) {
    camera.look_in_random_direction(random);
    camera.translation = {0, 0, -7500};
    if (i == 1) camera.translation = {900, 300, -3100};
    if (i == 2) camera.translation = {100, -50, 200};
    if (i == 0) list.push_back({make_sphere(8, 12, 3000, 0.2, random), camera});
    if (i == 1) list.push_back({make_sphere(5, 8, 3000, 0, random), camera});
    if (i == 2) list.push_back({make_sphere(4, 6, 3000, 0, random).inside_out(), camera});
    if (i == 3) list.push_back({make_smooth_cube(2000), camera});
    if (i == 4) list.push_back({make_smooth_tetrahedron(2000), camera});
    // Clipped and wide at once, so near that the guard band cuts as well.
    if (i == 5) {
      camera.focal = 1500;
      camera.translation = {2000, 1000, -1500};
      list.push_back({make_smooth_cube(2500), camera});
    }
  }
  return list;
}

struct Picture {
  std::vector<Rgb8> pixels;
  std::uint32_t triangles = 0;
  friend bool operator==(const Picture& a, const Picture& b) { return a.pixels == b.pixels; }
};

constexpr std::size_t kPixels = static_cast<std::size_t>(kWidth * kHeight);

template <class Method>
Picture drawn(const Scene& scene, std::int32_t rows, bool with_depth, bool with_cache, bool two_sided) {
  const typename Method::Lighting lighting =
      make_light<Method::Lighting::kLights, Method::Lighting::kModel>(scene.camera);
  const MeshView mesh = scene.mesh.view();
  const ClipTransform transform = scene.camera.transform();
  std::vector<CachedVertex<Method>> cache(with_cache ? mesh.vertex_count() : 0);
  const std::size_t band_pixels = static_cast<std::size_t>(kWidth * rows);
  std::vector<Rgb8> memory(band_pixels);
  std::vector<std::uint16_t> depths(band_pixels);
  hal::Framebuffer<Rgb888> band(memory, kWidth, rows);
  DepthBuffer depth(depths, kWidth, rows);
  Picture picture;
  for (std::int32_t first = 0; first < kHeight; first += rows) {
    band.move_to(first);
    band.clear({1, 2, 3});
    depth.move_to(first);
    depth.clear();
    const DrawOptions options{two_sided};
    const DrawResult result =
        with_depth ? draw_mesh<Method>(mesh, transform, lighting, band, depth, std::span(cache), options)
                   : draw_mesh<Method>(mesh, transform, lighting, band, NoDepth{}, std::span(cache), options);
    REQUIRE(ok(result.status));
    picture.triangles += result.triangles;
    picture.pixels.insert(picture.pixels.end(), memory.begin(), memory.end());
  }
  picture.pixels.resize(kPixels);
  return picture;
}

std::size_t coloured(const Picture& picture) {
  std::size_t count = 0;
  for (const Rgb8& pixel : picture.pixels) count += pixel == Rgb8{1, 2, 3} ? 0u : 1u;
  return count;
}

}  // namespace

TEMPLATE_TEST_CASE("every band height gives the same picture", "", Flat<Blinn1>, Gouraud<Blinn1>, Arc<Blinn1>,
                   Arc<Phong2>) {
  int scene_number = 0;
  for (const Scene& scene : scenes()) {
    for (const bool with_depth : {false, true}) {
      const Picture whole = drawn<TestType>(scene, kHeight, with_depth, true, true);
      CHECK(coloured(whole) > kPixels / 20);
      for (std::int32_t rows = 1; rows < kHeight; rows += 100 / share_of(100)) {
        INFO("scene " << scene_number << ", depth " << with_depth << ", rows " << rows);
        CHECK(drawn<TestType>(scene, rows, with_depth, true, true) == whole);
      }
    }
    ++scene_number;
  }
}

TEMPLATE_TEST_CASE("the vertex cache changes nothing", "", Flat<Blinn1>, Gouraud<Blinn1>, Arc<Blinn1>,
                   Arc<Phong2>) {
  for (const Scene& scene : scenes()) {
    for (const bool two_sided : {false, true}) {
      const Picture cached = drawn<TestType>(scene, kHeight, true, true, two_sided);
      const Picture plain = drawn<TestType>(scene, kHeight, true, false, two_sided);
      CHECK(cached == plain);
      CHECK(cached.triangles == plain.triangles);
    }
  }
}

TEMPLATE_TEST_CASE("the back of a surface is lit as the front of the surface turned inside out", "",
                   Flat<Blinn1>, Gouraud<Blinn1>, Arc<Blinn1>, Arc<Phong2>) {
  int scene_number = 0;
  for (const Scene& scene : scenes()) {
    INFO("scene " << scene_number++);
    // Only the far side of a turned mesh is in front; two-sided, the unturned one shows the same back.
    const Scene turned{scene.mesh.inside_out(), scene.camera};
    const Picture both = drawn<TestType>(scene, kHeight, true, true, true);
    const Picture turned_both = drawn<TestType>(turned, kHeight, true, true, true);
    int largest = 0;
    for (std::size_t i = 0; i < kPixels; ++i) {
      const Rgb8 a = both.pixels[i];
      const Rgb8 b = turned_both.pixels[i];
      largest = std::max({largest, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    }
    // Wide clipped triangles fall into other fans when they are turned, and bilinear interpolation depends on
    // that.
    CHECK(largest <= 24);
  }
}
