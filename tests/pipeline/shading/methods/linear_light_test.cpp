// SPDX-License-Identifier: MIT
// Adaptive's light that is linear on the screen (decision 6): how far it is from N·L, at the widest triangles
// that may have it.
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/adaptive/adaptive.hpp>

#include <catch2/catch.hpp>
#include <tests/support/method_accuracy.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Lit = Illumination<1, Highlight::kPhong>;

/// Writes down the N·L of every pixel that has no highlight.
struct Recorder : Lit {
  std::vector<Cosine>* recorded = nullptr;

  Recorder() = default;
  Recorder(const Lit& lit, std::vector<Cosine>& to) : Lit(lit), recorded(&to) {}
  [[nodiscard]] PackedRgb diffuse_colour(Cosine light) const {
    recorded->push_back(light);
    return Lit::diffuse_colour(light);
  }
};
using Method = Adaptive<Recorder>;

constexpr double kDiffuse = 0.9;
constexpr double kSpecular = 0.5;
constexpr std::int32_t kPicture = 512;

/// A light on white, with the highlight's exponent n.
Lit light_on_white(const Vec3& towards, const Vec3& to_eye, std::int32_t n) {
  Material material;
  material.diffuse.r = material.diffuse.g = material.diffuse.b = Coefficient::of(kDiffuse);
  material.specular.r = material.specular.g = material.specular.b = Coefficient::of(kSpecular);
  material.shininess = n;
  Lit lit;
  REQUIRE(ok(Lit::make(material, {DirectionalLight{to_direction(towards)}}, to_direction(to_eye), lit)));
  return lit;
}

/// What drawing one triangle showed, in 8-bit steps.
struct Figures {
  bool linear = false;
  double light = 0;      ///< the largest error of the light
  double highlight = 0;  ///< the most of a highlight that was left out
};

class LinearTriangle {
 public:
  LinearTriangle(Random& random, double degrees)
      : triangle_(arcspan::test::detail::random_triangle(random, radians(degrees), random.real(8, 60))) {
    const Vec3 middle = triangle_.corner[0].normal;
    towards_ = tilted(random, middle, random.real(0, 1.2));
    to_eye_ = tilted(random, middle, random.real(0, 1.5));
    n_ = static_cast<std::int32_t>(std::lround(random.decades(1, 200)));
  }

  [[nodiscard]] Figures drawn(std::int32_t tolerance) {
    std::vector<Cosine> lights;
    AdaptiveIllumination<Recorder> lighting(Recorder(light_on_white(towards_, to_eye_, n_), lights));
    REQUIRE(ok(lighting.set_tolerance(tolerance)));
    const std::array<RasterVertex<Method>, 3> v{vertex(lighting, 0), vertex(lighting, 1),
                                                vertex(lighting, 2)};
    Figures figures;
    TriangleCommand<Method> command;
    if (!prepare_triangle<Method>(lighting, v[0], v[1], v[2], {}, {-kPicture / 2, kPicture / 2}, command))
      return {};
    figures.linear = command.shade.linear_light;
    if (!figures.linear) return {};
    RunList runs({0, 0, kPicture, kPicture});
    lights.clear();  // of tables that the set-up made
    RasterStage<Method, RunList>(runs, kPicture, kPicture, lighting).draw(v[0], v[1], v[2]);
    compare(runs, lights, figures);
    return figures;
  }

 private:
  template <class Lighting>
  [[nodiscard]] RasterVertex<Method> vertex(const Lighting& lighting, std::size_t i) {
    auto& corner = triangle_.corner[i];
    const Direction normal = arcspan::test::detail::packed(corner.normal);
    corner.normal = normalised(to_vec3(normal));
    return {{static_cast<std::int16_t>(corner.point.x), static_cast<std::int16_t>(corner.point.y), 0},
            Method::shade_vertex(lighting, normal)};
  }

  void compare(const RunList& runs, const std::vector<Cosine>& lights, Figures& figures) const {
    const UnitLinearModel model(triangle_);
    std::size_t next = 0;
    for (const Span& run : runs.runs) {
      for (std::int32_t x = run.x; x < run.x + run.count; ++x) {
        REQUIRE(next < lights.size());
        const Vec3 normal = model.at(x - kPicture / 2, run.y - kPicture / 2);
        const double wanted = dot(normal, towards_);
        const double c = std::max(0.0, 2 * wanted * dot(normal, to_eye_) - dot(towards_, to_eye_));
        const double got = std::clamp(to_double(lights[next++]), 0.0, 1.0);
        figures.light = std::max(figures.light, 255 * kDiffuse * std::abs(got - std::max(wanted, 0.0)));
        if (wanted > 0) figures.highlight = std::max(figures.highlight, 255 * kSpecular * std::pow(c, n_));
      }
    }
    CHECK(next == lights.size());
  }

  ShadedTriangle triangle_;
  Vec3 towards_;
  Vec3 to_eye_;
  std::int32_t n_ = 1;
};

}  // namespace

TEST_CASE("linear light and the highlight left out are together within the tolerance") {
  // ChannelLevels have 15 bits, a step of the light has 143 of them.
  constexpr double kRounding = 0.02;
  Random random(31);
  int linear = 0;
  double brightest = 0;
  double worst_light = 0;
  double worst_sum = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    LinearTriangle triangle(random, random.real(6, 16));
    const Figures figures = triangle.drawn(1);
    if (!figures.linear) continue;
    ++linear;
    worst_light = std::max(worst_light, figures.light);
    worst_sum = std::max(worst_sum, figures.light + figures.highlight);
    brightest = std::max(brightest, figures.highlight);
  }
  CAPTURE(linear, worst_light, worst_sum, brightest);
  CHECK(linear > share_of(5000));
  CHECK(worst_sum <= 1 + kRounding);
  // The limits are used: where a highlight is near, and where none is.
  CHECK(brightest > 0.2);
  CHECK(worst_light > 0.6);
  CHECK(worst_light <= 0.875 + kRounding);
}

TEST_CASE("without a tolerance only unlit rows are linear") {
  Random random(32);
  for (int i = 0; i < 300; ++i) {
    LinearTriangle triangle(random, random.real(6, 16));
    CHECK(triangle.drawn(0).light == 0);
  }
}

TEST_CASE("light has half of the tolerance near a highlight, and seven eighths far from any") {
  const Lit lit = light_on_white({0, 0, 1}, {0, 0, 1}, 16);
  const AdaptiveIllumination<Lit> lighting(lit);
  const double near_highlight = lighting.linear_limit(lighting.half_tolerance_reach());
  CHECK(near_highlight * 0x1p-28 == Approx(4 * 0.5 / (255 * kDiffuse)).epsilon(0.001));
  CHECK(lighting.linear_limit(INT32_MAX) / near_highlight == Approx(7.0 / 4).epsilon(0.001));
}
