// SPDX-License-Identifier: MIT
// Gouraud's colours before they are rounded, against the plane through the three corners: pixels are not
// clamped, so that they must not leave 0...255 by half a step, whatever the triangle.
#include <arcspan/pixel/cursor.hpp>
#include <arcspan/shading/gouraud.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Method = Gouraud<Illumination<1, Highlight::kBlinn>>;
using Vertex = RasterVertex<Method>;
using Triangle = std::array<Vertex, 3>;

/// Keeps the words as they are.
struct WordFormat {
  using Encoded = FineRgb;
  using Word = FineRgb;
  using Cursor = arcspan::WordCursor<FineRgb>;
  static constexpr unsigned kBitsPerPixel = 96;
  static constexpr bool kDithers = false;
  [[nodiscard]] static std::size_t words_per_row(std::int32_t width) {
    return static_cast<std::size_t>(width);
  }
  [[nodiscard]] static Encoded encode(FineRgb c) { return c; }
  [[nodiscard]] static Encoded encode(Rgb8) { return FineRgb{}; }
  [[nodiscard]] static Encoded encode_dithered(Rgb8, std::int32_t, std::int32_t) { return FineRgb{}; }
  [[nodiscard]] static Rgb8 decode(Encoded code) { return code.packed().rgb8(); }
};

/// A picture of the whole guard band's width. No word of a colour is kNone.
class WordSink {
 public:
  using Format = WordFormat;
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  explicit WordSink(const Rect& bounds)
      : bounds_(bounds),
        words_(static_cast<std::size_t>(bounds.width()) * static_cast<std::size_t>(bounds.height()),
               FineRgb::of(kNone, kNone, kNone)) {}

  [[nodiscard]] Rect bounds() const { return bounds_; }
  [[nodiscard]] Format::Cursor open(const Span& run) {
    runs_.push_back(run);
    return {&words_[row(run.y)], run.x - bounds_.left};
  }
  [[nodiscard]] Status close(const Span&) { return Status::kOk; }

  [[nodiscard]] const std::vector<Span>& runs() const { return runs_; }
  [[nodiscard]] const FineRgb& at(std::int32_t x, std::int32_t y) const {
    return words_[row(y) + static_cast<std::size_t>(x - bounds_.left)];
  }
  void clear() {
    for (const Span& run : runs_) {
      const auto first = words_.begin() + static_cast<std::ptrdiff_t>(row(run.y)) + (run.x - bounds_.left);
      std::fill(first, first + run.count, FineRgb::of(kNone, kNone, kNone));
    }
    runs_.clear();
  }

 private:
  [[nodiscard]] std::size_t row(std::int32_t y) const {
    return static_cast<std::size_t>(y - bounds_.top) * static_cast<std::size_t>(bounds_.width());
  }

  Rect bounds_;
  std::vector<FineRgb> words_;
  std::vector<Span> runs_;
};

constexpr std::int32_t kGuard = 16 * kGuardBand;

enum class Shape { kAny, kSliver, kFlatSliver, kHuge };

/// Corners around the raster origin; slivers are up to two pixels thick, flat ones up to three rows high.
Triangle random_triangle(Random& random, Shape shape) {
  const double size = shape == Shape::kHuge ? kGuard : 16 * random.decades(0.5, 700);
  const double x = shape == Shape::kHuge ? 0 : random.real(-1500, 1500);
  const double y = shape == Shape::kHuge ? 0 : random.real(-300, 300);
  const auto snapped = [](double c) {
    return static_cast<std::int16_t>(
        std::clamp(std::lround(c), static_cast<long>(-kGuard), static_cast<long>(kGuard - 1)));
  };
  Triangle v;
  for (Vertex& vertex : v) {
    const double height = shape == Shape::kFlatSliver ? 24 : size;
    // The extremes are as frequent as all that is between them.
    const auto level = [&] {
      return random.chance(0.5) ? 65280 * random.integer(0, 1) : random.integer(0, 65280);
    };
    vertex.position = {snapped(x + random.real(-size, size)), snapped(y + random.real(-height, height)), 0};
    vertex.shade = {level(), level(), level()};
  }
  if (shape == Shape::kFlatSliver && random.chance(0.2)) {  // over the whole guard band
    v[0].position.x = -kGuard;
    v[1].position.x = kGuard - 1;
  }
  if (shape == Shape::kSliver) {
    const double t = random.real(-0.1, 1.1);
    const double thickness = random.decades(0.5, 32);
    const auto beside = [&](std::int32_t a, std::int32_t b) {
      return snapped(a + t * (b - a) + random.real(-thickness, thickness));
    };
    v[2].position.x = beside(v[0].position.x, v[1].position.x);
    v[2].position.y = beside(v[0].position.y, v[1].position.y);
  }
  return v;
}

/// One of a vertex's channels, and the same of a pixel. Green is made as red is, blue has fewer bits.
struct Channel {
  const char* name;
  std::int32_t DeepColour::*level;
  std::uint32_t (FineRgb::*word)() const;
};
constexpr Channel kRed{"red", &DeepColour::r, &FineRgb::r};
constexpr Channel kBlue{"blue", &DeepColour::b, &FineRgb::b};

/// A channel's plane at a pixel centre, in 8-bit steps.
double plane_at(const Triangle& v, const Channel& channel, std::int32_t column, std::int32_t row) {
  const double x = 16.0 * column + 8;
  const double y = 16.0 * row + 8;
  double sum = 0;
  double area = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const RasterPosition& p = v[(i + 1) % 3].position;
    const RasterPosition& q = v[(i + 2) % 3].position;
    const double weight = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    sum += weight * (v[i].shade.*channel.level) / 256.0;
    area += weight;
  }
  return sum / area;
}

/// A word without the half step that was added, in 8-bit steps.
double value_of(std::uint32_t word) {
  return static_cast<double>(static_cast<std::int32_t>(word)) / (1 << FineRgb::kFraction) - 0.5;
}

struct Figures {
  std::uint64_t pixels = 0;
  std::int32_t longest = 0;
  double error = 0;    ///< of large triangles
  double small = 0;    ///< of small triangles, whose gradients have fewer bits
  double outside = 0;  ///< how far values of any triangle leave the three corners' range
};

void add_pixel(const Triangle& v, const Channel& channel, double value, double exact, double& error,
               Figures& figures) {
  const auto [low, high] =
      std::minmax({v[0].shade.*channel.level, v[1].shade.*channel.level, v[2].shade.*channel.level});
  figures.outside = std::max({figures.outside, low / 256.0 - value, value - high / 256.0});
  ++figures.pixels;
  error = std::max(error, std::abs(value - exact));
}

Figures measure(Shape shape, const Channel& channel, int triangles, std::uint64_t seed) {
  constexpr Rect kBand{0, 1000, 2048, 1048};
  Random random(seed);
  Figures figures;
  WordSink sink(kBand);
  RasterStage<Method, WordSink> stage(sink, 2048, 2048);
  for (int i = 0; i < triangles; ++i) {
    const Triangle v = random_triangle(random, shape);
    sink.clear();
    stage.draw(v[0], v[1], v[2]);
    SortedVertices<Method> sorted{&v[0], &v[1], &v[2], false};
    arcspan::detail::sort_by_height(sorted);
    double& error = is_small(sorted) ? figures.small : figures.error;
    for (const Span& run : sink.runs()) {
      figures.longest = std::max(figures.longest, run.count);
      for (std::int32_t x = run.x; x < run.x + run.count; ++x) {
        add_pixel(v, channel, value_of((sink.at(x, run.y).*channel.word)()),
                  plane_at(v, channel, x - 1024, run.y - 1024), error, figures);
      }
    }
  }
  return figures;
}

}  // namespace

TEST_CASE("Gouraud's unrounded colours are the plane and stay in the corners' range") {
  const auto [shape, triangles, pixels, longest] = GENERATE(table<Shape, int, std::uint64_t, std::int32_t>({
      {Shape::kAny, 3000, 1000000, 500},
      {Shape::kSliver, 40000, 50000, 40},
      {Shape::kFlatSliver, 6000, 100000, 2000},
      {Shape::kHuge, 100, 500000, 1000},
  }));
  const Channel channel = GENERATE(kRed, kBlue);
  const Figures f = measure(shape, channel, share_of(triangles), 81);
  INFO(channel.name << ", shape " << static_cast<int>(shape) << ": " << f.pixels << " pixels, longest run "
                    << f.longest << ", error " << f.error << ", of small ones " << f.small << ", outside "
                    << f.outside);
  const bool all = share_of(100) == 100;  // a few triangles need not have the longest runs
  CHECK(f.pixels > (all ? pixels : 0));
  CHECK(f.longest > (all ? longest : 0));
  CHECK(f.error < 0.025);
  CHECK(f.small < 0.15);
  CHECK(f.outside < 0.02);  // half a step is the room
}

TEST_CASE("white stays white and black stays black in every triangle") {
  Random random(82);
  constexpr Rect kBand{0, 1000, 2048, 1048};
  WordSink sink(kBand);
  RasterStage<Method, WordSink> stage(sink, 2048, 2048);
  std::uint64_t pixels = 0;
  std::uint64_t wrong = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    Triangle v = random_triangle(random, i % 2 == 0 ? Shape::kSliver : Shape::kFlatSliver);
    for (Vertex& vertex : v) vertex.shade = {65280, 0, vertex.shade.b};
    sink.clear();
    stage.draw(v[0], v[1], v[2]);
    for (const Span& run : sink.runs()) {
      for (std::int32_t x = run.x; x < run.x + run.count; ++x) {
        const Rgb8 c = sink.at(x, run.y).packed().rgb8();
        ++pixels;
        wrong += c.r == 255 && c.g == 0 ? 0u : 1u;
      }
    }
  }
  CHECK(pixels > static_cast<std::uint64_t>(share_of(100000)));
  CHECK(wrong == 0);
}

TEST_CASE("Gouraud's rows cut by a rectangle are those of the whole picture, bit for bit") {
  Random random(83);
  constexpr Rect kWhole{0, 960, 2048, 1088};
  WordSink whole(kWhole);
  WordSink cut(kWhole);
  RasterStage<Method, WordSink> all(whole, 2048, 2048);
  RasterStage<Method, WordSink> part(cut, 2048, 2048);
  std::uint64_t pixels = 0;
  std::uint64_t wrong = 0;
  for (int i = 0; i < share_of(2000); ++i) {
    const Triangle v = random_triangle(random, static_cast<Shape>(i % 4));
    const std::int32_t left = random.integer(0, 2040);
    const std::int32_t top = random.integer(960, 1080);
    whole.clear();
    cut.clear();
    all.draw(v[0], v[1], v[2]);
    part.clip_to({left, top, random.integer(left + 1, 2048), random.integer(top + 1, 1088)});
    part.draw(v[0], v[1], v[2]);
    for (const Span& run : cut.runs()) {
      for (std::int32_t x = run.x; x < run.x + run.count; ++x) {
        const FineRgb& a = whole.at(x, run.y);
        const FineRgb& b = cut.at(x, run.y);
        ++pixels;
        wrong += a.r() == b.r() && a.g() == b.g() && a.b() == b.b() ? 0u : 1u;
      }
    }
  }
  CHECK(pixels > static_cast<std::uint64_t>(share_of(100000)));
  CHECK(wrong == 0);
}
