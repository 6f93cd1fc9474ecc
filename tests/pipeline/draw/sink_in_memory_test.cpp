// SPDX-License-Identifier: MIT
// A sink in memory is stepped from row to row, any other is asked to open every run; the pictures are the
// same.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/literature/segment.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/random.hpp>

#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kPhong>;

/// Has an `open` of its own, which has to be called.
template <class Format>
struct Asked : hal::Framebuffer<Format> {
  using hal::Framebuffer<Format>::Framebuffer;
  int opened = 0;
  [[nodiscard]] typename Format::Cursor open(const Span& run) {
    ++opened;
    return hal::Framebuffer<Format>::open(run);
  }
};

static_assert(SinkInMemory<hal::Framebuffer<Rgb565>> && SinkInMemory<hal::Framebuffer<Gray4>>);
static_assert(PixelSink<Asked<Rgb565>> && !SinkInMemory<Asked<Rgb565>>);

constexpr DrawFeatures kFeatures{.planes = false};

template <class Frame>
struct Picture {
  std::vector<typename Frame::Word> colours;
  std::vector<std::uint16_t> depths;
  int opened = 0;
};

/// In bands of `rows`, so that rows begin above and end below what is in memory.
template <class Method, class Frame>
Picture<Frame> drawn(const MeshView& mesh, const TestCamera& camera, std::int32_t rows) {
  const auto light = make_light<1, Highlight::kPhong>(camera);
  const typename Method::Lighting lighting(light);
  const ClipTransform transform = camera.transform();
  Picture<Frame> picture;
  std::vector<typename Frame::Word> band(Frame::words(camera.width, rows));
  std::vector<std::uint16_t> depths(DepthBuffer::words(camera.width, rows));
  Frame frame(band, camera.width, rows);
  DepthBuffer depth(depths, camera.width, rows);
  for (std::int32_t top = 0; top < camera.height; top += rows) {
    frame.move_to(top);
    depth.move_to(top);
    frame.clear({9, 8, 7});
    depth.clear();
    REQUIRE(ok(draw_mesh<Method, kFeatures>(mesh, transform, lighting, frame, depth).status));
    picture.colours.insert(picture.colours.end(), band.begin(), band.end());
    picture.depths.insert(picture.depths.end(), depths.begin(), depths.end());
  }
  if constexpr (requires { frame.opened; }) picture.opened = frame.opened;
  return picture;
}

template <class Method, class Format>
void compare(const MeshView& mesh, const TestCamera& camera) {
  for (const std::int32_t rows : {camera.height, 7, 1}) {
    const auto stepped = drawn<Method, hal::Framebuffer<Format>>(mesh, camera, rows);
    const auto asked = drawn<Method, Asked<Format>>(mesh, camera, rows);
    INFO("bands of " << rows);
    CHECK(stepped.colours == asked.colours);
    CHECK(stepped.depths == asked.depths);
    CHECK(asked.opened > 100);
  }
}

}  // namespace

TEST_CASE("a sink in memory and one that opens its runs get the same picture") {
  Random random(3);
  TestCamera camera;
  camera.height = 119;
  camera.translation = {300, -200, -16000};
  const TestMesh sphere = make_sphere(9, 14, 4000, 0.02, random);
  const MeshView mesh = sphere.view();
  // Arc has rows of small triangles, too; a word of Gray4 holds two pixels.
  compare<Arc<Light>, Gray4>(mesh, camera);
  compare<Segment<Light>, Rgb565>(mesh, camera);
  camera.translation = {100, -50, -5200};  // cut on all sides
  compare<Flat<Light>, Rgb888>(mesh, camera);
}
