// SPDX-License-Identifier: MIT
// A sink that takes some columns of the picture only gets exactly those, whether triangles are cut by its
// sides or lie within them.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/random.hpp>

#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kPhong>;
using TwoLights = Illumination<2, Highlight::kPhong>;
using Frame = hal::Framebuffer<Rgb565>;
constexpr Rgb8 kBackground{9, 8, 7};
constexpr DrawFeatures kAll{.planes = false};
constexpr DrawFeatures kByRows{.planes = false, .small_triangles = false};

/// Memory of a whole picture that takes the columns left ... right - 1, and says so or not that it is memory.
template <bool InMemory>
struct Window : Frame {
  using RowsInMemory = std::conditional_t<InMemory, Window, void>;
  std::int32_t left;
  std::int32_t right;
  Window(std::span<Frame::Word> memory, const TestCamera& camera, std::int32_t from, std::int32_t to)
      : Frame(memory, camera.width, camera.height), left(from), right(to) {}
  [[nodiscard]] Rect bounds() const { return {left, 0, right, Frame::bounds().bottom}; }
};
static_assert(SinkInMemory<Window<true>> && !SinkInMemory<Window<false>>);

struct Picture {
  std::vector<Frame::Word> colours;
  std::vector<std::uint16_t> depths;
};

template <class Method, bool InMemory, DrawFeatures Features, std::size_t Lights>
Picture drawn(const MeshView& mesh, const TestCamera& camera, std::int32_t left, std::int32_t right) {
  const typename Method::Lighting lighting(make_light<Lights, Highlight::kPhong>(camera));
  Picture picture{std::vector<Frame::Word>(Frame::words(camera.width, camera.height)),
                  std::vector<std::uint16_t>(DepthBuffer::words(camera.width, camera.height))};
  Window<InMemory> window(picture.colours, camera, left, right);
  DepthBuffer depth(picture.depths, camera.width, camera.height);
  window.clear(kBackground);
  depth.clear();
  REQUIRE(ok(draw_mesh<Method, Features>(mesh, camera.transform(), lighting, window, depth).status));
  return picture;
}

/// The columns of `whole` that a window takes, and nothing elsewhere.
bool is_part_of(const Picture& part, const Picture& whole, std::int32_t width, std::int32_t left,
                std::int32_t right) {
  for (std::size_t i = 0; i < part.colours.size(); ++i) {
    const auto x = static_cast<std::int32_t>(i) % width;
    const bool inside = left <= x && x < right;
    if (part.colours[i] != (inside ? whole.colours[i] : Rgb565::encode(kBackground))) return false;
    if (part.depths[i] != (inside ? whole.depths[i] : DepthBuffer::kFarthest)) return false;
  }
  return true;
}

template <class Method, bool InMemory, DrawFeatures Features = kAll, std::size_t Lights = 1,
          DrawFeatures Whole = kAll>
void check_windows(const MeshView& mesh, const TestCamera& camera) {
  const Picture whole = drawn<Method, InMemory, Whole, Lights>(mesh, camera, 0, camera.width);
  const std::int32_t middle = camera.width / 2;
  for (std::int32_t from = 0; from <= middle; from += 3) {
    for (const std::int32_t to :
         {from, from + 1, from + 5, middle + from, camera.width - from / 2, camera.width}) {
      CAPTURE(InMemory, from, to);
      CHECK(is_part_of(drawn<Method, InMemory, Features, Lights>(mesh, camera, from, to), whole, camera.width,
                       from, to));
    }
  }
}

TestCamera camera_of_sphere(Random& random) {
  TestCamera camera;
  camera.width = 97;
  camera.height = 61;
  camera.focal = 80;
  camera.look_in_random_direction(random);
  camera.translation = {0, 0, -7500};
  return camera;
}

}  // namespace

TEMPLATE_TEST_CASE("a sink of some columns gets exactly those columns of the picture", "", Flat<Light>,
                   Gouraud<Light>) {
  Random random(91);
  const TestCamera camera = camera_of_sphere(random);
  const TestMesh near_normals = make_sphere(16, 32, 3000, 0, random);
  check_windows<TestType, true>(near_normals.view(), camera);
  check_windows<TestType, false>(near_normals.view(), camera);
}

// Normals of this sphere are far apart, so that its triangles are normalised. Small triangles that are cut
// may differ by a step, because their rows start at the first drawn column.
TEST_CASE("a sink of some columns gets exactly those columns by two lights") {
  Random random(92);
  const TestCamera camera = camera_of_sphere(random);
  const TestMesh far_normals = make_sphere(9, 18, 3000, 0, random);
  const TestMesh near_normals = make_sphere(16, 32, 3000, 0, random);
  check_windows<Arc<Light>, true, kByRows, 1, kByRows>(near_normals.view(), camera);
  check_windows<Arc<Light>, false, kByRows, 1, kByRows>(near_normals.view(), camera);
  check_windows<Arc<TwoLights>, true, kByRows, 2, kByRows>(far_normals.view(), camera);
}
