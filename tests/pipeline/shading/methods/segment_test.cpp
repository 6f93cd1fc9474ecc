// SPDX-License-Identifier: MIT
// Segments, and what adaptive makes of its tolerance.
#include <arcspan/literature/segment.hpp>
#include <arcspan/pixel/colour_segment.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/adaptive/adaptive.hpp>

#include <catch2/catch.hpp>
#include <tests/support/illumination_oracle.hpp>
#include <tests/support/test_share.hpp>
#include <tests/support/triangle_picture.hpp>

#include <array>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kSize = 64;

std::uint32_t random_level(Random& random) {
  return random.chance(0.2) ? (random.chance(0.5) ? 0u : 1023u)
                            : static_cast<std::uint32_t>(random.integer(0, 1023));
}

Material random_material(Random& random) {
  const auto share = [&random](double most) {
    return Coefficient::from_raw(static_cast<std::int32_t>(random.real(0, most) * 32768));
  };
  const auto channels = [&share](double most) {
    ChannelCoefficients c;
    c.r = share(most);
    c.g = share(most);
    c.b = share(most);
    return c;
  };
  Material material;
  material.ambient = channels(0.3);
  material.diffuse = channels(1);
  material.specular = channels(1);
  material.shininess = static_cast<std::int32_t>(random.decades(1, 256));
  return material;
}

template <class Lit>
Lit random_light(Random& random, const Direction& near) {
  std::array<DirectionalLight, Lit::kLights> lights;
  const Vec3 normal = to_vec3(near);
  for (DirectionalLight& light : lights) {
    light.towards = to_direction(tilted(random, normal, random.real(0, 1.8)));
    light.strength = Coefficient::from_raw(static_cast<std::int32_t>(32768 / Lit::kLights));
  }
  const Vec3 eye = tilted(random, normal, random.real(0, 1.2));
  Lit lit;
  const Material material = random_material(random);
  REQUIRE(ok(Lit::make(material, lights, to_direction(eye), lit)));
  return lit;
}

/// The most that adaptive differs from arc, over the tolerance, in triangles of at most `size` pixels.
template <class Lit>
int most_beyond_tolerance(std::uint64_t seed, int triangles, std::int32_t tolerance,
                          std::int32_t size = kSize) {
  Random random(seed);
  int most = -256;
  for (int i = 0; i < share_of(triangles); ++i) {
    const bool wide = random.chance(0.5);
    const ScreenTriangle triangle =
        random_screen_triangle(random, size, wide ? random.real(16, 120) : random.decades(0.5, 60));
    const Lit lit = random_light<Lit>(random, triangle.normals[0]);
    AdaptiveIllumination<Lit> lighting(lit);
    REQUIRE(ok(lighting.set_tolerance(tolerance)));
    const TrianglePicture exact = picture_of<Arc<Lit>>(triangle, lit, size);
    const TrianglePicture near = picture_of<Adaptive<Lit>>(triangle, lighting, size);
    const int beyond = most_different(exact, near) - tolerance;
    if (beyond > most) {
      most = beyond;
      UNSCOPED_INFO("triangle " << i << " is off by " << beyond + tolerance);
    }
  }
  return most;
}

}  // namespace

TEST_CASE("a colour segment is exact at both ends and rounds down between") {
  Random random(1);
  for (int i = 0; i < share_of(20000); ++i) {
    const int bits = static_cast<int>(random.integer(0, ColourSegment::kFraction));
    std::array<std::uint32_t, 3> from{};
    std::array<std::uint32_t, 3> to{};
    for (std::uint32_t& c : from) c = random_level(random);
    for (std::uint32_t& c : to) c = random_level(random);
    ColourSegment colour = ColourSegment::of(PackedRgb::of(from[0], from[1], from[2]));
    const ColourSegment end = ColourSegment::of(PackedRgb::of(to[0], to[1], to[2]));
    const ColourSegment step = colour.step_to(end, bits);
    for (std::uint32_t k = 0; k <= 1u << bits; ++k) {
      const auto level = [&](std::size_t c) { return (from[c] * ((1u << bits) - k) + to[c] * k) >> bits; };
      const PackedRgb expected = PackedRgb::of(level(0), level(1), level(2));
      REQUIRE(colour.packed().lanes == expected.lanes);
      REQUIRE(Rgb565::encode(colour) == Rgb565::encode(expected));
      colour.advance(step);
    }
  }
}

TEST_CASE("a patch's stride is its single steps, to the last bit") {
  using Lit = Illumination<1, Highlight::kBlinn>;
  Random random(2);
  for (int i = 0; i < share_of(5000); ++i) {
    PatchScalar scalar{};
    scalar.left.at = Cosine::from_raw(static_cast<std::int32_t>(random.bits()) >> 2);
    scalar.left.slope = Cosine::from_raw(static_cast<std::int32_t>(random.bits()) >> random.integer(6, 20));
    scalar.second_difference =
        Cosine::from_raw(static_cast<std::int32_t>(random.bits()) >> random.integer(10, 20));
    PatchRun<Lit, 2> single;
    const auto fraction = static_cast<std::uint32_t>(random.integer(0, 65535));
    single.start(0, scalar, fraction);
    single.start(1, scalar, fraction);
    PatchRun<Lit, 2> stride = single;
    const int bits = static_cast<int>(random.integer(0, 4));
    REQUIRE(stride.stride(bits) == bits);
    for (int k = 0; k < 5; ++k) {
      REQUIRE(stride.scalars() == single.scalars());
      stride.next();
      for (int n = 0; n < 1 << bits; ++n) single.next();
    }
  }
}

TEST_CASE("segments begin with arc's colour, and their error falls with the square of their length") {
  using Lit = Illumination<1, Highlight::kPhong>;
  Random random(4);
  std::array<double, kMostSegmentBits + 1> squares{};
  for (int i = 0; i < 300; ++i) {
    const ScreenTriangle triangle = random_screen_triangle(random, kSize, 30);
    const Lit lit = random_light<Lit>(random, triangle.normals[0]);
    const TrianglePicture exact = picture_of<Arc<Lit>>(triangle, lit, kSize);
    for (int bits = 1; bits <= kMostSegmentBits; ++bits) {
      SegmentedIllumination<Lit> lighting(lit);
      REQUIRE(ok(lighting.set_segment_bits(bits)));
      const TrianglePicture near = picture_of<Segment<Lit>>(triangle, lighting, kSize);
      for (std::int32_t y = 0; y < kSize; ++y) {
        bool first = true;
        for (std::int32_t x = 0; x < kSize; ++x) {
          const Rgb8 colour = exact.frame.pixel(x, y);
          if (colour == Rgb8{}) continue;
          const int off = difference(colour, near.frame.pixel(x, y));
          if (first) REQUIRE(off == 0);
          first = false;
          squares[static_cast<std::size_t>(bits)] += off * off;
        }
      }
    }
  }
  for (int bits = 2; bits <= kMostSegmentBits; ++bits) {
    CAPTURE(bits, squares[static_cast<std::size_t>(bits)], squares[static_cast<std::size_t>(bits - 1)]);
    // The longest do not fit many rows.
    CHECK(squares[static_cast<std::size_t>(bits)] >
          (bits == kMostSegmentBits ? 1.4 : 2) * squares[static_cast<std::size_t>(bits - 1)]);
  }
}

TEST_CASE("settings out of range are refused and change nothing") {
  using Lit = Illumination<1, Highlight::kBlinn>;
  Random random(5);
  const Lit lit = random_light<Lit>(random, to_direction(Vec3{0, 0, 1}));
  SegmentedIllumination<Lit> segments(lit);
  CHECK(segments.set_segment_bits(0) == Status::kInvalidArgument);
  CHECK(segments.set_segment_bits(kMostSegmentBits + 1) == Status::kInvalidArgument);
  CHECK(segments.bits == 2);
  AdaptiveIllumination<Lit> adaptive(lit);
  const std::uint32_t limit = adaptive.linear_limit(0);
  CHECK(adaptive.set_tolerance(-1) == Status::kInvalidArgument);
  CHECK(adaptive.set_tolerance(65) == Status::kInvalidArgument);
  CHECK(adaptive.linear_limit(0) == limit);
  CHECK(ok(adaptive.set_tolerance(0)));
  CHECK(adaptive.linear_limit(0) == 0);
}

TEST_CASE("adaptive stays within its tolerance of arc") {
  // One step more for rounding: colours of arc come in steps too, up to one of its ramp's 256.
#ifdef ARCSPAN_SANITIZED
  const std::int32_t tolerance = GENERATE(0, 2, 64);
#else
  const std::int32_t tolerance = GENERATE(0, 1, 2, 5, 20, 64);
#endif
  CAPTURE(tolerance);
  const auto seed = static_cast<std::uint64_t>(10 + tolerance);
  CHECK(most_beyond_tolerance<Illumination<1, Highlight::kBlinn>>(seed, 6000, tolerance) <= 1);
  CHECK(most_beyond_tolerance<Illumination<1, Highlight::kPhong>>(seed, 8000, tolerance) <= 1);
  CHECK(most_beyond_tolerance<Illumination<2, Highlight::kBlinn>>(seed, 2000, tolerance) <= 1);
  CHECK(most_beyond_tolerance<Illumination<3, Highlight::kPhong>>(seed, 2000, tolerance) <= 1);
}

TEST_CASE("adaptive stays within its tolerance of arc in small triangles") {
  const std::int32_t tolerance = GENERATE(0, 1, 5);
  CAPTURE(tolerance);
  const auto seed = static_cast<std::uint64_t>(80 + tolerance);
  CHECK(most_beyond_tolerance<Illumination<1, Highlight::kBlinn>>(seed, 20000, tolerance, kSmallSize) <= 1);
  CHECK(most_beyond_tolerance<Illumination<1, Highlight::kPhong>>(seed, 20000, tolerance, kSmallSize) <= 1);
  CHECK(most_beyond_tolerance<Illumination<2, Highlight::kPhong>>(seed, 4000, tolerance, kSmallSize) <= 1);
}

TEST_CASE("the error of wide patches of N·L is what omitted highlights leave of the tolerance") {
  using Lit = Illumination<1, Highlight::kPhong>;
  Material material;
  material.diffuse.r = Coefficient::of(0.6);
  material.shininess = 16;
  Lit lit;
  REQUIRE(ok(Lit::make(material, {DirectionalLight{to_direction(Vec3{0, 0, 1})}}, to_direction(Vec3{0, 0, 1}),
                       lit)));
  AdaptiveIllumination<Lit> lighting(lit);
  const auto steps = [&](std::int32_t half_distance) {
    return lighting.diffuse_patch_error(half_distance) * 0x1p-20 * 255 * 0.6;
  };
  CHECK(steps(INT32_MAX) == Approx(0.875).epsilon(0.002));
  CHECK(steps(0) == Approx(0.5).epsilon(0.002));
  REQUIRE(ok(lighting.set_tolerance(0)));
  // Arc has this error where no highlight is within reach.
  CHECK(steps(INT32_MAX) == Approx(kPatchError / 32.0).epsilon(0.002));
  CHECK(steps(0) == 0);
  REQUIRE(ok(lighting.set_tolerance(64)));
  CHECK(steps(INT32_MAX) == Approx(56).epsilon(0.002));
}

namespace {

template <class Several>
HighlightPath highlight_path(const AdaptiveIllumination<Several>& lighting, const ScreenTriangle& t) {
  using Shading = Adaptive<Several>;
  const auto vertex = [&](std::size_t i) {
    return RasterVertex<Shading>{t.points[i], Shading::shade_vertex(lighting, t.normals[i])};
  };
  TriangleCommand<Shading> command;
  if (!prepare_triangle<Shading>(lighting, vertex(0), vertex(1), vertex(2), {}, {-80, 80}, command))
    return HighlightPath::kNone;
  return command.shade.highlight_path;
}

/// The triangles whose highlights Adaptive draws by a path, and the largest difference of their pixels from
/// those of Arc in 8-bit steps.
struct PathDifference {
  int found = 0;
  int most = 0;
};

/// Draws random triangles of 12 to 30 degrees and returns the differences of each HighlightPath.
template <std::size_t Lights>
std::array<PathDifference, 5> highlight_differences(std::int32_t shininess) {
  using Several = Illumination<Lights, Highlight::kPhong>;
  Random random(11);
  std::array<PathDifference, 5> differences;
  for (int i = 0; i < share_of(3000); ++i) {
    const ScreenTriangle triangle = random_screen_triangle(random, kSize, random.real(12, 30));
    const Vec3 middle = normalised(to_vec3(triangle.normals[0]) + to_vec3(triangle.normals[1]));
    const Vec3 to_eye = tilted(random, middle, random.real(0, 0.7));
    const auto grey = [](Coefficient c) { return ChannelCoefficients{c, c, c}; };
    const Material material{{}, grey(Coefficient::of(0.4)), grey(Coefficient::of(1)), shininess};
    std::array<DirectionalLight, Lights> lights{};
    for (std::size_t k = 0; k < Lights; ++k) {
      // The mirrored eye, or anywhere for the others.
      const Vec3 half = tilted(random, middle, random.real(0, k == 0 ? 0.3 : 1.5));
      lights[k].towards = to_direction(normalised(2 * dot(half, to_eye) * half - to_eye));
      if (Lights > 1) lights[k].strength = k == 0 ? Coefficient::of(0.7) : Coefficient::of(0.3);
    }
    Several lit;
    REQUIRE(ok(Several::make(material, lights, to_direction(to_eye), lit)));
    const AdaptiveIllumination<Several> lighting(lit);
    const HighlightPath path = highlight_path(lighting, triangle);
    if (path < HighlightPath::kProduct) continue;
    PathDifference& here = differences[static_cast<std::size_t>(path)];
    ++here.found;
    here.most = std::max(here.most, most_different(picture_of<Arc<Several>>(triangle, lit, kSize),
                                                   picture_of<Adaptive<Several>>(triangle, lighting, kSize)));
  }
  return differences;
}

}  // namespace

// By three lights, whose types other tests here draw by, too. With n = 64 both arc and the factors are one
// step off by rounding.
TEST_CASE("highlights of paths 5 and 6 are within a step of those of arc, two with n = 64") {
  const std::int32_t shininess = GENERATE(2, 4, 8, 16, 32, 64);
  CAPTURE(shininess);
  const int allowed = shininess < 64 ? 1 : 2;
  const auto check = [allowed](const auto& differences, HighlightPath path, int at_least) {
    const PathDifference& difference = differences[static_cast<std::size_t>(path)];
    CAPTURE(static_cast<int>(path));
    CHECK(difference.most <= allowed);
    CHECK(difference.found >= at_least);
  };
  check(highlight_differences<1>(shininess), HighlightPath::kProduct, share_of(3000) / 200);
  const auto several = highlight_differences<3>(shininess);
  // Up to n = 4 path 4 reaches 28 degrees, which leaves too few triangles to quartics.
  if (shininess > 4) check(several, HighlightPath::kQuartic, share_of(3000) / 200);
  check(several, HighlightPath::kSum, share_of(3000) / 200);
}
