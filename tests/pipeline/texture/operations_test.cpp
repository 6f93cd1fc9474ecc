// SPDX-License-Identifier: MIT
// Combinations of surfaces, operations and pixel formats against a plain interpreter in double precision.
#include <arcspan/draw.hpp>
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/draw_lines.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/argb8888.hpp>
#include <arcspan/pixel/fog.hpp>
#include <arcspan/pixel/gray2.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb332.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/pixel/xrgb8888.hpp>
#include <arcspan/scene/camera.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/vertex_coloured.hpp>
#include <arcspan/shading/with_operation.hpp>
#include <arcspan/span/depth_mode.hpp>
#include <arcspan/span/draw_pixels.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

using namespace arcspan;
using hal::Framebuffer;

namespace {

constexpr std::int32_t kWidth = 96;
constexpr std::int32_t kHeight = 64;
constexpr std::int32_t kNear = 8000;
constexpr std::int32_t kFar = 60000;
constexpr std::int32_t kFogStart = 12000;
constexpr std::int32_t kFogEnd = 40000;
constexpr Rgb8 kFogColour{200, 120, 40};
constexpr double kFull = Fog::kFull;
constexpr double kStepsPerShare = 255 / kFull;
constexpr DrawFeatures kFeatures{.clips = false, .planes = false, .small_triangles = false};

/// A slope of two triangles that leads away from the camera, with texture points and colours.
MeshView slope() {
  static constexpr std::array<ObjectPosition, 4> kPositions{
      {{-9000, -7000, 12000}, {9000, -7000, 12000}, {9000, 7000, -12000}, {-9000, 7000, -12000}}};
  static constexpr std::array<PackedNormal, 4> kNormals{};
  static constexpr std::array<std::uint8_t, 6> kIndices{0, 1, 2, 0, 2, 3};
  static constexpr std::array<TexturePoint, 4> kPoints{{{0, 4096}, {4096, 4096}, {4096, 0}, {0, 0}}};
  static constexpr std::array<Rgb8, 4> kColours{{{255, 0, 0}, {0, 255, 0}, {20, 40, 255}, {255, 255, 255}}};
  MeshView mesh;
  REQUIRE(ok(MeshView::make(kPositions, kNormals, kIndices, mesh)));
  REQUIRE(ok(mesh.attach(kPoints, TextureScale{12})));
  REQUIRE(ok(mesh.attach(kColours)));
  return mesh;
}

ClipTransform camera() {
  Placement placement{Rotation::identity(), {}};
  placement.translation[2] = ObjectLength::of(-30000.0);
  ClipTransform transform;
  REQUIRE(ok(ClipTransform::make(placement,
                                 {PixelLength::of(90.0), ObjectLength::of(kNear), ObjectLength::of(kFar)},
                                 {kWidth, kHeight}, transform)));
  return transform;
}

/// 8×8 texels of all alphas: with `Alpha4Colour` rising to the right.
Texture<DirectTexels<Alpha4Colour>> picture() {
  static const std::vector<std::uint16_t> kWords = [] {
    std::vector<std::uint16_t> words;
    for (std::uint32_t i = 0; i < 64; ++i) {
      const std::uint32_t alpha = (i & 7) * 2 + 1;
      words.push_back(static_cast<std::uint16_t>(((i * 2654435761u >> 16) & 0xFFF0u) | alpha));
    }
    return words;
  }();
  Texture<DirectTexels<Alpha4Colour>> texture;
  REQUIRE(ok(Texture<DirectTexels<Alpha4Colour>>::make(kWords, {3, 3, 1}, texture)));
  return texture;
}
const Fog& fog() {
  static const Fog kFog = [] {
    Fog made;
    REQUIRE(ok(Fog::make({ObjectLength::of(kNear).raw(), ObjectLength::of(kFar).raw(),
                          ObjectLength::of(kFogStart).raw(), ObjectLength::of(kFogEnd).raw()},
                         kFogColour, made)));
    return made;
  }();
  return kFog;
}

/// The colour that a pixel has before the surface is drawn.
Rgb8 background(std::int32_t x, std::int32_t y) {
  return {static_cast<std::uint8_t>(x * 2), static_cast<std::uint8_t>(y * 3),
          static_cast<std::uint8_t>(160 - x)};
}

/// A picture and its depths. All depths are the farthest at first, but those of every third column nearest.
template <class Format>
struct Picture {
  std::vector<typename Format::Word> words =
      std::vector<typename Format::Word>(Framebuffer<Format>::words(kWidth, kHeight));
  std::vector<std::uint16_t> depths =
      std::vector<std::uint16_t>(std::size_t{kWidth} * kHeight, DepthBuffer::kFarthest);
  Framebuffer<Format> frame{words, kWidth, kHeight};
  DepthBuffer depth{depths, kWidth, kHeight};

  Picture() {
    for (std::int32_t y = 0; y < kHeight; ++y) {
      typename Format::Cursor cursor(frame.row(y), 0);
      for (std::int32_t x = 0; x < kWidth; ++x, cursor.next()) {
        cursor.write(Format::encode(background(x, y)));
        if (x % 3 == 0) depths[index(x, y)] = 0;
      }
    }
  }
  [[nodiscard]] static std::size_t index(std::int32_t x, std::int32_t y) {
    return static_cast<std::size_t>(y * kWidth + x);
  }
};

template <class Method, class Format, class Depth>
void draw(const typename Method::Lighting& lighting, Picture<Format>& picture, const Depth& depth) {
  const DrawResult drawn = draw_mesh<Method, kFeatures>(slope(), camera(), lighting, picture.frame, depth);
  REQUIRE(drawn.status == Status::kOk);
  REQUIRE(drawn.triangles == 2);
}

struct Colour3 {
  std::array<double, 3> channel{};
};
Colour3 colour3(Rgb8 c) { return {{double(c.r), double(c.g), double(c.b)}}; }
template <class Function>
Colour3 each(const Colour3& a, const Colour3& b, Function function) {
  Colour3 result;
  for (std::size_t i = 0; i < 3; ++i)
    result.channel[i] = std::clamp(function(a.channel[i], b.channel[i]), 0.0, 255.0);
  return result;
}
Colour3 mixed(const Colour3& a, const Colour3& b, double share) {
  return each(a, b, [share](double x, double y) { return x + (y - x) * share; });
}

/// The surface alone: its colours, which pixels it covers, and their depths.
struct Surface {
  std::vector<Rgb8> colours;
  std::vector<bool> covered;
  std::vector<std::uint16_t> depths;
};

/// The interpreters of the operations: what a pixel becomes, or nothing where it is not drawn.
struct Reference {
  Colour3 surface;
  double alpha;
  double share_of_fog;
  Colour3 below;
  std::int32_t x;
  std::int32_t y;

  Colour3 operator()(const Fogged&) const { return mixed(surface, colour3(kFogColour), share_of_fog); }
  template <Blend Mode>
  Colour3 blended(const Opacity<Mode>& operation, const Colour3& above) const {
    const double share = operation.opacity / 32.0 * alpha;
    if constexpr (Mode == Blend::kAlpha) return mixed(below, above, share);
    if constexpr (Mode == Blend::kAdd)
      return each(below, above, [share](double b, double a) { return b + a * share; });
    return mixed(below, each(below, above, [](double b, double a) { return b * a / 255; }), share);
  }
  template <Blend Mode>
  Colour3 operator()(const Opacity<Mode>& operation) const {
    return blended(operation, surface);
  }
};

double share_of_fog(const FogRange& range, std::uint16_t depth) {
  const double near_plane = range.near_plane;
  const double beyond = std::clamp((depth - 256.0) / 65023, 0.0, 1.0);
  const double distance = range.orthographic ? near_plane + beyond * (range.far_plane - near_plane)
                                             : near_plane / (1 - beyond * (1 - near_plane / range.far_plane));
  return std::clamp((distance - range.start) / (double(range.end) - range.start), 0.0, 1.0);
}
double share_of_fog(std::uint16_t depth) { return share_of_fog({kNear, kFar, kFogStart, kFogEnd}, depth); }

/// An operation with its parameters.
template <class Operation>
Operation parameters() {
  if constexpr (std::same_as<Operation, Fogged>) {
    return {&fog()};
  } else if constexpr (std::same_as<Operation, ScreenDoor>) {
    return {3};
  } else {
    return Operation{19};
  }
}

using TexturedSurface = Textured<Unlit, DirectTexels<Alpha4Colour>>;

template <class Method>
typename Method::Lighting surface_lighting() {
  typename Method::Lighting lighting{};
  if constexpr (requires { lighting.texture; }) lighting.texture = picture();
  return lighting;
}

/// The surface without operations, opaque, with all bits.
template <class Method>
Surface draw_surface() {
  Picture<Rgb888> picture;
  // Blending draws texels of any alpha, so a texture that ignores it is the surface.
  auto lighting = surface_lighting<Method>();
  Surface surface;
  using Opaque = WithOperation<Method, Opacity<Blend::kAlpha>>;
  typename Opaque::Lighting all(lighting, Opacity<Blend::kAlpha>{32});
  draw<Opaque>(all, picture, picture.depth);
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const std::size_t i = picture.index(x, y);
      surface.covered.push_back(picture.depths[i] != 0 && picture.depths[i] != DepthBuffer::kFarthest);
      surface.depths.push_back(picture.depths[i]);
      surface.colours.push_back(picture.frame.pixel(x, y));
    }
  }
  return surface;
}

/// The largest difference of a channel from the interpreter, over all drawn pixels of a surface without
/// alpha.
template <class Operation, class Format>
double largest_difference() {
  using Base = UnlitVertexColoured;
  using Method = WithOperation<Base, Operation>;
  const Surface surface = draw_surface<Base>();
  Picture<Format> picture;
  const auto operation = parameters<Operation>();
  draw<Method>(typename Method::Lighting(FullLight{}, operation), picture, picture.depth);
  double worst = 0;
  int drawn = 0;
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const std::size_t i = picture.index(x, y);
      const Rgb8 below = Format::decode(Format::encode(background(x, y)));
      const Rgb8 got = picture.frame.pixel(x, y);
      REQUIRE(picture.depths[i] == surface.depths[i]);
      if (!surface.covered[i]) {
        REQUIRE(got == below);
        continue;
      }
      ++drawn;
      const Reference reference{
          colour3(surface.colours[i]), 1, share_of_fog(picture.depths[i]), colour3(below), x, y};
      const Colour3 wanted = reference(operation);
      const Colour3 have = colour3(got);
      if constexpr (Format::kBitsPerPixel == 4) {  // grey levels
        worst = std::max(worst, std::abs(have.channel[0] - 0.299 * wanted.channel[0] -
                                         0.587 * wanted.channel[1] - 0.114 * wanted.channel[2]));
      } else {
        for (std::size_t c = 0; c < 3; ++c)
          worst = std::max(worst, std::abs(have.channel[c] - wanted.channel[c]));
      }
    }
  }
  REQUIRE(drawn > 1000);
  return worst;
}

// A step of the format, and what 33 levels of opacity and fog differ from all.
constexpr double kStep888 = 3;
constexpr double kStep565 = 255 / 31.0 + 4;
constexpr double kStepGray4 = 17;

}  // namespace

TEMPLATE_TEST_CASE("fog and blending are the interpreter's in every format", "[textures]", Fogged,
                   Opacity<Blend::kAlpha>, Opacity<Blend::kAdd>, Opacity<Blend::kMultiply>) {
  CHECK(largest_difference<TestType, Rgb888>() <= kStep888);
  CHECK(largest_difference<TestType, Rgb565>() <= kStep565);
  CHECK(largest_difference<TestType, Gray4>() <= kStepGray4);
}

TEMPLATE_TEST_CASE("every pixel has the fog of its depth, however many layers a row goes through",
                   "[textures]", Rgb565, Rgb888) {
  using Method = WithOperation<UnlitVertexColoured, Fogged>;
  const double turn =
      GENERATE(0.0, 0.3, 1.2, 1.4, 1.5);  // radians from a triangle of one depth to a steep one
  std::array<ObjectPosition, 3> corners{{{-9000, -9000, 0}, {9000, -9000, 0}, {0, 9000, 0}}};
  for (ObjectPosition& corner : corners) {
    const double x = corner.x;
    corner.x = static_cast<std::int16_t>(std::lround(x * std::cos(turn)));
    corner.z = static_cast<std::int16_t>(std::lround(x * std::sin(turn) * 2));
  }
  constexpr std::array<PackedNormal, 3> kNormals{};
  constexpr std::array<std::uint8_t, 3> kIndices{0, 1, 2};
  constexpr std::array<Rgb8, 3> kColours{{{255, 255, 255}, {255, 255, 255}, {255, 255, 255}}};
  MeshView mesh;
  REQUIRE(ok(MeshView::make(corners, kNormals, kIndices, mesh)));
  REQUIRE(ok(mesh.attach(kColours)));
  Picture<TestType> picture;
  picture.frame.clear({0, 0, 0});
  picture.depth.clear();
  const Fogged fogged = parameters<Fogged>();
  const typename Method::Lighting lighting(FullLight{}, fogged);
  REQUIRE(ok(draw_mesh<Method>(mesh, camera(), lighting, picture.frame, picture.depth).status));
  int drawn = 0;
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const std::uint16_t depth = picture.depths[picture.index(x, y)];
      if (depth == DepthBuffer::kFarthest) continue;
      ++drawn;
      const auto white = PackedRgb::of(Rgb8{255, 255, 255});
      const auto in_fog = fogged.at_depth<detail::kOperates565<TestType>>(depth)(white);
      REQUIRE(picture.frame.pixel(x, y) == TestType::decode(encode_at<TestType>(in_fog, x, y)));
    }
  }
  CHECK(drawn > 90);
}

TEST_CASE("operations nest: texels with alpha are blended in fog", "[textures]") {
  using Method = WithOperation<WithOperation<TexturedSurface, Fogged>, Opacity<>>;
  Picture<Rgb565> picture;
  Picture<Rgb565> clear;
  WithOperation<TexturedSurface, Fogged>::Lighting foggy(surface_lighting<TexturedSurface>(),
                                                         parameters<Fogged>());
  draw<Method>(Method::Lighting(foggy, Opacity<>{32}), picture, picture.depth);
  using Plain = WithOperation<TexturedSurface, Opacity<>>;
  draw<Plain>(Plain::Lighting(surface_lighting<TexturedSurface>(), Opacity<>{32}), clear, clear.depth);
  int drawn = 0;
  int nearer = 0;
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const std::size_t i = picture.index(x, y);
      REQUIRE(picture.depths[i] == clear.depths[i]);
      if (picture.depths[i] == 0 || picture.depths[i] == DepthBuffer::kFarthest) continue;
      ++drawn;
      const double share = share_of_fog(picture.depths[i]);
      const Rgb8 with = picture.frame.pixel(x, y);
      const Rgb8 without = clear.frame.pixel(x, y);
      // The fog lies over the texel and is blended with it, so it moves the pixel by at most its share.
      REQUIRE(std::abs(with.r - without.r) <= share * 255 + kStep565);
      nearer += std::abs(with.r - kFogColour.r) <= std::abs(without.r - kFogColour.r) + 9 ? 1 : 0;
    }
  }
  CHECK(drawn > 1000);
  CHECK(nearer >= drawn - drawn / 50);  // a step of the format may hide it
}

TEST_CASE("without blending, texels less than half opaque are not drawn, nor is their depth", "[textures]") {
  Picture<Rgb565> masked;
  draw<TexturedSurface>(surface_lighting<TexturedSurface>(), masked, masked.depth);
  Picture<Rgb565> all;
  using Blended = WithOperation<TexturedSurface, Opacity<>>;
  draw<Blended>(Blended::Lighting(surface_lighting<TexturedSurface>(), Opacity<>{32}), all, all.depth);
  int drawn = 0;
  int open = 0;
  for (std::int32_t y = 0; y < kHeight; ++y) {
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const std::size_t i = masked.index(x, y);
      if (all.depths[i] == 0 || all.depths[i] == DepthBuffer::kFarthest) continue;
      const bool hole = masked.depths[i] == DepthBuffer::kFarthest;
      if (hole) REQUIRE(masked.frame.pixel(x, y) == Rgb565::decode(Rgb565::encode(background(x, y))));
      ++(hole ? open : drawn);
    }
  }
  CHECK(drawn > 400);
  CHECK(open > 400);
}

TEST_CASE("a screen door draws its share of the pixels, the same in every band", "[textures]") {
  using Method = WithOperation<UnlitVertexColoured, ScreenDoor>;
  const Surface surface = draw_surface<UnlitVertexColoured>();
  for (const int eighths : {0, 1, 4, 7, 8}) {
    const auto share = static_cast<std::uint8_t>(eighths);
    Picture<Rgb888> picture;
    draw<Method>(Method::Lighting(FullLight{}, ScreenDoor{share}), picture, picture.depth);
    int covered = 0;
    int drawn = 0;
    for (std::size_t i = 0; i < surface.covered.size(); ++i) {
      covered += surface.covered[i] ? 1 : 0;
      drawn += surface.covered[i] && picture.depths[i] == surface.depths[i] ? 1 : 0;
    }
    CHECK(std::abs(drawn - covered * share / 8.0) <= covered * 0.02);
  }
}

TEST_CASE("modes of the depth test draw what they say, and write only where they say", "[textures]") {
  const Surface surface = draw_surface<UnlitVertexColoured>();
  const auto drawn_with = [&](auto mode_of) {
    Picture<Rgb888> picture;
    // The surface itself, and nothing behind it.
    for (std::size_t i = 0; i < picture.depths.size(); ++i) {
      if (surface.covered[i] && i % 2 == 0) picture.depths[i] = surface.depths[i];
    }
    const std::vector<std::uint16_t> before = picture.depths;
    const auto mode = mode_of(picture.depth);
    draw<UnlitVertexColoured>(FullLight{}, picture, mode);
    std::array<int, 3> counts{};  // nearer, equal, farther than what was there
    for (std::int32_t y = 0; y < kHeight; ++y) {
      for (std::int32_t x = 0; x < kWidth; ++x) {
        const std::size_t i = picture.index(x, y);
        if (picture.frame.pixel(x, y) == background(x, y)) continue;
        ++counts[before[i] == 0 ? 2 : before[i] == DepthBuffer::kFarthest ? 0 : 1];
      }
    }
    return std::pair(counts, picture.depths == before);
  };
  const auto [near_only, near_same] = drawn_with([](const DepthBuffer& d) { return ReadOnlyDepth(d); });
  CHECK((near_only[0] > 500 && near_only[1] == 0 && near_only[2] == 0));
  CHECK(near_same);
  const auto [or_equal, equal_same] =
      drawn_with([](const DepthBuffer& d) { return DepthMode<DepthCompare::kNearerOrEqual, true>(d); });
  CHECK((or_equal[0] == near_only[0] && or_equal[1] > 500 && or_equal[2] == 0));
  CHECK(!equal_same);
  const auto [farther, farther_same] =
      drawn_with([](const DepthBuffer& d) { return DepthMode<DepthCompare::kFarther, false>(d); });
  CHECK((farther[0] == 0 && farther[1] == 0 && farther[2] > 500));
  CHECK(farther_same);
  const auto [always, always_same] =
      drawn_with([](const DepthBuffer& d) { return DepthMode<DepthCompare::kAlways, true>(d); });
  CHECK((always[0] == near_only[0] && always[1] == or_equal[1] && always[2] == farther[2]));
  CHECK(!always_same);
}

TEST_CASE("the illumination of a vertex is multiplied by its colour", "[textures]") {
  const MeshView mesh = slope();
  for (std::size_t i = 0; i < 4; ++i) {
    DeepColour vertex{65280, 32640, 100};
    UnlitVertexColoured::set_vertex_data(mesh, i, vertex);
    const Rgb8 colour = mesh.colour(i);
    CHECK(vertex.r == 256 * colour.r);
    CHECK(std::abs(vertex.g - 128 * colour.g) <= 1);
    CHECK(std::abs(vertex.b - 100 * colour.b / 255.0) <= 1);
  }
}

TEST_CASE("textures in bands are the picture drawn at once", "[textures]") {
  using Method = WithOperation<WithOperation<TexturedSurface, Fogged>, Opacity<>>;
  const Method::Lighting lighting(WithOperation<TexturedSurface, Fogged>::Lighting(
                                      surface_lighting<TexturedSurface>(), parameters<Fogged>()),
                                  Opacity<>{25});
  Picture<Rgb565> whole;
  draw<Method>(lighting, whole, whole.depth);
  Picture<Rgb565> bands;
  for (std::int32_t top = 0; top < kHeight; top += 7) {
    const std::int32_t rows = std::min(7, kHeight - top);
    const auto first = static_cast<std::ptrdiff_t>(top * kWidth);
    Framebuffer<Rgb565> band({bands.words.data() + first, static_cast<std::size_t>(rows * kWidth)}, kWidth,
                             rows, top);
    DepthBuffer depth({bands.depths.data() + first, static_cast<std::size_t>(rows * kWidth)}, kWidth, rows,
                      top);
    REQUIRE(draw_mesh<Method, kFeatures>(slope(), camera(), lighting, band, depth).status == Status::kOk);
  }
  CHECK(bands.words == whole.words);
  CHECK(bands.depths == whole.depths);
}

TEST_CASE("black that is added changes no pixel, white saturates", "[textures]") {
  constexpr PackedRgb kBlack = PackedRgb::of(2, 2, 2);  // with half steps
  constexpr PackedRgb kWhite = PackedRgb::of(1022, 1022, 1022);
  for (const std::uint32_t opacity : {0u, 1u, 17u, 32u}) {
    const Opacity<Blend::kAdd> add{opacity};
    for (std::uint32_t level = 0; level < 256; ++level) {
      const std::uint32_t below = 4 * level + 2;
      const Rgb8 kept = add(kBlack).over(PackedRgb::of(below, below, below)).rgb8();
      REQUIRE(kept == Rgb8{static_cast<std::uint8_t>(level), static_cast<std::uint8_t>(level),
                           static_cast<std::uint8_t>(level)});
    }
    CHECK(add(kWhite).over(kWhite).rgb8() == Rgb8{255, 255, 255});
  }
}

TEST_CASE("in 5-6-5 a colour over itself stays, and opacity 0 keeps every pixel", "[textures]") {
  const auto grey = [](std::uint32_t level) {
    return PackedRgb::of(4 * level + 2, 4 * level + 2, 4 * level + 2);
  };
  for (std::uint32_t level = 0; level < 256; level += 5) {
    const std::uint16_t pixel = detail::colour565(grey(level));
    for (std::uint32_t opacity = 0; opacity <= 32; ++opacity)
      REQUIRE(Opacity<>{opacity}(grey(level)).over565(pixel) == pixel);
    REQUIRE(Opacity<>{0}(grey(255 - level)).over565(pixel) == pixel);
    REQUIRE(Opacity<Blend::kMultiply>{0}(grey(255 - level)).over565(pixel) == pixel);
    REQUIRE(Opacity<Blend::kMultiply>{32}(grey(255)).over565(pixel) == pixel);
  }
}

TEST_CASE("over pixels that are not opaque a surface is blended into the alpha", "[textures]") {
  // Three layers of a colour over pixels of every alpha, against the same in double precision.
  constexpr Rgb8 kSurface{250, 130, 3};
  const auto draw = [&](std::uint32_t below, std::uint32_t opacity) {
    const auto colour = Opacity<>{opacity}(PackedRgb::of(kSurface));
    return detail::operated<Argb8888>(colour, below, 0, 0);
  };
  for (std::uint32_t alpha = 0; alpha < 256; ++alpha) {
    for (const std::uint32_t opacity : {1u, 7u, 16u, 31u}) {
      CAPTURE(alpha, opacity);
      std::uint32_t pixel = alpha << 24 | 0x1060F0u;
      for (int layer = 0; layer < 3; ++layer) {
        const std::uint32_t before = pixel;
        pixel = draw(before, opacity);
        const double share = opacity / 32.0;
        const double rest = (before >> 24) / 255.0 * (1 - share);
        CHECK(std::abs((pixel >> 24) - 255 * (share + rest)) <= 0.5 + 1e-9);
        const std::uint32_t channels[] = {kSurface.r, kSurface.g, kSurface.b};
        for (unsigned i = 0; i < 3; ++i) {
          const unsigned shift = 16 - 8 * i;
          const double mixed = (channels[i] * share + (before >> shift & 255u) * rest) / (share + rest);
          // An opaque pixel is blended in ten bits per channel.
          CHECK(std::abs((pixel >> shift & 255u) - mixed) <= (before >> 24 == 255 ? 1 : 0.5 + 1e-9));
        }
      }
    }
  }
  CHECK(draw(0x00123456u, 32) == 0xFFFA8203u);
  CHECK(draw(0x80123456u, 0) == 0x80123456u);
  // Over opaque pixels the colour is that of Xrgb8888.
  for (const std::uint32_t opacity : {0u, 5u, 16u, 32u}) {
    const auto colour = Opacity<>{opacity}(PackedRgb::of(kSurface));
    CHECK(draw(0xFF1060F0u, opacity) == (detail::operated<Xrgb8888>(colour, 0x1060F0u, 0, 0) | 0xFF000000u));
  }
}

TEST_CASE("quotients of alpha are those of a division, at every step", "[textures]") {
  std::size_t wrong = 0;
  for (std::uint32_t d = 1; d <= 8160; d += d < 300 ? 1 : 7) {
    const Reciprocal of_d = nonzero_reciprocal(d);
    for (std::uint32_t q = 0; q < 255; ++q) {
      // On both sides of where rounding goes up to q + 1.
      const std::uint32_t up = q * d + d - d / 2;
      for (const std::uint32_t n : {up - 1, up})
        wrong += detail::rounded_quotient(n, d, of_d) != (n + d / 2) / d;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("an opaque colour and a pixel below nothing keep all bits", "[textures]") {
  for (std::uint32_t level = 0; level < 1024; level += 31) {
    const PackedRgb surface = PackedRgb::of(level, 1023 - level, level ^ 511);
    const PackedRgb below = PackedRgb::of(1023 - level, level ^ 255, level);
    REQUIRE(Opacity<>{32}(surface).over(below).lanes == surface.lanes);
    REQUIRE(Opacity<>{0}(surface).over(below).lanes == below.lanes);
  }
}

TEST_CASE("fog is within 1.5 steps of 255 at every depth, and complete at its end", "[textures]") {
  constexpr std::int32_t kUnit = 2000;
  const int ratio = GENERATE(2, 10, 100, 1000);
  // In near planes: all of the range, a band, from before the near plane, up to behind the far one.
  const auto [start, end] = GENERATE_COPY(std::pair(1.0, 1.0 * ratio), std::pair(0.4 * ratio, 0.6 * ratio),
                                          std::pair(0.95 * ratio, 0.99 * ratio), std::pair(-2.0, 0.3 * ratio),
                                          std::pair(0.5 * ratio, 3.0 * ratio));
  const FogRange range{kUnit, kUnit * ratio, static_cast<std::int32_t>(kUnit * start),
                       static_cast<std::int32_t>(kUnit * end), GENERATE(false, true)};
  Fog made;
  REQUIRE(ok(Fog::make(range, kFogColour, made)));
  double worst = 0;
  int incomplete = 0;
  for (int i = 256; i <= 65535 - 256; ++i) {  // near plane to far plane
    const auto depth = static_cast<std::uint16_t>(i);
    const double wanted = share_of_fog(range, depth);
    const std::uint32_t share = made.share(depth);
    worst = std::max(worst, std::abs(share * kStepsPerShare - wanted * 255));
    incomplete += wanted >= 1 && share != Fog::kFull ? 1 : 0;
  }
  CHECK(worst <= 1.4);
  CHECK(incomplete == 0);
}

TEST_CASE("fog a thousandth of its distance thick is as exact", "[textures]") {
  const auto range =
      GENERATE(FogRange{16450, 968772, 17045, 17064}, FogRange{337215, 46234066, 585329, 586011},
               FogRange{2000001, 2000000001, 2090000, 2092091});
  Fog made;
  REQUIRE(ok(Fog::make(range, kFogColour, made)));
  double worst = 0;
  for (std::int32_t i = 256; i <= 65535 - 256; ++i) {
    const auto depth = static_cast<std::uint16_t>(i);
    worst = std::max(worst, std::abs(made.share(depth) * kStepsPerShare - share_of_fog(range, depth) * 255));
  }
  CHECK(worst <= 1.5);
}

TEST_CASE("fog of another colour is that which make() makes of it", "[textures]") {
  constexpr FogRange kRange{1000, 60000, 8000, 40000};
  constexpr Rgb8 kNight{12, 20, 57};
  Fog night;
  Fog changed;
  REQUIRE(ok(Fog::make(kRange, kNight, night)));
  REQUIRE(ok(Fog::make(kRange, kFogColour, changed)));
  changed.set_colour(kNight);
  CHECK(changed.colour().lanes == PackedRgb::of(kNight).lanes);
  CHECK(night.colour().lanes == PackedRgb::of(kNight).lanes);
  CHECK(changed.spread_colour() == night.spread_colour());
  for (std::uint32_t depth = 0; depth < 65536; depth += 13) {
    const auto at = static_cast<std::uint16_t>(depth);
    REQUIRE(changed.share(at) == night.share(at));
  }
}

TEST_CASE("fog grows linearly with the distance of what is drawn", "[textures]") {
  const ClipTransform transform = camera();
  for (double w = kNear; w <= kFar; w += 61) {
    const auto near_over_w = static_cast<std::int32_t>(std::lround(std::ldexp(kNear / w, 29)));
    const double share = fog().share(transform.depth(near_over_w)) / kFull;
    REQUIRE(std::abs(share - std::clamp((w - kFogStart) / (kFogEnd - kFogStart), 0.0, 1.0)) <= 0.004);
  }
}

TEST_CASE("lines and points have the fog of where they are, whatever their bias", "[textures]") {
  using Misty = WithOperation<Unlit, Fogged>;
  using Wires = Wireframe<WithOperation<Misty, Opacity<>>>;
  constexpr std::int16_t kSide = 3000;
  constexpr std::array<PackedNormal, 3> kNormals{};
  constexpr std::array<std::uint8_t, 3> kIndices{0, 1, 2};
  const int kind = GENERATE(0, 1, 2);  // edges, lines, points
  const DepthBias bias{GENERATE(as<std::uint16_t>{}, 2000, 65535)};
  const ClipTransform transform = camera();
  const Misty::Lighting misty(Unlit::lighting({0, 0, 0}), parameters<Fogged>());
  const Wires::Lighting wires(WithOperation<Misty, Opacity<>>::Lighting(misty, Opacity<>{32}), bias);
  for (std::int16_t z = 20000; z >= -28000; z = static_cast<std::int16_t>(z - 1600)) {
    const std::array<ObjectPosition, 3> corners{{{-kSide, -kSide, z}, {kSide, -kSide, z}, {0, kSide, z}}};
    const double share = std::clamp((30000.0 - z - kFogStart) / (kFogEnd - kFogStart), 0.0, 1.0);
    Picture<Rgb888> picture;
    picture.frame.clear({0, 0, 255});
    picture.depth.clear();
    if (kind == 0) {
      MeshView mesh;
      REQUIRE(ok(MeshView::make(corners, kNormals, kIndices, mesh)));
      REQUIRE(ok(draw_mesh<Wires>(mesh, transform, wires, picture.frame, picture.depth).status));
    } else if (kind == 1) {
      const ObjectLine line{corners[0], corners[2]};
      REQUIRE(ok(draw_lines<Misty>({&line, 1}, transform, misty, picture.frame, picture.depth, bias)));
    } else {
      REQUIRE(ok(draw_points<Misty>(corners, 3, transform, misty, picture.frame, picture.depth, bias)));
    }
    int drawn = 0;
    for (std::int32_t y = 0; y < kHeight; ++y) {
      for (std::int32_t x = 0; x < kWidth; ++x) {
        if (picture.depths[picture.index(x, y)] == DepthBuffer::kFarthest) continue;
        ++drawn;
        REQUIRE(std::abs(picture.frame.pixel(x, y).r - share * kFogColour.r) <= 2);
      }
    }
    CHECK(drawn > 6);
  }
}

TEST_CASE("lines on the screen that lead beyond the planes have the fog of their depth", "[textures]") {
  using Misty = WithOperation<Unlit, Fogged>;
  const Misty::Lighting misty(Unlit::lighting({0, 0, 0}), parameters<Fogged>());
  for (const auto& [from, to] : {std::pair{60700, 65535}, std::pair{4800, 0}}) {
    // The centre of the last pixel is half a pixel behind the end.
    const RasterPosition begin{-160, 0, static_cast<std::uint16_t>(from)};
    const RasterPosition end{0, 0, static_cast<std::uint16_t>(to)};
    Picture<Rgb888> picture;
    picture.depth.clear();
    REQUIRE(ok(draw_screen_line<Misty>(begin, end, {kWidth, kHeight}, misty, picture.frame, picture.depth)));
    int drawn = 0;
    for (std::int32_t x = 0; x < kWidth; ++x) {
      const std::uint16_t depth = picture.depths[picture.index(x, kHeight / 2)];
      if (depth == DepthBuffer::kFarthest) continue;
      ++drawn;
      const double wanted = share_of_fog(depth) * kFogColour.r;
      CHECK(std::abs(picture.frame.pixel(x, kHeight / 2).r - wanted) <= 2);
    }
    CHECK(drawn == 11);
  }
}

TEST_CASE("fog before an orthographic camera grows linearly, too", "[textures]") {
  Camera lens;
  REQUIRE(ok(Camera::make({WorldPoint::of(0, 0, 10), {}},
                          Lens::orthographic(WorldLength::of(8), WorldLength::of(1), WorldLength::of(9)),
                          {kWidth, kHeight}, lens)));
  Fog made;
  REQUIRE(ok(Fog::make({WorldLength::of(1).raw(), WorldLength::of(9).raw(), WorldLength::of(2).raw(),
                        WorldLength::of(8).raw(), true},
                       kFogColour, made)));
  for (int eighths = 8; eighths <= 72; ++eighths) {
    const std::int32_t z = WorldLength::of(10).raw() - WorldLength::of(0.125).raw() * eighths;
    const std::uint16_t depth = lens.project({{}, {}, WorldLength::from_raw(z)}).depth;
    const double share = std::clamp((eighths / 8.0 - 2) / 6, 0.0, 1.0);
    REQUIRE(std::abs(made.share(depth) / kFull - share) <= 0.006);
  }
}

TEST_CASE("fog within fog is seen through both", "[textures]") {
  Fog green;
  REQUIRE(ok(Fog::make({ObjectLength::of(kNear).raw(), ObjectLength::of(kFar).raw(),
                        ObjectLength::of(kNear).raw(), ObjectLength::of(kFar).raw()},
                       {0, 255, 0}, green)));
  constexpr PackedRgb kSurface = PackedRgb::of(800, 700, 600);
  for (std::uint32_t depth = 256; depth < 65280; depth += 777) {
    const auto at = static_cast<std::uint16_t>(depth);
    const auto within = Fogged{&green}.at_depth<false>(at)(kSurface);
    const auto both = Fogged{&fog()}.at_depth<false>(at)(within);
    REQUIRE(both.packed().lanes == Fogged{&fog()}.at_depth<false>(at)(within.packed()).packed().lanes);
  }
}

/// How far the mean of a dithered surface is from what it should be when another is blended over it, in steps
/// of 255: the largest over all their greys and the opacities of 1/8...7/8.
template <class Format>
double blended_mean_error() {
  using Dithers = Dithered<Format>;
  double worst = 0;
  for (int grey = 0; grey < 256; grey += 15) {
    for (int over = 0; over < 256; over += 15) {
      for (int opacity = 4; opacity <= 28; opacity += 4) {
        const auto colour = Opacity<>{static_cast<std::uint32_t>(opacity)}(
            PackedRgb::grey(static_cast<std::uint32_t>(4 * over + 2)));
        double mean = 0;
        for (std::int32_t at = 0; at < 64; ++at) {
          const auto below =
              encode_at<Dithers>(PackedRgb::grey(static_cast<std::uint32_t>(4 * grey + 2)), at % 8, at / 8);
          mean += Dithers::decode(detail::operated<Dithers>(colour, below, at % 8, at / 8)).g / 64.0;
        }
        worst = std::max(worst, std::abs(mean - (grey + (over - grey) * opacity / 32.0)));
      }
    }
  }
  return worst;
}

TEST_CASE("what is blended over a dithered surface changes its mean as it should") {
  CHECK(blended_mean_error<Mono>() <= 20);
  CHECK(blended_mean_error<Gray2>() <= 6.5);
  CHECK(blended_mean_error<Rgb332>() <= 3.5);
  CHECK(blended_mean_error<Gray4>() <= 3);
  CHECK(blended_mean_error<Rgb565>() <= 1);
}

TEST_CASE("a screen door keeps the alpha of texels for what blends them", "[textures]") {
  struct Leaf {
    std::uint32_t opacity;
    [[nodiscard]] PackedRgb packed() const { return PackedRgb::of(1022, 1022, 1022); }
    [[nodiscard]] std::uint32_t alpha() const { return opacity; }
    [[nodiscard]] bool covers(std::int32_t, std::int32_t) const { return opacity >= 8; }
  };
  constexpr PackedRgb kBlack = PackedRgb::of(2, 2, 2);
  for (std::uint32_t alpha = 0; alpha <= 16; ++alpha) {
    const Leaf leaf{alpha};
    const auto open = Opacity<>{32}(ScreenDoor{8}.in_row(0, 0)(leaf));
    const auto plain = Opacity<>{32}(leaf);
    CHECK(open.covers(0, 0) == plain.covers(0, 0));
    CHECK(open.over(kBlack).lanes == plain.over(kBlack).lanes);
    CHECK_FALSE(Opacity<>{32}(ScreenDoor{0}.in_row(0, 0)(leaf)).covers(0, 0));
  }
}

TEST_CASE("fog refuses ranges that make no sense, and keeps what it was") {
  Fog made = fog();
  for (const FogRange range :
       {FogRange{0, 100, 1, 2}, {100, 100, 1, 2}, {10, 100, 50, 50}, {10, 100, 60, 50}}) {
    CHECK(Fog::make(range, {1, 2, 3}, made) == Status::kInvalidArgument);
    CHECK(made.share(65000) == fog().share(65000));
  }
  for (std::uint32_t depth = 0; depth < 65536; depth += 13) {
    const auto at = static_cast<std::uint16_t>(depth);
    REQUIRE(std::abs(fog().share(at) / kFull - share_of_fog(at)) <= 0.008);
  }
}
