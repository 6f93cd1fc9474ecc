// SPDX-License-Identifier: MIT
// All methods side by side: where they must give the same, and in which order they are wrong where not.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/literature/reflection_map.hpp>
#include <arcspan/literature/segment.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/illumination_oracle.hpp>
#include <tests/support/method_accuracy.hpp>
#include <tests/support/raster_stage.hpp>
#include <tests/support/test_share.hpp>

#include <map>
#include <string>
#include <tuple>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using BlinnLit = Illumination<1, Highlight::kBlinn>;
using PhongLit = Illumination<1, Highlight::kPhong>;
using Lits = std::tuple<BlinnLit, PhongLit>;
constexpr std::int32_t kSize = 256;

struct Picture {
  std::vector<Rgb888::Word> memory = std::vector<Rgb888::Word>(hal::Framebuffer<Rgb888>::words(kSize, kSize));
  hal::Framebuffer<Rgb888> frame{memory, kSize, kSize};
};

template <class Lit>
struct Scene {
  std::array<RasterPosition, 3> points{};
  std::array<Direction, 3> normals{};
  Direction face{};
  Lit lit{};
  std::array<Direction, 3> axes{};  ///< L, H and V of `lit`
};

template <template <class> class Method, class Lit>
Picture draw(const Scene<Lit>& scene) {
  using M = Method<Lit>;
  Picture picture;
  const typename M::Lighting lighting(scene.lit);
  RasterStage<M, hal::Framebuffer<Rgb888>> stage(picture.frame, kSize, kSize, lighting);
  const auto vertex = [&](std::size_t i) {
    return RasterVertex<M>{scene.points[i], M::shade_vertex(lighting, scene.normals[i])};
  };
  stage.draw(vertex(0), vertex(1), vertex(2), M::shade_face(lighting, scene.face));
  return picture;
}

/// By a method of the literature: of the colours that its probe makes of a pixel, the illumination's.
template <class Lit>
Picture draw(std::string_view method, const Scene<Lit>& scene) {
  std::vector<ProbeSample> samples;
  const Probe::Blinn no_blinn;
  const Probe::Phong no_phong;
  Probe probe;
  probe.axes = scene.axes;
  probe.samples = &samples;
  probe.matt = &no_blinn;
  if constexpr (Lit::kModel == Highlight::kBlinn) {
    probe.blinn = &scene.lit;
    probe.phong = &no_phong;
  } else {
    probe.blinn = &no_blinn;
    probe.phong = &scene.lit;
  }
  RunList runs({0, 0, kSize, kSize});
  probed_method(method)({scene.points, scene.normals}, probe, runs);
  Picture picture;
  std::size_t next = 0;
  for (const Span& run : runs.runs) {
    auto cursor = picture.frame.open(run);
    for (std::int32_t i = 0; i < run.count; ++i, cursor.next()) {
      const ProbeSample& sample = samples.at(next++);
      const Rgb8 colour = Lit::kModel == Highlight::kBlinn ? sample.blinn : sample.phong;
      cursor.write(Rgb888::encode(colour));
    }
  }
  CHECK(next == samples.size());
  return picture;
}

/// What a method interpolates, and so what it must agree with, and where.
enum class Kind {
  kColour,  ///< nothing, or the colour
  kChord,   ///< normals along chords, then of unit length: classic Phong
  kArc,     ///< normals along great circles
  kTable,   ///< normals along chords, looked up among 4096
};

/// Calls f(name, kind, picture) for every method.
template <class Lit, class F>
void for_all(const Scene<Lit>& scene, F&& f) {
  f("flat", Kind::kColour, draw<Flat>(scene));
  f("gouraud", Kind::kColour, draw<Gouraud>(scene));
  f("reflection-map", Kind::kTable, draw<ReflectionMap>(scene));
  f("arc", Kind::kChord, draw<Arc>(scene));
  f("segment", Kind::kArc, draw<Segment>(scene));
  for (const char* name : {"slerp", "kuijk-blake", "arc-vector", "recurrence", "recurrence-four"})
    f(name, Kind::kArc, draw(name, scene));
  for (const char* name : {"phong", "phong-reciprocal", "lyon", "duff", "dichotomy-linear",
                           "dichotomy-quadratic", "dichotomy-cubic"})
    f(name, Kind::kChord, draw(name, scene));
}

/// White light on grey, in the pipeline's numbers and in double precision.
template <class Lit>
struct White {
  Vec3 light;
  Vec3 eye;
  IlluminationOracle oracle;
  Lit lit;
  std::array<Direction, 3> axes{};  ///< L, H and V

  White(Vec3 towards, Vec3 to_eye, std::int32_t shininess) : light(towards), eye(to_eye) {
    const auto grey = [](double v) {
      const Coefficient c = Coefficient::from_raw(static_cast<std::int32_t>(std::lround(v * 32768)));
      return ChannelCoefficients{c, c, c};
    };
    const Material material{grey(0.1), grey(0.5), grey(0.4), shininess};
    const std::array<DirectionalLight, 1> lights{DirectionalLight{to_direction(towards)}};
    REQUIRE(ok(Lit::make(material, lights, to_direction(to_eye), lit)));
    axes = {lights[0].towards, half_way(lights[0].towards, to_direction(to_eye)), to_direction(to_eye)};
    oracle = to_oracle(material);
  }
  void light_up(Scene<Lit>& scene) const {
    scene.lit = lit;
    scene.axes = axes;
  }
  /// Of a unit normal, 0...255, not rounded.
  [[nodiscard]] double level(Vec3 n) const {
    const double n_l = dot(n, light);
    const double cosine = Lit::kModel == Highlight::kBlinn ? dot(n, normalised(light + eye))
                                                           : 2 * n_l * dot(n, eye) - dot(light, eye);
    return oracle.levels(n_l, cosine, n_l > 0)[1];
  }
};

int level(Picture& picture, std::int32_t x, std::int32_t y) { return picture.frame.pixel(x, y).g; }

int difference(Picture& a, Picture& b) {
  int most = 0;
  for (std::int32_t y = 0; y < kSize; ++y) {
    for (std::int32_t x = 0; x < kSize; ++x) most = std::max(most, std::abs(level(a, x, y) - level(b, x, y)));
  }
  return most;
}

/// The largest differences of every method, by name.
using Differences = std::map<std::string, double>;

void note(Differences& worst, const std::string& name, double difference) {
  worst[name] = std::max(worst[name], std::fabs(difference));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("all methods agree on a flat surface", "", Lits) {
  Random random(1);
  std::map<std::string, int> worst;
  for (int i = 0; i < share_of(40); ++i) {
    const Vec3 normal = random_unit(random);
    const Direction n = arcspan::test::detail::packed(normal);
    Scene<TestType> scene;
    scene.points = {{{-1500, -1400, 0}, {1500, -900, 0}, {-300, 1700, 0}}};
    scene.normals = {n, n, n};
    scene.face = n;
    const double apart = random.real(0.3, 0.8);
    // Braces, which are evaluated in their order.
    White<TestType>{tilted(random, normal, apart), tilted(random, normal, 0.4), 8}.light_up(scene);
    Picture flat = draw<Flat>(scene);
    for_all(scene, [&](const char* name, Kind, Picture picture) {
      worst[name] = std::max(worst[name], difference(picture, flat));
    });
  }
  for (const auto& [name, steps] : worst) {
    INFO(name << " differs by " << steps);
    // The table's cells are up to 3.9 degrees from centre to corner, and R turns twice as fast as N: that
    // is up to 24 steps where cos^8 is steepest. All others have the same scalars to their rounding.
    CHECK(steps <= (name == "reflection-map" ? 24 : 1));
  }
}

TEMPLATE_LIST_TEST_CASE("every method takes every shininess from 1 to 256", "", Lits) {
  Random random(6);
  // What a scalar is off by, beyond a step for the diffuse part and the rounding. R·V is twice a product of
  // two.
  Differences scalar;
  constexpr double kSteepness = 255 * 0.4 * (TestType::kModel == Highlight::kPhong ? 4 : 1);
  const int step = 256 / share_of(256);
  for (std::int32_t shininess = 1; shininess <= 256; shininess += step) {
    const Vec3 normal = random_unit(random);
    const Direction n = arcspan::test::detail::packed(normal);
    // Near the highlight: the power is between 1 and exp(-2), whatever its exponent.
    const double off = random.real(0, 1 / std::sqrt(static_cast<double>(shininess)));
    const White<TestType> white{tilted(random, normal, off), tilted(random, normal, off), shininess};
    Scene<TestType> scene;
    scene.points = {{{-150, -140, 0}, {150, -90, 0}, {-30, 170, 0}}};
    scene.normals = {n, n, n};
    scene.face = n;
    white.light_up(scene);
    const double truth = white.level(normalised(to_vec3(n)));
    for_all(scene, [&](const std::string& name, Kind kind, Picture picture) {
      if (kind == Kind::kTable) return;  // its cells are wider than sharp highlights
      const double steps = std::fabs(level(picture, kSize / 2, kSize / 2) - truth);
      note(scalar, name, std::max(0.0, steps - 1) / (kSteepness * shininess));
    });
  }
  CHECK(scalar.size() == 16);
  for (const auto& [name, error] : scalar) {
    INFO(name << " is off by " << error);
    CHECK(error < 1.7e-4);  // docs/accuracy.md: the largest is that of slerp
  }
}

namespace {

/// Normals within 0.3 radians of a random one, light and eye near it: no pixel is unlit, all are curved.
template <class Lit>
struct CurvedScene {
  Scene<Lit> scene;
  ShadedTriangle triangle;
  White<Lit> white;

  explicit CurvedScene(Random& random, std::array<RasterPosition, 3> points, double tilt = 0.3,
                       std::int32_t shininess = 8)
      : CurvedScene(random, random_unit(random), points, tilt, shininess) {}

 private:
  CurvedScene(Random& random, Vec3 middle, std::array<RasterPosition, 3> points, double tilt,
              std::int32_t shininess)
      : white{tilted(random, middle, 0.5), tilted(random, middle, 0.4), shininess} {
    scene.points = points;
    white.light_up(scene);
    Vec3 sum{};
    for (std::size_t k = 0; k < 3; ++k) {
      scene.normals[k] = arcspan::test::detail::packed(tilted(random, middle, tilt));
      triangle.corner[k] = {{points[k].x, points[k].y}, normalised(to_vec3(scene.normals[k]))};
      sum = sum + triangle.corner[k].normal;
    }
    scene.face = to_direction(normalised(sum));
  }
};

constexpr std::array<RasterPosition, 3> kSlanting{{{-1500, -1400, 0}, {1500, -900, 0}, {-300, 1700, 0}}};
/// A horizontal upper edge and a left one: the vertex between them and the middles of both are centres of
/// pixels that belong to the triangle.
constexpr std::array<RasterPosition, 3> kOnCentres{{{-1528, -1400, 0}, {1544, -1400, 0}, {-888, 1640, 0}}};

}  // namespace

TEMPLATE_LIST_TEST_CASE("all methods agree at the vertices and in the middles of the edges", "", Lits) {
  Random random(2);
  Differences at_vertex;
  Differences in_middle;
  const auto pixel = [](std::int32_t subpixel) { return (subpixel - 8) / 16 + kSize / 2; };
  for (int i = 0; i < share_of(200); ++i) {
    const CurvedScene<TestType> curved(random, kOnCentres);
    const auto& corner = curved.triangle.corner;
    for_all(curved.scene, [&](const std::string& name, Kind kind, Picture picture) {
      if (name == "flat") return;
      const auto compare = [&](Differences& worst, std::size_t k, Vec3 sum) {
        const auto x = static_cast<std::int32_t>((corner[0].point.x + corner[k].point.x) / 2);
        const auto y = static_cast<std::int32_t>((corner[0].point.y + corner[k].point.y) / 2);
        note(worst, name, level(picture, pixel(x), pixel(y)) - curved.white.level(normalised(sum)));
      };
      compare(at_vertex, 0, corner[0].normal);
      if (kind == Kind::kColour) return;
      for (const std::size_t k : {1u, 2u}) compare(in_middle, k, corner[0].normal + corner[k].normal);
    });
  }
  for (const Differences& worst : {at_vertex, in_middle}) {
    for (const auto& [name, steps] : worst) {
      INFO(name << " differs by " << steps << " from the unrounded truth");
      CHECK(steps < (name == "reflection-map" ? 24 : name == "lyon" ? 1.8 : 1.5));
    }
  }
  CHECK(at_vertex.size() == in_middle.size() + 1);  // Gouraud
}

TEMPLATE_LIST_TEST_CASE("methods that interpolate alike agree at both ends of every span", "", Lits) {
  Random random(4);
  Differences worst;
  for (int i = 0; i < share_of(40); ++i) {
    const CurvedScene<TestType> curved(random, kSlanting);
    const UnitLinearModel chords(curved.triangle);
    const SlerpModel arcs(curved.triangle);
    Picture covered = draw<Flat>(curved.scene);
    for_all(curved.scene, [&](const std::string& name, Kind kind, Picture picture) {
      if (kind != Kind::kChord && kind != Kind::kArc) return;
      for (std::int32_t y = 0; y < kSize; ++y) {
        const auto drawn = [&](std::int32_t x) { return level(covered, x, y) != 0; };
        for (std::int32_t x = 1; x + 1 < kSize; ++x) {
          if (!drawn(x) || (drawn(x - 1) && drawn(x + 1))) continue;
          const std::int64_t column = x - kSize / 2;
          const std::int64_t row = y - kSize / 2;
          const Vec3 normal = kind == Kind::kArc ? arcs.at(column, row) : chords.at(column, row);
          note(worst, name, level(picture, x, y) - curved.white.level(normal));
        }
      }
    });
  }
  CHECK(worst.size() == 14);
  for (const auto& [name, steps] : worst) {
    INFO(name << " differs by " << steps << " from the unrounded truth");
    CHECK(steps < (name == "lyon" ? 1.8 : 1.5));
  }
}

TEMPLATE_LIST_TEST_CASE("on strongly curved triangles the methods are wrong in the order of the mathematics",
                        "", Lits) {
  Random random(3);
  std::map<std::string, ErrorFigure> errors;
  for (int i = 0; i < 5 + share_of(55); ++i) {
    const CurvedScene<TestType> curved(random, kSlanting, 0.5, 32);
    const SlerpModel truth(curved.triangle);
    Picture covered = draw<Flat>(curved.scene);
    for_all(curved.scene, [&](const char* name, Kind, Picture picture) {
      for (std::int32_t y = 0; y < kSize; y += 3) {
        for (std::int32_t x = 0; x < kSize; x += 3) {
          if (level(covered, x, y) == 0) continue;
          const Vec3 n = truth.at(x - kSize / 2, y - kSize / 2);
          errors[name].add(level(picture, x, y) - curved.white.level(n));
        }
      }
    });
  }
  const auto rms = [&errors](const char* name) { return errors[name].rms(); };
  for (const auto& [name, error] : errors)
    UNSCOPED_INFO(name << " rms " << error.rms() << " max " << error.max);
  // Colours that miss the highlight, then cells and series, then lines instead of arcs; the methods of arcs
  // are the truth but for the rounding to 8 bits, 1 / sqrt(12) = 0.29, and the ramp of 256 colours.
  CHECK(rms("flat") > 5 * rms("reflection-map"));
  CHECK(rms("gouraud") > 4 * rms("reflection-map"));
  CHECK(rms("reflection-map") > 2 * rms("phong"));
  CHECK(rms("lyon") > 1.5 * rms("phong"));
  CHECK(rms("phong") > 3 * rms("slerp"));
  for (const char* name :
       {"arc", "phong-reciprocal", "duff", "dichotomy-linear", "dichotomy-quadratic", "dichotomy-cubic"}) {
    CHECK(rms(name) == Approx(rms("phong")).epsilon(0.02));
  }
  for (const char* name : {"slerp", "kuijk-blake", "arc-vector", "recurrence", "recurrence-four"}) {
    CHECK(rms(name) < 0.45);
  }
  CHECK(rms("segment") < 0.5);
  CHECK(errors.size() == 17);
}
