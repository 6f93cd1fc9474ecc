// SPDX-License-Identifier: MIT
// Pixels against the colour of Phong's normal in double precision, by one light and by two. The highlights of
// several lights may coincide, where their errors add up. Quadratic surfaces are narrower for them, so that
// Arc keeps the bound that it has for one light.
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/test_share.hpp>
#include <tests/support/triangle_picture.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kSize = 64;
constexpr double kDiffuse = 0.2;
constexpr double kSpecular = 0.4;

/// Where lights are: their highlights lie within this angle of the triangle's middle. 90: anywhere, so that
/// terminators and the ends of highlights run through triangles, and some lights do not reach them.
enum class Spread { k18Degrees = 18, k45Degrees = 45, k90Degrees = 90 };

/// A grey material and lights of full strength.
template <std::size_t Count>
struct Lights {
  Vec3 to_eye;
  std::array<Vec3, Count> to_light;

  Lights(Random& random, Vec3 middle, Spread spread)
      : to_eye(tilted(random, middle, radians(random.real(0, 50)))) {
    for (Vec3& light : to_light) {
      const Vec3 half = tilted(random, middle, radians(random.real(0, static_cast<int>(spread))));
      light = normalised(2 * dot(half, to_eye) * half - to_eye);
    }
  }

  template <class Lit>
  [[nodiscard]] Lit illumination(std::int32_t shininess) const {
    const auto grey = [](Coefficient c) { return ChannelCoefficients{c, c, c}; };
    const Material material{{}, grey(Coefficient::of(kDiffuse)), grey(Coefficient::of(kSpecular)), shininess};
    std::array<DirectionalLight, Count> lights;
    for (std::size_t i = 0; i < Count; ++i) lights[i].towards = to_direction(to_light[i]);
    Lit lit;
    REQUIRE(ok(Lit::make(material, lights, to_direction(to_eye), lit)));
    return lit;
  }

  /// The level at a unit normal in 8-bit steps; negative near a terminator, where a highlight may end.
  [[nodiscard]] double level(Highlight model, Vec3 normal, std::int32_t shininess) const {
    double sum = 0;
    for (const Vec3& light : to_light) {
      const double lit = dot(normal, light);
      if (std::abs(lit) < 1.0 / 255) return -1;
      if (lit < 0) continue;
      const double cosine = model == Highlight::kPhong ? 2 * lit * dot(normal, to_eye) - dot(light, to_eye)
                                                       : dot(normal, normalised(light + to_eye));
      sum += kDiffuse * lit + kSpecular * std::pow(std::max(0.0, cosine), shininess);
    }
    return std::min(255 * sum, 255.0);
  }
};

/// Returns the largest error of a pixel, in 8-bit steps; normals are `from` to `to` degrees apart.
template <Highlight Model, std::size_t Count = 2>
double worst_error(std::int32_t shininess, Spread spread, double from, double to) {
  using Lit = Illumination<Count, Model>;
  Random random(7);
  double worst = 0;
  for (int i = 0; i < share_of(3000); ++i) {
    const ScreenTriangle triangle = random_screen_triangle(random, kSize, random.real(from, to));
    ShadedTriangle shaded;
    Vec3 middle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 normal = normalised(to_vec3(triangle.normals[k]));
      shaded.corner[k] = {{triangle.points[k].x, triangle.points[k].y}, normal};
      middle = middle + normal;
    }
    if (test::detail::thickness(shaded) < 1) continue;
    const Lights<Count> lights(random, normalised(middle), spread);
    const TrianglePicture picture =
        picture_of<Arc<Lit>>(triangle, lights.template illumination<Lit>(shininess), kSize);
    const UnitLinearModel model(shaded);
    for (std::int32_t y = 0; y < kSize; ++y) {
      for (std::int32_t x = 0; x < kSize; ++x) {
        const Rgb8 pixel = picture.frame.pixel(x, y);
        if (pixel == Rgb8{}) continue;
        const double level = lights.level(Model, model.at(x - kSize / 2, y - kSize / 2), shininess);
        if (level >= 0) worst = std::max(worst, std::abs(pixel.g - level));
      }
    }
  }
  return worst;
}

}  // namespace

// Half a step is of rounding, because the level is not rounded.
TEST_CASE("arc is within three steps where the highlights of two lights coincide, five with n = 64") {
  const std::int32_t shininess = GENERATE(4, 16, 64);
  CAPTURE(shininess);
  const double most = shininess == 64 ? 5.5 : 3.5;
  CHECK(worst_error<Highlight::kPhong>(shininess, Spread::k18Degrees, 5, 30) <= most);
  CHECK(worst_error<Highlight::kBlinn>(shininess, Spread::k18Degrees, 5, 30) <= most);
}

TEST_CASE("arc by two lights is as accurate where one of them or one highlight ends") {
  const std::int32_t shininess = GENERATE(4, 16, 64);
  CAPTURE(shininess);
  const bool is_sharp = shininess == 64;
  CHECK(worst_error<Highlight::kPhong>(shininess, Spread::k90Degrees, 5, 30) <= (is_sharp ? 4.5 : 3));
  CHECK(worst_error<Highlight::kBlinn>(shininess, Spread::k90Degrees, 5, 30) <= 3);
  CHECK(worst_error<Highlight::kPhong>(shininess, Spread::k90Degrees, 30, 45) <= (is_sharp ? 4 : 3.5));
  CHECK(worst_error<Highlight::kBlinn>(shininess, Spread::k90Degrees, 30, 45) <= 3.5);
}

// Small highlights lose more along the rows of small triangles, which are up to 32 pixels long.
TEST_CASE("by one light, highlights by N·H are within two and a half steps up to n = 64") {
  const auto [shininess, most] =
      GENERATE(table<std::int32_t, double>({{4, 3.0}, {16, 3.0}, {64, 3.0}, {128, 4.5}, {256, 7.0}}));
  CAPTURE(shininess);
  for (const Spread spread : {Spread::k18Degrees, Spread::k45Degrees}) {
    CHECK(worst_error<Highlight::kBlinn, 1>(shininess, spread, 9, 30) <= most);
  }
}
