// SPDX-License-Identifier: MIT
// A program's own source of vertices: a cache of a fixed number of slots, for meshes of any size. It draws
// what the library's own sources draw.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/mesh/make_face_planes.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <cmath>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kPhong>;
using Frame = hal::Framebuffer<Rgb565>;

/// 256 slots, each with the vertex of one index, which is its tag. Two vertices of a triangle may have the
/// same slot, so vertices are returned by value, and shaded in the slot.
template <class Method>
class SlotCache {
 public:
  [[nodiscard]] Status begin(const VertexStage<Method>&, bool) {
    for (std::uint32_t& tag : tags_) tag = kNone;
    return Status::kOk;
  }
  [[nodiscard]] CachedVertex<Method> vertex(const VertexStage<Method>& stage, std::size_t i) {
    const std::size_t slot = i % kSlots;
    if (tags_[slot] != i) {
      stage.transform(i, vertices_[slot]);
      if (vertices_[slot].outcode == kInside) stage.shade(i, vertices_[slot]);
      tags_[slot] = static_cast<std::uint32_t>(i);
      ++transformed;
    }
    return vertices_[slot];
  }
  [[nodiscard]] static const TriangleRows* rows() { return nullptr; }

  int transformed = 0;

 private:
  static constexpr std::size_t kSlots = 256;
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  CachedVertex<Method> vertices_[kSlots];
  std::uint32_t tags_[kSlots];
};
static_assert(VertexSource<SlotCache<Gouraud<Light>>, Gouraud<Light>>);
static_assert(VertexSource<VertexCache<Gouraud<Light>>, Gouraud<Light>>);
static_assert(VertexSource<NoCache, Gouraud<Light>>);
static_assert(!VertexSource<std::vector<CachedVertex<Gouraud<Light>>>, Gouraud<Light>>);

/// Refuses to draw.
struct NoVertices : NoCache {
  template <class Method>
  [[nodiscard]] static Status begin(const VertexStage<Method>&, bool) {
    return Status::kNotReady;
  }
};

struct Picture {
  std::vector<Frame::Word> colours;
  DrawResult result;
};

template <class Method, class Source>
Picture drawn(const MeshView& mesh, const TestCamera& camera, Source&& source, bool two_sided) {
  const typename Method::Lighting lighting(make_light<1, Highlight::kPhong>(camera));
  Picture picture{std::vector<Frame::Word>(Frame::words(camera.width, camera.height)), {}};
  std::vector<std::uint16_t> depths(DepthBuffer::words(camera.width, camera.height), DepthBuffer::kFarthest);
  Frame frame(picture.colours, camera.width, camera.height);
  const DepthBuffer depth(depths, camera.width, camera.height);
  picture.result =
      draw_mesh<Method>(mesh, camera.transform(), lighting, frame, depth, source, {.two_sided = two_sided});
  return picture;
}

}  // namespace

TEMPLATE_TEST_CASE("a program's own vertex source draws what the library's sources draw", "", Flat<Light>,
                   Gouraud<Light>) {
  Random random(191);
  for (int round = 0; round < share_of(40); ++round) {
    const TestMesh mesh = make_sphere(20, 30, 3000, 0.2, random);
    std::vector<FacePlane> planes(mesh.indices.size() / 3);
    PlaneScale scale;
    MeshView view = mesh.view();
    REQUIRE(ok(make_face_planes(view, planes, scale)));
    if (round % 2 == 0) REQUIRE(ok(view.attach(planes, scale)));
    TestCamera camera;
    camera.look_in_random_direction(random);
    // Some are cut by the near plane or the guard band.
    camera.translation = {std::round(random.real(-3000, 3000)), 0, -std::round(random.decades(2500, 20000))};
    const bool two_sided = round % 3 == 0;
    CAPTURE(round, two_sided);
    const Picture without = drawn<TestType>(view, camera, NoCache{}, two_sided);
    std::vector<CachedVertex<TestType>> memory(view.vertex_count());
    const Picture cached = drawn<TestType>(view, camera, VertexCache<TestType>(memory), two_sided);
    SlotCache<TestType> slots;
    const Picture own = drawn<TestType>(view, camera, slots, two_sided);
    CHECK(ok(own.result.status));
    CHECK(own.colours == without.colours);
    CHECK(cached.colours == without.colours);
    CHECK(own.result.triangles == without.result.triangles);
    CHECK(slots.transformed < 3 * static_cast<int>(view.triangle_count()) / 2);
  }
}

TEST_CASE("a source that does not begin draws nothing, and its status is returned") {
  Random random(192);
  const TestMesh mesh = make_sphere(8, 12, 3000, 0, random);
  TestCamera camera;
  camera.translation = {0, 0, -9000};
  const Picture picture = drawn<Flat<Light>>(mesh.view(), camera, NoVertices{}, false);
  CHECK(picture.result.status == Status::kNotReady);
  CHECK(picture.result.triangles == 0);
}
