// SPDX-License-Identifier: MIT
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/lighting/toon.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/vertex_coloured.hpp>
#include <arcspan/shading/with_operation.hpp>

#include <catch2/catch.hpp>
#include <tests/frames/integer_shapes.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

using namespace arcspan;
using hal::Framebuffer;

namespace {

constexpr std::int32_t kSize = 200;
constexpr DrawFeatures kFeatures{.clips = false, .planes = false};

using OneLight = Illumination<1, Highlight::kBlinn>;
using TwoLights = Illumination<2, Highlight::kPhong, IlluminationFeatures{.coloured_lights = true}>;

constexpr std::array<std::uint16_t, 64> kWhiteTexels = [] {
  std::array<std::uint16_t, 64> texels{};
  for (std::uint16_t& texel : texels) texel = 0xFFFF;
  return texels;
}();
constexpr auto kWhiteTexture = Texture<DirectTexels<>>::of(kWhiteTexels, {3, 3, 1});

template <class Lit>
Lit illumination() {
  constexpr auto kTenth = Coefficient::of(0.1);
  const Material copper{{kTenth, kTenth, kTenth},
                        {Coefficient::of(0.7), Coefficient::of(0.4), Coefficient::of(0.2)},
                        {Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5)},
                        24};
  std::array<DirectionalLight, Lit::kLights> lights{};
  lights[0] = {normalised(2, 3, 4), Coefficient::of(0.9)};
  if constexpr (Lit::kLights == 2) {
    lights[1] = {
        normalised(-3, 1, 2), Coefficient::of(0.6), {kTenth, Coefficient::of(0.5), Coefficient::of(0.9)}};
  }
  Lit lit;
  REQUIRE(ok(Lit::make(copper, lights, normalised(0, 0, 1), lit)));
  return lit;
}

/// A mesh with texture points and a colour per vertex.
template <class Shape>
class Decorated {
 public:
  explicit Decorated(const Shape& shape) {
    REQUIRE(ok(shape.view(mesh)));
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
      points_.push_back({static_cast<std::int16_t>(mesh.position(i).x >> 1),
                         static_cast<std::int16_t>(mesh.position(i).y >> 1)});
      colours_.push_back({static_cast<std::uint8_t>(40 * i), static_cast<std::uint8_t>(255 - 8 * i), 200});
    }
    REQUIRE(ok(mesh.attach(points_, TextureScale{12})));
    REQUIRE(ok(mesh.attach(colours_)));
  }
  MeshView mesh;

 private:
  std::vector<TexturePoint> points_;
  std::vector<Rgb8> colours_;
};

struct Picture {
  std::vector<Rgb8> colours;
  std::vector<std::uint16_t> depths;
};

template <class Method>
Picture drawn(const MeshView& mesh, const typename Method::Lighting& lighting) {
  Picture picture{std::vector<Rgb8>(Framebuffer<Rgb888>::words(kSize, kSize)),
                  std::vector<std::uint16_t>(DepthBuffer::words(kSize, kSize))};
  Framebuffer<Rgb888> frame(picture.colours, kSize, kSize);
  DepthBuffer depth(picture.depths, kSize, kSize);
  frame.clear({1, 2, 3});
  depth.clear();
  Placement placement{Rotation::about_x({3000}), {}};
  placement.translation[2] = ObjectLength::of(-2.5 * scenes::kRadius);
  ClipTransform transform;
  REQUIRE(ok(ClipTransform::make(placement,
                                 {PixelLength::of(200.0), ObjectLength::of(1.0 * scenes::kRadius),
                                  ObjectLength::of(6.0 * scenes::kRadius)},
                                 {kSize, kSize}, transform)));
  const DrawResult result = draw_mesh<Method, kFeatures>(mesh, transform, lighting, frame, depth);
  REQUIRE(result.status == Status::kOk);
  REQUIRE(result.triangles > 10);
  return picture;
}

/// Balls whose triangles span 11 to 45 degrees, so that all orders of Arc draw some of them.
std::array<MeshView, 3> balls() {
  static const auto fine = scenes::make_sphere<32, 16>();
  static constexpr auto kBall = scenes::make_sphere<16, 8>();
  static constexpr auto kCoarseBall = scenes::make_sphere<8, 4>();
  static const Decorated decorated_fine(fine);
  static const Decorated decorated(kBall);
  static const Decorated decorated_coarse(kCoarseBall);
  return {decorated_fine.mesh, decorated.mesh, decorated_coarse.mesh};
}

/// The largest difference between depths of two pictures.
int furthest(const Picture& a, const Picture& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.depths.size(); ++i)
    most = std::max(most, std::abs(a.depths[i] - b.depths[i]));
  return most;
}

/// The differences that a white texture makes to the pixels of the pictures of a method, in steps of 8 bits.
template <class Method, TexelLight Colours, TextureBorders Borders = TextureBorders::kRepeat, class Lit>
std::vector<int> differences(const Lit& lit, std::span<const MeshView> meshes) {
  using White = Textured<Method, DirectTexels<>, Colours, TextureFilter::kNearest, Borders>;
  const typename Method::Lighting plain(lit);
  const typename White::Lighting textured(lit, kWhiteTexture);
  std::vector<int> result;
  for (const MeshView& mesh : meshes) {
    const Picture without = drawn<Method>(mesh, plain);
    const Picture with = drawn<White>(mesh, textured);
    CHECK(furthest(without, with) <= 10);  // a small triangle in perspective is drawn by rows
    const std::vector<Rgb8>& a = without.colours;
    const std::vector<Rgb8>& b = with.colours;
    for (std::size_t i = 0; i < a.size(); ++i) {
      result.push_back(
          std::max({std::abs(a[i].r - b[i].r), std::abs(a[i].g - b[i].g), std::abs(a[i].b - b[i].b)}));
    }
  }
  return result;
}

template <class Method, class Lit>
int largest_difference() {
  const std::vector<int> all = differences<Method, TexelLight::kColoured>(illumination<Lit>(), balls());
  return *std::max_element(all.begin(), all.end());
}

/// The pixels in a thousand that differ by more than five steps under grey light, for a material of these
/// coefficients whose planes may be off by four. `toon`: the steps of the light, or 0.
template <std::size_t Lights, TextureBorders Borders = TextureBorders::kRepeat>
std::ptrdiff_t grey_differences(Coefficient ambient, Coefficient diffuse, std::int32_t toon) {
  using Lit = Illumination<Lights, Highlight::kBlinn>;
  const auto grey = [](Coefficient share) { return ChannelCoefficients{share, share, share}; };
  std::array<DirectionalLight, Lights> lights{};
  lights[0] = {normalised(2, 3, 4), Coefficient::of(0.9)};
  if constexpr (Lights == 2) lights[1] = {normalised(-3, 1, 2), Coefficient::of(0.6)};
  // Without highlights, or those of full light would lie on all that it reaches.
  Coefficient specular = Coefficient::of(0.5);
  if constexpr (Lights > 2) {
    lights.fill({normalised(0, 0, 1), Coefficient::of(1.0)});
    specular = {};
  }
  Lit lit;
  REQUIRE(
      ok(Lit::make({grey(ambient), grey(diffuse), grey(specular), 24}, lights, normalised(0, 0, 1), lit)));
  REQUIRE(ok(lit.set_tolerance(4)));
  if (toon != 0) REQUIRE(ok(lit.set_toon(toon)));
  // The ball with the smallest triangles, because light is linear within most of them.
  const std::array<MeshView, 3> meshes = balls();
  const auto all = differences<Arc<Lit>, TexelLight::kGrey, Borders>(lit, std::span(meshes).first(1));
  const auto more = std::count_if(all.begin(), all.end(), [](int difference) { return difference > 5; });
  const auto pixels = static_cast<std::ptrdiff_t>(all.size());
  return (1000 * more + pixels - 1) / pixels;
}

/// An operation that makes every pixel dark grey.
struct Darkened {
  template <class Colour>
  [[nodiscard]] constexpr PackedRgb operator()(const Colour&) const {
    return PackedRgb::grey(200);
  }
};

/// The number of pixels of a method's pictures that differ in more than the operation, which is on all of
/// them. Depths must be those without it.
template <class Method>
std::size_t pixels_without_operation() {
  using Dark = WithOperation<Method, Darkened>;
  const typename Method::Lighting plain(illumination<OneLight>());
  const typename Dark::Lighting dark(plain);
  const Rgb8 background{1, 2, 3};
  const Rgb8 grey{50, 50, 50};
  std::size_t others = 0;
  for (const MeshView& mesh : balls()) {
    const Picture picture = drawn<Dark>(mesh, dark);
    CHECK((picture.depths == drawn<Method>(mesh, plain).depths));
    for (const Rgb8& pixel : picture.colours) others += pixel == background || pixel == grey ? 0u : 1u;
  }
  return others;
}

}  // namespace

TEST_CASE("a white texture leaves the colours of every method as they are") {
  CHECK(largest_difference<Flat<OneLight>, OneLight>() <= 1);
  CHECK(largest_difference<Gouraud<TwoLights>, TwoLights>() <= 1);
  CHECK(largest_difference<VertexColoured<OneLight>, OneLight>() <= 1);
  CHECK(largest_difference<Arc<OneLight>, OneLight>() <= 1);
  CHECK(largest_difference<Arc<TwoLights>, TwoLights>() <= 1);
}

// Where light ends, is in steps, or would be more than full, its level is not linear.
TEST_CASE("grey light on a white texture is that of the method") {
  constexpr auto kDim = Coefficient::of(0.1);
  constexpr auto kBright = Coefficient::of(0.7);
  CHECK(grey_differences<1>(kDim, kBright, 0) == 0);
  CHECK(grey_differences<2>(kDim, kBright, 0) == 0);
  CHECK(grey_differences<1>(kBright, kBright, 0) == 0);
  CHECK(grey_differences<1, TextureBorders::kOfTexture>(kBright, kBright, 0) == 0);
  CHECK(grey_differences<3>(kDim, kBright, 0) == 0);
  CHECK(grey_differences<1>(kBright, Coefficient{}, 0) == 0);
  // Steps end a little further on where N·L is a little larger.
  CHECK(grey_differences<1>(kDim, kBright, 2) <= 10);
  CHECK(grey_differences<2>(kDim, kBright, 16) <= 10);
}

TEST_CASE("an operation is on every pixel of triangles whose rows have runs of several types") {
  CHECK(pixels_without_operation<Arc<OneLight>>() == 0);
}

TEST_CASE("light on a texture is in steps, whether they are set before or after it is made") {
  using Painted = WithOperation<Textured<Arc<OneLight>, DirectTexels<>>, ScreenDoor>;
  const auto smooth = illumination<OneLight>();
  OneLight toon = smooth;
  REQUIRE(ok(toon.set_toon(3)));
  const Painted::Lighting before{Painted::Method::Lighting(toon, kWhiteTexture)};
  Painted::Lighting after{Painted::Method::Lighting(smooth, kWhiteTexture)};
  CHECK(after.set_toon(1) == Status::kInvalidArgument);
  REQUIRE(ok(after.set_toon(3)));
  for (std::int32_t i = 0; i < 256; ++i) {
    const OneLight::Scalars scalars{Cosine::from_raw(i << (Cosine::kFraction - 8)),
                                    Cosine::from_raw(i << (Cosine::kFraction - 8))};
    REQUIRE(after.factor_at(scalars[0]) == before.factor_at(scalars[0]));
    REQUIRE(after.shine_at(after, scalars) == before.shine_at(before, scalars));
  }
}
