// SPDX-License-Identifier: MIT
// Dichotomy: its polynomials over all arguments, its pixels against its own model in double precision, and
// that cutting a row changes none of them.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/literature/dichotomy.hpp>
#include <arcspan/pixel/rgb888.hpp>

#include <catch2/catch.hpp>
#include <tests/support/dichotomy_model.hpp>
#include <tests/support/method_accuracy.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/test_share.hpp>

#include <cmath>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// Of `above_half` and of `halved_chord`: half a unit of 18 bits for every rounding, and those of the chord.
constexpr double kRounding = 5e-6;

struct PolynomialFigures {
  double most = 0;           ///< largest relative error of p
  double most_rounding = 0;  ///< largest difference from the polynomial in double precision
  double most_halved = 0;    ///< of the halved chord
};

template <class Polynomial>
PolynomialFigures sweep(double (*model)(double)) {
  PolynomialFigures figures;
  const auto end = static_cast<std::uint32_t>((2 - 2 * std::cos(k45Degrees)) * 65536);
  for (std::uint32_t raw = 0; raw <= end; ++raw) {
    const double s = raw / 65536.0;
    const std::int32_t q = Polynomial::above_half(raw);
    const double p = 0.5 + q / 262144.0;
    figures.most = std::max(figures.most, std::fabs(p * std::sqrt(4 - s) - 1));
    figures.most_rounding = std::max(figures.most_rounding, std::fabs(p - model(s)));
    const double halved = 2 - (4 - s) * model(s);
    figures.most_halved = std::max(figures.most_halved, std::fabs(halved_chord(raw, q) / 65536.0 - halved));
  }
  return figures;
}

struct Bounds {
  double most;
  double rms;
  double sliver_rms = 0.02;
};

template <double (*P)(double), int SegmentBits = 3, bool FullLast = false>
void check(std::string_view method, MethodTask task, Bounds bounds) {
  task.triangles = share_of(1500);
  const MethodFigures f =
      measure_method<DichotomyModel<P, SegmentBits, FullLast>>(probed_method(method), task);
  INFO(method << ": N·L max " << f.normal_light.max << " rms " << f.normal_light.rms() << ", N·H max "
              << f.normal_half.max << ", pixels " << f.normal_light.count << ", slivers rms "
              << f.slivers.rms());
  CHECK(f.missing == 0);
  CHECK(f.normal_light.count > static_cast<std::uint64_t>(task.triangles) * 20);
  CHECK(f.normal_light.max < bounds.most);
  CHECK(f.normal_half.max < bounds.most);
  CHECK(f.normal_light.rms() < bounds.rms);
  CHECK(f.slivers.rms() < bounds.sliver_rms);
}

MethodTask angles(double from, double to, std::uint64_t seed) {
  MethodTask task;
  task.from_degrees = from;
  task.to_degrees = to;
  task.seed = seed;
  return task;
}

}  // namespace

TEST_CASE("the polynomials of 1/sqrt(2 + z) are as good as they say, over every chord up to 45 degrees") {
  const PolynomialFigures first = sweep<LinearPolynomial>(&linear_root);
  CHECK(first.most < 1.59e-3);
  CHECK(first.most > 1.5e-3);
  const PolynomialFigures second = sweep<QuadraticPolynomial>(&quadratic_root);
  CHECK(second.most < 4.8e-5 + kRounding);
  CHECK(second.most > 4e-5);
  const PolynomialFigures third = sweep<CubicPolynomial>(&cubic_root);
  CHECK(third.most < 1.6e-6 + 2 * kRounding);
  const PolynomialFigures root = sweep<RootItself>(&exact_root);
  CHECK(root.most < 2e-5);
  CHECK(root.most_halved < 1e-4);
  const PolynomialFigures printed_first = sweep<PrintedLinearPolynomial>(&printed_linear_root);
  CHECK(printed_first.most < 2.2e-3);
  CHECK(printed_first.most > 2.1e-3);
  const PolynomialFigures printed_second = sweep<PrintedQuadraticPolynomial>(&printed_quadratic_root);
  CHECK(printed_second.most < 2.01e-3);
  CHECK(printed_second.most > 1.99e-3);
  for (const PolynomialFigures& f : {first, second, third, printed_first}) {
    CHECK(f.most_rounding < kRounding);
    CHECK(f.most_halved < 5 * kRounding);
  }
  CHECK(printed_second.most_rounding < kRounding);
  CHECK(printed_second.most_halved < 6 * kRounding);  // its three coefficients are rounded
}

TEST_CASE("dichotomy keeps equal normals exactly") {
  CHECK(LinearPolynomial::above_half(0) == 0);
  CHECK(QuadraticPolynomial::above_half(0) == 0);
  CHECK(CubicPolynomial::above_half(0) == 0);
  CHECK(halved_chord(0, 0) == 0);
  for (const std::int32_t raw : {0, 2, -2, 1 << 30, -(1 << 30), 123456788}) {
    CHECK(arc_middle(Cosine::from_raw(raw), Cosine::from_raw(raw), 0).raw() == raw);
  }
}

TEST_CASE("dichotomy: its integers against its model, each polynomial and each length of a segment") {
  constexpr Bounds kNear{1.5e-4, 3e-5};
  check<&linear_root>("dichotomy-linear", angles(0, 25, 71), kNear);
  check<&quadratic_root>("dichotomy-quadratic", angles(0, 25, 72), kNear);
  check<&cubic_root>("dichotomy-cubic", angles(0, 25, 73), kNear);
  check<&quadratic_root, 1>("dichotomy-quadratic-2", angles(0, 25, 74), kNear);
  check<&quadratic_root, 2>("dichotomy-quadratic-4", angles(0, 25, 75), kNear);
  // A row that ends within 2^-16 of a pixel's centre may take 16 pixels for the 8 of the model.
  check<&quadratic_root, 4>("dichotomy-quadratic-16", angles(0, 25, 76), {5e-4, 3e-5});
}

TEST_CASE("dichotomy as S3 prints it: its polynomials, and last segments of full length") {
  constexpr Bounds kNear{1.5e-4, 3e-5};
  check<&exact_root, 3, true>("dichotomy-root", angles(0, 25, 81), kNear);
  check<&printed_linear_root, 3, true>("dichotomy-printed-linear", angles(0, 25, 79), kNear);
  check<&printed_quadratic_root, 3, true>("dichotomy-printed-quadratic", angles(0, 25, 80), kNear);
}

TEST_CASE("dichotomy: wide normals, of which some segments are Phong's at every pixel") {
  // Whether a segment is wider than 45 degrees is decided in 14 bits; the two ways differ by up to 5e-3
  // there.
  check<&quadratic_root>("dichotomy-quadratic", angles(60, 150, 77), {6e-3, 1e-4, 0.1});
  check<&cubic_root, 4>("dichotomy-cubic-16", angles(60, 150, 78), {3e-2, 1e-4, 0.1});
  check<&printed_linear_root, 3, true>("dichotomy-printed-linear", angles(60, 150, 79), {1e-2, 2e-4, 0.1});
}

TEST_CASE("cutting a row changes no pixel of dichotomy") {
  using Lit = Illumination<1, Highlight::kBlinn>;
  using Method = DichotomyQuadratic<Lit>;
  constexpr std::int32_t kSize = 96;
  constexpr Coefficient kHalf = Coefficient::of(0.5);
  const Material material{{kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, 20};
  Random random(5);
  for (int i = 0; i < 60; ++i) {
    const Vec3 middle = random_unit(random);
    const std::array<DirectionalLight, 1> lights{DirectionalLight{to_direction(tilted(random, middle, 0.4))}};
    Lit lit;
    REQUIRE(ok(Lit::make(material, lights, to_direction(tilted(random, middle, 0.4)), lit)));
    std::array<RasterVertex<Method>, 3> v;
    for (auto& vertex : v) {
      const auto place = [&random] { return static_cast<std::int16_t>(random.real(-760, 760)); };
      const Direction normal = arcspan::test::detail::packed(tilted(random, middle, 0.5));
      vertex = {{place(), place(), 0}, Method::shade_vertex(lit, normal)};
    }
    std::vector<Rgb888::Word> whole(hal::Framebuffer<Rgb888>::words(kSize, kSize));
    std::vector<Rgb888::Word> pieced(whole.size());
    hal::Framebuffer<Rgb888> frame(whole, kSize, kSize);
    hal::Framebuffer<Rgb888> pieces(pieced, kSize, kSize);
    RasterStage<Method, hal::Framebuffer<Rgb888>> stage(frame, kSize, kSize, lit);
    RasterStage<Method, hal::Framebuffer<Rgb888>> cut(pieces, kSize, kSize, lit);
    stage.draw(v[0], v[1], v[2]);
    for (std::int32_t x = 0; x < kSize; x += 13) {
      cut.clip_to({x, 0, std::min(x + 13, kSize), kSize});
      cut.draw(v[0], v[1], v[2]);
    }
    CHECK(whole == pieced);
  }
}
