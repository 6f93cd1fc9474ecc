// SPDX-License-Identifier: MIT
// Segments against their own model in double precision: the normal at a segment's two ends by bilinear SLERP,
// or by classic Phong as S3 prints it, the colour there by the definition, linear between.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/literature/phong_segment.hpp>
#include <arcspan/literature/segment.hpp>
#include <arcspan/pixel/rgb888.hpp>

#include <catch2/catch.hpp>
#include <tests/support/illumination_oracle.hpp>
#include <tests/support/method_accuracy.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kSize = 256;

struct Lighting {
  Vec3 light;
  Vec3 half;
  IlluminationOracle material;

  [[nodiscard]] IlluminationOracle::ChannelLevels operator()(Vec3 normal) const {
    return material.levels(dot(normal, light), dot(normal, half), dot(normal, light) > 0);
  }
};

/// `segment`: great circles; segments are no longer than the row.
struct OfArcs {
  template <class Lit>
  using Method = Segment<Lit>;

  TriangleOracle oracle;
  explicit OfArcs(const ShadedTriangle& t) : oracle(t.corner[0], t.corner[1], t.corner[2]) {}
  [[nodiscard]] TriangleOracle::Row row(std::int64_t y) const { return oracle.row(y); }
  [[nodiscard]] static std::int64_t length(const TriangleOracle::Row&, std::int64_t, std::int64_t count,
                                           int bits) {
    std::int64_t length = 1;
    while (length < std::int64_t{1} << bits && length < count - 1) length *= 2;
    return length;
  }
};

/// `phong-segment`: normals that are linear on the screen; every segment has full length.
struct OfPhong {
  template <class Lit>
  using Method = PhongSegment<Lit>;
  struct Row {
    const UnitLinearModel& normals;
    std::int64_t y;
    [[nodiscard]] Vec3 at(std::int64_t column) const { return normals.at(column, y); }
  };

  UnitLinearModel normals;
  explicit OfPhong(const ShadedTriangle& t) : normals(t) {}
  [[nodiscard]] Row row(std::int64_t y) const { return {normals, y}; }
  [[nodiscard]] static std::int64_t length(const Row&, std::int64_t, std::int64_t, int bits) {
    return std::int64_t{1} << bits;
  }
};

/// One row of pixels, columns from the picture's middle.
template <class Row>
class SegmentModel {
 public:
  SegmentModel(const Row& row, const Lighting& lighting, std::int64_t first, std::int64_t length)
      : row_(row), lighting_(lighting), first_(first), length_(length) {}
  [[nodiscard]] IlluminationOracle::ChannelLevels at(std::int64_t column) const {
    const std::int64_t part = (column - first_) % length_;
    const auto from = lighting_(row_.at(column - part));
    const auto to = lighting_(row_.at(column - part + length_));
    const double t = static_cast<double>(part) / static_cast<double>(length_);
    IlluminationOracle::ChannelLevels result;
    for (std::size_t c = 0; c < 3; ++c) result[c] = (1 - t) * from[c] + t * to[c];
    return result;
  }

 private:
  const Row& row_;
  const Lighting& lighting_;
  std::int64_t first_;
  std::int64_t length_;
};

/// A triangle drawn by segments, and what it was drawn from.
template <class Kind>
class Subject {
 public:
  using Lit = Illumination<1, Highlight::kBlinn>;
  using Method = typename Kind::template Method<Lit>;

  Subject(Random& random, double degrees, int bits) : bits_(bits) {
    do {
      triangle_ = arcspan::test::detail::random_triangle(random, radians(degrees), random.decades(3, 120));
    } while (arcspan::test::detail::thickness(triangle_) < 1);
    std::array<Direction, 3> normals;
    for (std::size_t i = 0; i < 3; ++i) {
      normals[i] = arcspan::test::detail::packed(triangle_.corner[i].normal);
      triangle_.corner[i].normal = normalised(to_vec3(normals[i]));
    }
    SegmentedIllumination<Lit> lighting(light(random));
    REQUIRE(ok(lighting.set_segment_bits(bits)));
    RasterStage<Method, hal::Framebuffer<Rgb888>> stage(frame_, kSize, kSize, lighting);
    const auto vertex = [&](std::size_t i) {
      const Point& p = triangle_.corner[i].point;
      const RasterPosition at{static_cast<std::int16_t>(p.x), static_cast<std::int16_t>(p.y), 0};
      return RasterVertex<Method>{at, Method::shade_vertex(lighting, normals[i])};
    };
    stage.draw(vertex(0), vertex(1), vertex(2), {});
  }

  /// Differences of all pixels and channels, in 8-bit steps.
  void compare(ErrorFigure& figure) {
    const Kind kind(triangle_);
    for (std::int32_t y = 0; y < kSize; ++y) {
      const auto drawn = [&](std::int32_t x) { return !(frame_.pixel(x, y) == Rgb8{}); };
      std::int32_t first = 0;
      while (first < kSize && !drawn(first)) ++first;
      std::int32_t end = first;
      while (end < kSize && drawn(end)) ++end;
      if (first == end) continue;
      const auto row = kind.row(y - kSize / 2);
      const std::int64_t left = first - kSize / 2;
      const SegmentModel model(row, lighting_, left, Kind::length(row, left, end - first, bits_));
      for (std::int32_t x = first; x < end; ++x) {
        const Rgb8 pixel = frame_.pixel(x, y);
        const auto levels = model.at(x - kSize / 2);
        figure.add(pixel.r - levels[0]);
        figure.add(pixel.g - levels[1]);
        figure.add(pixel.b - levels[2]);
      }
    }
  }

 private:
  /// Lights every normal, so that no highlight ends at N·L = 0; the ambient part tells drawn pixels from
  /// others.
  Lit light(Random& random) {
    const Vec3 middle =
        normalised(triangle_.corner[0].normal + triangle_.corner[1].normal + triangle_.corner[2].normal);
    Material material = random_material(random, true, 64);
    material.ambient.r = Coefficient::of(0.1);
    const std::array<DirectionalLight, 1> lights{
        DirectionalLight{to_direction(tilted(random, middle, random.real(0, 0.9)))}};
    const Direction eye = to_direction(tilted(random, middle, random.real(0, 0.9)));
    Lit lit;
    REQUIRE(ok(Lit::make(material, lights, eye, lit)));
    lighting_ = {to_vec3(lights[0].towards), to_vec3(half_way(lights[0].towards, eye)), to_oracle(material)};
    return lit;
  }

  int bits_;
  ShadedTriangle triangle_;
  Lighting lighting_;
  std::vector<Rgb888::Word> memory_ =
      std::vector<Rgb888::Word>(hal::Framebuffer<Rgb888>::words(kSize, kSize));
  hal::Framebuffer<Rgb888> frame_{memory_, kSize, kSize};
};

}  // namespace

TEMPLATE_TEST_CASE("segments agree with their model in double precision", "", OfArcs, OfPhong) {
  // Wider rows are drawn in pieces, each of which starts with a new segment.
  for (const double degrees : {3.0, 10.0, 21.0}) {
    for (int bits = 1; bits <= kMostSegmentBits; ++bits) {
      Random random(700 + static_cast<std::uint64_t>(bits));
      ErrorFigure figure;
      for (int i = 0; i < share_of(400); ++i) Subject<TestType>(random, degrees, bits).compare(figure);
      CAPTURE(degrees, bits, figure.max, figure.rms());
      CHECK(figure.max < 2.5);
      CHECK(figure.rms() < 0.6);
    }
  }
}

TEST_CASE("phong-segment: ends far outside of small triangles whose normals are wide apart") {
  Random random(710);
  ErrorFigure figure;
  for (int i = 0; i < share_of(400); ++i) Subject<OfPhong>(random, 60, kMostSegmentBits).compare(figure);
  CAPTURE(figure.max, figure.rms());
  CHECK(figure.max < 3);
  CHECK(figure.rms() < 0.7);
}
