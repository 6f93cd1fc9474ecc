// SPDX-License-Identifier: MIT
// The worked example of S1: planes, vertices and weights as printed there, drawn by the integer pipeline.
//
//                                   exact       printed
//   flat, polygon 3                 3.859864    3.95 in the text, 3.93 in the summary
//   Gouraud at P                    4.470548    4.54
//   Phong at P, normalised          4.488482    4.65 (without normalising 4.469560)
//   spherical-angular at P          4.488443    (S1 has no such method)
//
// S1 rounds every step to two digits; that is the whole of the printed differences.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/literature/arc_vector.hpp>
#include <arcspan/literature/duff.hpp>
#include <arcspan/literature/kuijk_blake.hpp>
#include <arcspan/literature/lyon.hpp>
#include <arcspan/literature/phong.hpp>
#include <arcspan/literature/recurrence_four.hpp>
#include <arcspan/literature/slerp.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/vec3.hpp>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr double kExactFlat = 3.859864;
constexpr double kExactGouraud = 4.470548;
constexpr double kExactPhong = 4.488482;
constexpr double kExactArc = 4.488443;
constexpr double kTolerance = 0.002;
constexpr double kTwoTenths = 0.2 / 255 * 16;  // of a step of 255, where 16 is full light (docs/accuracy.md)

// The second light is dark. The strength of the first changes the entry of the ramp in which its N·L lies.
using Lit = Illumination<2, Highlight::kPhong>;

// The planes' normals; a vertex has the sum of those around it.
const Vec3 kPlane1{0, 0, 2};
const Vec3 kPlane2{-1, 1.732, 7.5};
const Vec3 kPlane3{-2.25, 3.897, 10};
const Vec3 kPlane4{0, 0, 5.5};
// S1 prints n_A = -3.25i + 5.63j + 17.5k and so on: these are the sums.
const Vec3 kA = normalised(kPlane2 + kPlane3);
const Vec3 kB = normalised(kPlane1 + kPlane2 + kPlane3 + kPlane4);
const Vec3 kC = normalised(kPlane3 + kPlane4);

const Vec3 kTowardsLight{0, 0, 1};
const Vec3 kTowardsEye = normalised(Vec3{1, 1, 1});

// I = Ia ka + Il [kd N·L + ks (R·V)^2] = 0.15 + 1.5 N·L + 8 (R·V)^2, a sixteenth of which is within 0...1
// even for coefficients that make up for a strength of a half.
constexpr double kScale = 16;

/// Small changes of the illumination, by which roundings average out.
struct Variation {
  std::int32_t ambient;   ///< more ambient light, in 2^-15
  double strength;        ///< of the light, 0.6...1; the coefficients are larger by as much
  std::int32_t specular;  ///< more of the highlight, in 2^-15
};

/// The printed illumination, a sixteenth of it.
Lit printed_illumination(const Variation& by) {
  const auto grey = [](double value, std::int32_t more) {
    const Coefficient c = Coefficient::from_raw(static_cast<std::int32_t>(std::lround(value * 32768)) + more);
    return ChannelCoefficients{c, c, c};
  };
  Material material;
  material.ambient = grey(0.15 / kScale, by.ambient);
  material.diffuse = grey(1.5 / kScale / by.strength, 0);
  material.specular = grey(8 / kScale / by.strength, by.specular);
  material.shininess = 2;
  std::array<DirectionalLight, 2> lights;
  lights[0].towards = to_direction(kTowardsLight);
  lights[0].strength = Coefficient::from_raw(static_cast<std::int32_t>(std::lround(by.strength * 32768)));
  lights[1].towards = to_direction(kTowardsLight);
  lights[1].strength = Coefficient{};
  Lit lit;
  REQUIRE(ok(Lit::make(material, lights, to_direction(kTowardsEye), lit)));
  return lit;
}

/// The 8-bit level at P of the triangle A, B, C. On the screen B is at the top and the row of P cuts AB and
/// BC as S1 has it: Q = 0.4 A + 0.6 B, R = 0.7 B + 0.3 C, P half-way between; all three weights are exact.
template <class Method>
int level_at_p(const Lit& lit) {
  constexpr std::int32_t kSize = 96;
  std::vector<Rgb888::Word> memory(hal::Framebuffer<Rgb888>::words(kSize, kSize));
  hal::Framebuffer<Rgb888> frame(memory, kSize, kSize);
  RasterStage<Method, hal::Framebuffer<Rgb888>> stage(frame, kSize, kSize, lit);
  const auto vertex = [&lit](double x, double y, Vec3 normal) {
    return RasterVertex<Method>{{static_cast<std::int16_t>(16 * x), static_cast<std::int16_t>(16 * y), 0},
                                Method::shade_vertex(lit, to_direction(normal))};
  };
  // Rows 0, 30, 40 below B: 0.4 * 30 = 0.3 * 40 = 12. Columns: Q at -8, R at 12, P at 2.
  REQUIRE(stage.draw(vertex(-19.5, 30.5, kA), vertex(0.5, 0.5, kB), vertex(40.5, 40.5, kC),
                     Method::shade_face(lit, to_direction(normalised(kPlane3)))));
  return frame.pixel(kSize / 2 + 2, kSize / 2 + 12).g;
}

/// The intensity at P finer than a pixel's 8 bits, an entry of the ramp and the quarters of a step in which
/// highlights are added: the mean over pictures that differ by fractions of each. A step is 2^15 / 255 =
/// 128.5 units of the ambient light, so that 1028 of them are eight steps exactly. The other two vary in
/// other orders.
template <class Method>
double intensity_at_p() {
  constexpr int kPictures = 1028;
  double sum = 0;
  for (int i = 0; i < kPictures; ++i) {
    const Variation by{i, 0.6 + 0.4 * (i * 101 % kPictures) / kPictures,
                       (i * 619 % kPictures - kPictures / 2) * 2};
    sum += level_at_p<Method>(printed_illumination(by)) - by.ambient * 255.0 / 32768;
  }
  return sum / kPictures / 255 * kScale;
}

}  // namespace

TEST_CASE("S1, the worked example: flat, Gouraud, Phong and spherical-angular shading at P") {
  CHECK(intensity_at_p<Flat<Lit>>() == Approx(kExactFlat).margin(kTolerance));
  CHECK(intensity_at_p<Gouraud<Lit>>() == Approx(kExactGouraud).margin(kTolerance));
  CHECK(intensity_at_p<Phong<Lit>>() == Approx(kExactPhong).margin(kTolerance));
  CHECK(intensity_at_p<PhongReciprocal<Lit>>() == Approx(kExactPhong).margin(kTolerance));
  CHECK(intensity_at_p<Recurrence<Lit>>() == Approx(kExactArc).margin(kTolerance));
  CHECK(intensity_at_p<Arc<Lit>>() == Approx(kExactPhong).margin(kTwoTenths));
}

TEST_CASE("S1, the worked example by the other methods of normals") {
  CHECK(intensity_at_p<Duff<Lit>>() == Approx(kExactPhong).margin(kTolerance));
  CHECK(intensity_at_p<Lyon<Lit>>() == Approx(kExactPhong).margin(kTolerance));
  CHECK(intensity_at_p<arcspan::Slerp<Lit>>() == Approx(kExactArc).margin(kTolerance));
  CHECK(intensity_at_p<KuijkBlake<Lit>>() == Approx(kExactArc).margin(kTolerance));
  CHECK(intensity_at_p<RecurrenceFour<Lit>>() == Approx(kExactArc).margin(kTolerance));
  CHECK(intensity_at_p<ArcVector<Lit>>() == Approx(kExactArc).margin(kTolerance));
}

TEST_CASE("S1, the exact values beside the printed ones, in double precision") {
  const auto intensity = [](Vec3 n) {
    const double light = dot(n, kTowardsLight);
    const double reflected = 2 * light * dot(n, kTowardsEye) - dot(kTowardsLight, kTowardsEye);
    return 0.15 + 1.5 * light + 8 * reflected * reflected;
  };
  CHECK(intensity(normalised(kPlane3)) == Approx(kExactFlat).margin(1e-6));
  CHECK(intensity(kA) == Approx(4.203998).margin(1e-6));  // printed 4.25
  CHECK(intensity(kB) == Approx(4.550902).margin(1e-6));  // printed 4.65
  CHECK(intensity(kC) == Approx(4.477745).margin(1e-6));  // printed 4.45
  const double q = 0.4 * intensity(kA) + 0.6 * intensity(kB);
  const double r = 0.7 * intensity(kB) + 0.3 * intensity(kC);
  CHECK((q + r) / 2 == Approx(kExactGouraud).margin(1e-6));
  const Vec3 linear = 0.5 * (0.4 * kA + 0.6 * kB) + 0.5 * (0.7 * kB + 0.3 * kC);
  CHECK(intensity(linear) == Approx(4.469560).margin(1e-6));  // as S1 does it: not normalised
  CHECK(intensity(normalised(linear)) == Approx(kExactPhong).margin(1e-6));
}
