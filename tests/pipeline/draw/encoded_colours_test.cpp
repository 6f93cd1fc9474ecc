// SPDX-License-Identifier: MIT
// A table of encoded colours gives the same pixels as encoding each of them. A sink chooses the size of the
// table by its kEncodedColours.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/literature/phong.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/adaptive/adaptive.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <type_traits>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

template <std::size_t Size>
struct FrameOf : hal::Framebuffer<Rgb565> {
  static constexpr std::size_t kEncodedColours = Size;
  using hal::Framebuffer<Rgb565>::Framebuffer;
};
/// For the default size the framebuffer itself, which other tests draw into, so that its code is compiled
/// once.
template <std::size_t Size>
using Frame = std::conditional_t<Size == ARCSPAN_ENCODED_COLOURS, hal::Framebuffer<Rgb565>, FrameOf<Size>>;

using Light = Illumination<1, Highlight::kPhong>;
template <class Method, std::size_t Size>
using TableIn = EncodedColoursFor<Method, Frame<Size>>;
static_assert(std::is_same_v<TableIn<Arc<Light>, 1024>, EncodedColourTable<Rgb565, 1024>>);
static_assert(std::is_same_v<TableIn<Arc<Light>, 256>, EncodedColourTable<Rgb565, 256>>);
static_assert(sizeof(EncodedColourTable<Rgb565, 256>) == 512);
static_assert(std::is_same_v<TableIn<Arc<Light>, 0>, NoEncodedColours>);
static_assert(std::is_same_v<TableIn<Phong<Light>, 1024>, NoEncodedColours>);
// The ramp of several lights is finer, a dithered colour depends on the pixel's place, and entries have 16
// bits.
static_assert(!detail::EncodableInAdvance<Illumination<2, Highlight::kPhong>, Rgb565>);
static_assert(!detail::EncodableInAdvance<Light, Dithered<Rgb565>>);
static_assert(!detail::EncodableInAdvance<Light, Rgb888>);

constexpr DrawFeatures kFeatures{.caches = false, .planes = false};

struct Pictures {
  std::vector<std::uint16_t> colours;
  std::vector<std::uint16_t> depths;
  friend bool operator==(const Pictures&, const Pictures&) = default;
};

template <class Method, std::size_t Size, bool Tests>
Pictures drawn(const MeshView& mesh, const TestCamera& camera, const typename Method::Lighting& light) {
  Pictures p;
  p.colours.resize(hal::Framebuffer<Rgb565>::words(camera.width, camera.height));
  p.depths.resize(DepthBuffer::words(camera.width, camera.height));
  Frame<Size> frame(p.colours, camera.width, camera.height);
  DepthBuffer depth(p.depths, camera.width, camera.height);
  frame.clear({1, 2, 3});
  depth.clear();
  const ClipTransform transform = camera.transform();
  if constexpr (Tests) {
    REQUIRE(ok(draw_mesh<Method, kFeatures>(mesh, transform, light, frame, depth, {}, {true}).status));
  } else {
    REQUIRE(ok(draw_mesh<Method, kFeatures>(mesh, transform, light, frame, NoDepth{}, {}, {true}).status));
  }
  return p;
}

/// Triangles anywhere in front of the camera, also through its edges, with normals anywhere around.
TestMesh random_triangles(Random& random) {
  TestMesh mesh;
  for (int i = 0; i < 60; ++i) {
    const Vec3 centre{random.real(-6000, 6000), random.real(-5000, 5000), random.real(-9000, 9000)};
    const double size = std::pow(2.0, random.real(6, 13));
    const double spread = random.real(0, 1.2);
    const Vec3 mean{random.real(-1, 1), random.real(-1, 1), random.real(0, 1) + 0.01};
    std::uint16_t corners[3];
    for (std::uint16_t& corner : corners) {
      const auto offset = [&](double by) {
        return Vec3{random.real(-by, by), random.real(-by, by), random.real(-by, by)};
      };
      corner = mesh.add(centre + offset(size), normalised(normalised(mean) + offset(spread)));
    }
    mesh.triangle(corners[0], corners[1], corners[2]);
  }
  return mesh;
}

/// `All`: in all sizes, with a depth test and without. The table is the same for every method, so one takes
/// all.
template <class Method, bool All = false>
int pictures_that_differ(int count) {
  Random random(77);
  TestCamera camera;
  camera.translation = {0, 0, -20000};
  camera.focal = 220;
  const auto light = make_light<1, Method::Lighting::kModel>(camera);
  int different = 0;
  for (int i = 0; i < count; ++i) {
    const TestMesh mesh =
        i % 4 == 3 ? make_sphere(3 + i % 9, 5 + i % 17, 6000, 0.02, random) : random_triangles(random);
    const MeshView view = mesh.view();
    const Pictures tested = drawn<Method, 0, true>(view, camera, light);
    different += tested == drawn<Method, 1024, true>(view, camera, light) ? 0 : 1;
    if constexpr (All) {
      different += tested == drawn<Method, 256, true>(view, camera, light) ? 0 : 1;
      const Pictures untested = drawn<Method, 0, false>(view, camera, light);
      different += untested == drawn<Method, 1024, false>(view, camera, light) ? 0 : 1;
    }
  }
  return different;
}

}  // namespace

TEST_CASE("a table of encoded colours changes no pixel") {
  CHECK(pictures_that_differ<Arc<Illumination<1, Highlight::kBlinn>>>(share_of(60)) == 0);
  CHECK(pictures_that_differ<Arc<Light>, true>(share_of(60)) == 0);
  CHECK(pictures_that_differ<Adaptive<Light>>(share_of(60)) == 0);
}

TEST_CASE(
    "a table of encoded colours has the diffuse colour of every N·L, also where rounding or overflow left "
    "its range") {
  const TestCamera camera;
  const auto light = make_light<1, Highlight::kBlinn>(camera);
  EncodedColourTable<Rgb565, 256> narrow;
  narrow.set(light);
  EncodedColourTable<Rgb565, 1024> wide;
  wide.set(light);
  int different = 0;
  const auto compare = [&](std::int64_t raw) {
    const Cosine value = Cosine::from_raw(static_cast<std::int32_t>(raw));
    const std::uint16_t encoded = Rgb565::encode(light.diffuse_colour(value));
    different += narrow[value] == encoded && wide[value] == encoded ? 0 : 1;
  };
  for (std::int64_t top = INT32_MIN; top <= INT32_MAX; top += 1 << 16) {
    for (const std::int64_t low : {0, 1, 0x7FFF, 0xFFFF}) compare(top + low);
  }
  CHECK(different == 0);
}
