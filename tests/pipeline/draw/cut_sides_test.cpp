// SPDX-License-Identifier: MIT
// A sink that takes a part of the picture gets exactly that part: a pixel is a function of the scene and of
// its position, wherever the sink is cut off.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/literature/segment.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/unlit.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/random.hpp>

#include <algorithm>
#include <array>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kPhong>;
using TwoLights = Illumination<2, Highlight::kPhong>;
using Texels = DirectTexels<>;
using Frame = hal::Framebuffer<Rgb565>;
constexpr Rgb8 kBackground{9, 8, 7};
constexpr DrawFeatures kFeatures{.planes = false};

/// Memory of a whole picture that takes a part of it, and says so or not that it is memory.
template <bool InMemory>
struct Window : Frame {
  using RowsInMemory = std::conditional_t<InMemory, Window, void>;
  Rect part;
  Window(std::span<Frame::Word> memory, const TestCamera& camera, const Rect& taken)
      : Frame(memory, camera.width, camera.height), part(taken) {}
  [[nodiscard]] Rect bounds() const { return part; }
};
static_assert(SinkInMemory<Window<true>> && !SinkInMemory<Window<false>>);
static_assert(SinkFromFirstColumn<Frame> && !SinkFromFirstColumn<Window<true>>);

struct Picture {
  std::vector<Frame::Word> colours;
  std::vector<std::uint16_t> depths;

  explicit Picture(const TestCamera& camera)
      : colours(Frame::words(camera.width, camera.height)),
        depths(DepthBuffer::words(camera.width, camera.height)) {}
};

template <class Method>
typename Method::Lighting lighting(const TestCamera& camera) {
  static const std::vector<std::uint16_t> kTexels = [] {
    std::vector<std::uint16_t> texels;
    for (std::uint32_t i = 0; i < 4096 + 1024; ++i)
      texels.push_back(static_cast<std::uint16_t>(i * 2654435761u >> 16));
    return texels;
  }();
  if constexpr (requires { Method::Light::kNeedsFaceNormal; }) {
    Texture<Texels> texture;
    REQUIRE(ok(Texture<Texels>::make(kTexels, {6, 6, 2}, texture)));
    typename Method::Lighting lit(lighting<typename Method::Light>(camera));
    const bool borders = Method::Lighting::kBorders == TextureBorders::kOfTexture;
    lit.set(borders ? texture.with({TextureWrap::kMirror, TextureWrap::kClamp}) : texture);
    return lit;
  } else if constexpr (std::same_as<typename Method::Lighting, PackedRgb>) {
    return PackedRgb::grey(1022);
  } else if constexpr (std::constructible_from<typename Method::Lighting, const TwoLights&>) {
    return typename Method::Lighting(make_light<2, Highlight::kPhong>(camera));
  } else {
    return typename Method::Lighting(make_light<1, Highlight::kPhong>(camera));
  }
}

/// Draws into a frame, or into a window of it.
template <class Method, class Sink>
void draw(const MeshView& mesh, const TestCamera& camera, Sink&& sink, Picture& picture) {
  DepthBuffer depth(picture.depths, camera.width, camera.height);
  sink.clear(kBackground);
  depth.clear();
  const auto light = lighting<Method>(camera);
  REQUIRE(ok(draw_mesh<Method, kFeatures>(mesh, camera.transform(), light, sink, depth, NoCache{},
                                          {.two_sided = true})
                 .status));
}

/// The pixels at which a picture is not the part of `whole` that a window takes, and nothing elsewhere.
int differences(const Picture& picture, const Picture& whole, std::int32_t width, const Rect& part) {
  int count = 0;
  for (std::size_t i = 0; i < whole.colours.size(); ++i) {
    const auto x = static_cast<std::int32_t>(i) % width;
    const auto y = static_cast<std::int32_t>(i) / width;
    const bool inside = part.left <= x && x < part.right && part.top <= y && y < part.bottom;
    const bool same = picture.colours[i] == (inside ? whole.colours[i] : Rgb565::encode(kBackground)) &&
                      picture.depths[i] == (inside ? whole.depths[i] : DepthBuffer::kFarthest);
    count += same ? 0 : 1;
  }
  return count;
}

template <class Method, bool InMemory>
void check_windows(const MeshView& mesh, const TestCamera& camera, Random& random) {
  const std::int32_t width = camera.width;
  const std::int32_t height = camera.height;
  Picture whole(camera);
  draw<Method>(mesh, camera, Frame(whole.colours, width, height), whole);
  std::vector<Rect> parts{{0, 0, width - 1, height}, {1, 0, width, height}, {0, 1, width, height},
                          {0, 0, width, height - 1}, {40, 20, 40, 50},      {0, 0, width / 2, height}};
  for (int i = 0; i < 14; ++i) {
    const std::int32_t left = random.integer(0, width - 1);
    const std::int32_t top = random.integer(0, height - 1);
    const std::int32_t right = i % 3 == 0 ? left + 1 : i % 3 == 1 ? width : random.integer(left, width);
    parts.push_back({left, i % 2 == 0 ? 0 : top, right, i % 4 == 1 ? top + 1 : height});
  }
  for (const Rect& part : parts) {
    Picture picture(camera);
    draw<Method>(mesh, camera, Window<InMemory>(picture.colours, camera, part), picture);
    CAPTURE(InMemory, part.left, part.top, part.right, part.bottom);
    CHECK(differences(picture, whole, width, part) == 0);
  }
}

/// A mesh with points of the texture.
struct Scene {
  TestMesh mesh;
  TestCamera camera;
  std::vector<TexturePoint> points{};

  Scene(const TestMesh& shape, const Vec3& translation, Random& random) : mesh(shape) {
    camera.width = 97;
    camera.height = 61;
    camera.focal = 80;
    camera.look_in_random_direction(random);
    camera.translation = translation;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      points.push_back({static_cast<std::int16_t>(random.integer(-8000, 8000)),
                        static_cast<std::int16_t>(random.integer(-8000, 8000))});
    }
  }
  [[nodiscard]] MeshView view() const {
    MeshView mapped = mesh.view();
    REQUIRE(ok(mapped.attach(points, TextureScale{12})));
    return mapped;
  }
};

/// Large and small triangles of any direction around the near plane, across all sides of the picture.
TestMesh shards(Random& random) {
  TestMesh mesh;
  for (int i = 0; i < 40; ++i) {
    const double size = random.decades(300, 9000);
    const Vec3 middle{random.real(-6000, 6000), random.real(-6000, 6000), random.real(-6000, 6000)};
    const Vec3 normal = normalised(Vec3{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)});
    std::array<std::uint16_t, 3> corners{};
    for (std::uint16_t& corner : corners) {
      const auto off = [&random](double most) {
        return Vec3{random.real(-most, most), random.real(-most, most), random.real(-most, most)};
      };
      corner = mesh.add(middle + off(size), normalised(normal + off(0.4)));
    }
    mesh.triangle(corners[0], corners[1], corners[2]);
  }
  return mesh;
}

template <class Method, bool InMemory = true>
void check_scenes() {
  Random random(91);
  // Normals of the second sphere are so far apart that its triangles are normalised.
  for (const int rings : {16, 9}) {
    const Scene ball(make_sphere(rings, 2 * rings, 3000, 0, random), {0, 0, -7500}, random);
    check_windows<Method, InMemory>(ball.view(), ball.camera, random);
  }
  const Scene mixture(shards(random), {0, 0, -6000}, random);
  check_windows<Method, InMemory>(mixture.view(), mixture.camera, random);
}

}  // namespace

TEMPLATE_TEST_CASE("a sink of a part of the picture gets exactly that part", "", Flat<Light>, Gouraud<Light>,
                   Arc<Light>, Arc<TwoLights>, Segment<Light>) {
  check_scenes<TestType>();
}

TEMPLATE_TEST_CASE(
    "a sink of a part of the picture gets exactly that part of textures", "[textures]",
    (Textured<GreyGouraud<Light>, Texels>), (Textured<Arc<Light>, Texels>),
    (Textured<Unlit, Texels, TexelLight::kNone, TextureFilter::kBilinear, TextureBorders::kOfTexture>)) {
  check_scenes<TestType>();
}

TEST_CASE("a sink that is no memory gets exactly its part") { check_scenes<Arc<Light>, false>(); }

TEST_CASE("a two-sided triangle across the near plane covers the same pixels turned over") {
  // Slivers, because the rest of one may be bent by rounding, and then shows how it is split.
  Random random(72);
  TestCamera camera;
  int different = 0;
  for (int i = 0; i < 200; ++i) {
    camera.focal = random.decades(60, 3000);
    camera.near_plane = random.decades(100, 2000);
    const double size = random.decades(100, 20000);
    const Vec3 middle{random.real(-800, 800), random.real(-800, 800), random.real(-600, 600)};
    const auto off = [&random](double most) {
      return Vec3{random.real(-most, most), random.real(-most, most), random.real(-most, most)};
    };
    TestMesh mesh;
    const Vec3 first = middle + off(size);
    const std::uint16_t a = mesh.add(first, {0, 0, 1});
    const std::uint16_t b = mesh.add(first + off(random.decades(2, 200)), {0, 0, 1});
    const std::uint16_t c = mesh.add(middle + off(size), {0, 0, 1});
    mesh.triangle(a, b, c);
    Picture picture(camera);
    draw<Unlit>(mesh.view(), camera, Frame(picture.colours, camera.width, camera.height), picture);
    mesh.indices = {c, b, a};
    std::rotate(mesh.indices.begin(), mesh.indices.begin() + i % 3, mesh.indices.end());
    Picture turned(camera);
    draw<Unlit>(mesh.view(), camera, Frame(turned.colours, camera.width, camera.height), turned);
    for (std::size_t p = 0; p < picture.colours.size(); ++p)
      different += picture.colours[p] != turned.colours[p] ? 1 : 0;
  }
  CHECK(different == 0);
}
