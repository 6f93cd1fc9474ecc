// SPDX-License-Identifier: MIT
// A sink that takes a part of the picture gets exactly that part: a pixel is a function of the scene and of
// its position, wherever the sink is cut off. The memory of a part has no other pixels, neither of colours
// nor of depths, and its rows are padded.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/literature/segment.hpp>
#include <arcspan/pixel/gray2.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb332.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/pixel/xrgb8888.hpp>
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
constexpr Rgb8 kBackground{9, 8, 7};
constexpr DrawFeatures kFeatures{.planes = false};

/// A window that does not say that its rows lie in memory.
template <class Format>
struct OpenedWindow : hal::FramebufferWindow<Format> {
  using hal::FramebufferWindow<Format>::FramebufferWindow;
};
template <class Format, bool InMemory>
using Window = std::conditional_t<InMemory, hal::FramebufferWindow<Format>, OpenedWindow<Format>>;
static_assert(SinkInMemory<Window<Rgb565, true>> && !SinkInMemory<Window<Rgb565, false>>);
static_assert(SinkFromFirstColumn<hal::Framebuffer<Rgb565>> && !SinkFromFirstColumn<Window<Rgb565, true>>);

/// A whole picture.
template <class Format>
struct Picture {
  std::vector<typename Format::Word> colours;
  std::vector<std::uint16_t> depths;
  hal::Framebuffer<Format> frame;
  DepthBuffer depth;

  explicit Picture(const TestCamera& camera)
      : colours(hal::Framebuffer<Format>::words(camera.width, camera.height)),
        depths(DepthBuffer::words(camera.width, camera.height)),
        frame(colours, camera.width, camera.height),
        depth(depths, camera.width, camera.height) {}
};

/// Memory of a part of a picture, with bytes before it and between its rows.
template <class Format>
struct PartMemory {
  Rect part;
  std::size_t before;
  std::int32_t stride_bytes;
  std::vector<std::byte> bytes;
  std::vector<std::uint16_t> depths;

  PartMemory(const Rect& taken, Random& random) : part(taken) {
    using Word = typename Format::Word;
    constexpr auto kAlignment = static_cast<std::int32_t>(alignof(Word));
    before = static_cast<std::size_t>(kAlignment * random.integer(0, 3));
    const std::size_t row = (Format::words_per_row(part.width()) + 1) * sizeof(Word);
    stride_bytes = static_cast<std::int32_t>(row) + kAlignment * random.integer(0, 7);
    bytes.assign(before + static_cast<std::size_t>(stride_bytes * part.height()), std::byte{0xA5});
    depths.assign(DepthBuffer::words(part.width(), part.height()), 0);
  }
  template <class Sink>
  [[nodiscard]] Sink window() {
    Sink sink(std::span{bytes}.subspan(before), part, stride_bytes);
    REQUIRE(ok(sink.status()));
    REQUIRE(sink.bounds() == part);
    return sink;
  }
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
    lit.set(texture.with({TextureWrap::kMirror, TextureWrap::kClamp}));
    if (!lit.shows_borders()) lit.set(texture);
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
void draw(const MeshView& mesh, const TestCamera& camera, Sink& sink, const DepthBuffer& depth) {
  sink.clear(kBackground);
  depth.clear();
  const auto light = lighting<Method>(camera);
  REQUIRE(ok(draw_mesh<Method, kFeatures>(mesh, camera.transform(), light, sink, depth, NoCache{},
                                          {.two_sided = true})
                 .status));
}

/// Draws a part of `whole`, and compares all bytes of its memory.
template <class Method, class Format, bool InMemory>
void check_window(const MeshView& mesh, const TestCamera& camera, const Picture<Format>& whole,
                  const Rect& part, Random& random) {
  CAPTURE(InMemory, part.left, part.top, part.right, part.bottom);
  PartMemory<Format> drawn(part, random);
  PartMemory<Format> wanted = drawn;
  auto window = drawn.template window<Window<Format, InMemory>>();
  const DepthBuffer depth(drawn.depths, part);
  REQUIRE(depth.bounds() == part);
  draw<Method>(mesh, camera, window, depth);
  auto copy = wanted.template window<hal::FramebufferWindow<Format>>();
  auto wanted_depth = wanted.depths.begin();
  for (std::int32_t y = part.top; y < part.bottom; ++y) {
    typename Format::Cursor from(whole.frame.row(y), part.left);
    for (std::int32_t x = part.left; x < part.right; ++x, from.next()) {
      copy.open({y, x, 1}).write(from.read());
      *wanted_depth++ = whole.depth.row(y)[x];
    }
  }
  CHECK(drawn.bytes == wanted.bytes);
  CHECK(drawn.depths == wanted.depths);
}

template <class Method, class Format, bool InMemory>
void check_windows(const MeshView& mesh, const TestCamera& camera, Random& random) {
  const std::int32_t width = camera.width;
  const std::int32_t height = camera.height;
  Picture<Format> whole(camera);
  draw<Method>(mesh, camera, whole.frame, whole.depth);
  std::vector<Rect> parts{{0, 0, width - 1, height}, {1, 0, width, height}, {0, 1, width, height},
                          {0, 0, width, height - 1}, {40, 20, 40, 50},      {0, 0, width / 2, height}};
  for (int i = 0; i < 14; ++i) {
    const std::int32_t left = random.integer(0, width - 1);
    const std::int32_t top = random.integer(0, height - 1);
    const std::int32_t right = i % 3 == 0 ? left + 1 : i % 3 == 1 ? width : random.integer(left, width);
    parts.push_back({left, i % 2 == 0 ? 0 : top, right, i % 4 == 1 ? top + 1 : height});
  }
  for (const Rect& part : parts) check_window<Method, Format, InMemory>(mesh, camera, whole, part, random);
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

template <class Method, class Format = Rgb565, bool InMemory = true>
void check_scenes() {
  Random random(91);
  // Normals of the second sphere are so far apart that its triangles are normalised.
  for (const int rings : {16, 9}) {
    const Scene ball(make_sphere(rings, 2 * rings, 3000, 0, random), {0, 0, -7500}, random);
    check_windows<Method, Format, InMemory>(ball.view(), ball.camera, random);
  }
  const Scene mixture(shards(random), {0, 0, -6000}, random);
  check_windows<Method, Format, InMemory>(mixture.view(), mixture.camera, random);
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

TEMPLATE_TEST_CASE("a sink of a part of the picture gets exactly that part in every kind of format", "",
                   Dithered<Rgb565>, Rgb888, Xrgb8888, Dithered<Rgb332>, Dithered<Gray4>, Gray2,
                   Dithered<Mono>) {
  check_scenes<Arc<Light>, TestType>();
  check_scenes<Gouraud<Light>, TestType>();
}

TEMPLATE_TEST_CASE("a sink that is no memory gets exactly its part", "", Rgb565, Dithered<Mono>) {
  check_scenes<Arc<Light>, TestType, false>();
}

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
    Picture<Rgb565> picture(camera);
    draw<Unlit>(mesh.view(), camera, picture.frame, picture.depth);
    mesh.indices = {c, b, a};
    std::rotate(mesh.indices.begin(), mesh.indices.begin() + i % 3, mesh.indices.end());
    Picture<Rgb565> turned(camera);
    draw<Unlit>(mesh.view(), camera, turned.frame, turned.depth);
    for (std::size_t p = 0; p < picture.colours.size(); ++p)
      different += picture.colours[p] != turned.colours[p] ? 1 : 0;
  }
  CHECK(different == 0);
}
