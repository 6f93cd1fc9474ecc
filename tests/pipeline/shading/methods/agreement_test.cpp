// SPDX-License-Identifier: MIT
// All methods side by side: where they must give the same, and in which order they are wrong where not.
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/shading/arc_vector.hpp>
#include <arcspan/shading/duff.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/kuijk_blake.hpp>
#include <arcspan/shading/lyon.hpp>
#include <arcspan/shading/phong.hpp>
#include <arcspan/shading/reflection_map.hpp>
#include <arcspan/shading/slerp.hpp>

#include <catch2/catch.hpp>
#include <tests/support/illumination_oracle.hpp>
#include <tests/support/method_accuracy.hpp>

#include <map>
#include <string>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Lit = Illumination<1, Highlight::kBlinn>;
constexpr std::int32_t kSize = 256;

struct Picture {
  std::vector<Rgb888::Unit> memory = std::vector<Rgb888::Unit>(hal::Framebuffer<Rgb888>::units(kSize, kSize));
  hal::Framebuffer<Rgb888> frame{memory, kSize, kSize};
};

struct Scene {
  std::array<RasterPosition, 3> points;
  std::array<Direction, 3> normals;
  Direction face;
  Lit lit;
};

template <template <class> class Method>
Picture draw(const Scene& scene) {
  using M = Method<Lit>;
  Picture picture;
  const typename M::Object object(scene.lit);
  RasterStage<M, hal::Framebuffer<Rgb888>> stage(picture.frame, kSize, kSize, object);
  const auto vertex = [&](std::size_t i) {
    return RasterVertex<M>{scene.points[i], M::shade_vertex(object, scene.normals[i])};
  };
  stage.draw(vertex(0), vertex(1), vertex(2), M::shade_face(object, scene.face));
  return picture;
}

/// Calls f(name, picture) for every method.
template <class F>
void for_all(const Scene& scene, F&& f) {
  f("flat", draw<Flat>(scene));
  f("gouraud", draw<Gouraud>(scene));
  f("phong", draw<Phong>(scene));
  f("slerp", draw<arcspan::Slerp>(scene));
  f("kuijk-blake", draw<KuijkBlake>(scene));
  f("lyon", draw<Lyon>(scene));
  f("duff", draw<Duff>(scene));
  f("reflection-map", draw<ReflectionMap>(scene));
  f("arc-vector", draw<ArcVector>(scene));
  f("arc", draw<Arc>(scene));
}

Lit white_light(Vec3 towards, Vec3 eye, std::int32_t shininess) {
  const auto grey = [](double v) {
    const Coefficient c = Coefficient::from_raw(static_cast<std::int32_t>(std::lround(v * 32768)));
    return ChannelCoefficients{c, c, c};
  };
  Material material{grey(0.1), grey(0.5), grey(0.4), shininess};
  const std::array<DirectionalLight, 1> lights{DirectionalLight{to_direction(towards)}};
  Lit lit;
  REQUIRE(ok(Lit::make(material, lights, to_direction(eye), lit)));
  return lit;
}

int level(Picture& picture, std::int32_t x, std::int32_t y) { return picture.frame.pixel(x, y).g; }

int difference(Picture& a, Picture& b) {
  int most = 0;
  for (std::int32_t y = 0; y < kSize; ++y) {
    for (std::int32_t x = 0; x < kSize; ++x) most = std::max(most, std::abs(level(a, x, y) - level(b, x, y)));
  }
  return most;
}

}  // namespace

TEST_CASE("all methods agree on a flat surface") {
  Random random(1);
  std::map<std::string, int> worst;
  for (int i = 0; i < 40; ++i) {
    const Vec3 normal = random_unit(random);
    const Direction n = arcspan::test::detail::packed(normal);
    Scene scene{{{{-1500, -1400, 0}, {1500, -900, 0}, {-300, 1700, 0}}}, {n, n, n}, n, {}};
    const Vec3 light = tilted(random, normal, random.real(0.3, 0.8));
    scene.lit = white_light(light, tilted(random, normal, 0.4), 8);
    Picture flat = draw<Flat>(scene);
    for_all(scene, [&](const char* name, Picture picture) {
      worst[name] = std::max(worst[name], difference(picture, flat));
    });
  }
  for (const auto& [name, steps] : worst) {
    INFO(name << " differs by " << steps);
    // The table's cells are up to 3.9 degrees from centre to corner, over which 127 cos falls by up to 6.2 at
    // 0.8 rad and 102 cos^8 by up to 12.3; all others have the same scalars to their rounding.
    CHECK(steps <= (name == "reflection-map" ? 18 : 1));
  }
}

TEST_CASE("all methods that interpolate agree with the illumination at the vertices") {
  Random random(2);
  std::map<std::string, int> worst;
  for (int i = 0; i < 100; ++i) {
    const Vec3 middle = random_unit(random);
    Scene scene{{{{-1500, -1400, 0}, {1500, -900, 0}, {-300, 1700, 0}}}, {}, {}, {}};
    for (Direction& n : scene.normals) n = arcspan::test::detail::packed(tilted(random, middle, 0.3));
    const Vec3 light = tilted(random, middle, 0.5);
    scene.lit = white_light(light, tilted(random, middle, 0.4), 8);
    for_all(scene, [&](const std::string& name, Picture picture) {
      if (name == "flat") return;
      for (std::size_t k = 0; k < 3; ++k) {
        // The nearest pixel that lies inside, a pixel or two from the vertex: the rest is the slope.
        const RasterPosition& p = scene.points[k];
        const double to_centre = std::hypot(p.x + 100, p.y + 200);
        const auto x =
            static_cast<std::int32_t>(std::lround(p.x / 16.0 - 3 * (p.x + 100) / to_centre)) + kSize / 2;
        const auto y =
            static_cast<std::int32_t>(std::lround(p.y / 16.0 - 3 * (p.y + 200) / to_centre)) + kSize / 2;
        const int truth = scene.lit.colour(scene.lit.scalars(scene.normals[k])).rgb8().g;
        worst[name] = std::max(worst[name], std::abs(level(picture, x, y) - truth));
      }
    });
  }
  for (const auto& [name, steps] : worst) {
    INFO(name << " differs by " << steps);
    CHECK(steps <= (name == "reflection-map" ? 16 : 4));  // three pixels of slope are 3 steps
  }
}

TEST_CASE("on strongly curved triangles the methods are wrong in the order of the mathematics") {
  Random random(3);
  std::map<std::string, ErrorFigure> errors;
  for (int i = 0; i < 60; ++i) {
    const Vec3 middle = random_unit(random);
    Scene scene{{{{-1500, -1400, 0}, {1500, -900, 0}, {-300, 1700, 0}}}, {}, {}, {}};
    ShadedTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      scene.normals[k] = arcspan::test::detail::packed(tilted(random, middle, 0.5));
      triangle.corner[k] = {{scene.points[k].x, scene.points[k].y}, normalised(to_vec3(scene.normals[k]))};
    }
    scene.face = to_direction(
        normalised(triangle.corner[0].normal + triangle.corner[1].normal + triangle.corner[2].normal));
    const Vec3 eye = tilted(random, middle, 0.3);
    const Vec3 light = tilted(random, middle, 0.4);
    scene.lit = white_light(light, eye, 32);
    IlluminationOracle oracle{{0.1, 0.1, 0.1}, {0.5, 0.5, 0.5}, {0.4, 0.4, 0.4}, 32, 1};
    const SlerpModel truth(triangle);
    Picture covered = draw<Flat>(scene);
    for_all(scene, [&](const char* name, Picture picture) {
      for (std::int32_t y = 0; y < kSize; y += 3) {
        for (std::int32_t x = 0; x < kSize; x += 3) {
          if (level(covered, x, y) == 0) continue;
          const Vec3 n = truth.at(x - kSize / 2, y - kSize / 2);
          const double n_l = dot(n, light);
          errors[name].add(level(picture, x, y) -
                           oracle.levels(n_l, dot(n, normalised(light + eye)), n_l > 0)[1]);
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
  CHECK(rms("gouraud") > 5 * rms("reflection-map"));
  CHECK(rms("reflection-map") > 2 * rms("phong"));
  CHECK(rms("lyon") > 1.5 * rms("phong"));
  CHECK(rms("phong") > 3 * rms("slerp"));
  CHECK(rms("duff") == Approx(rms("phong")).epsilon(0.02));
  for (const char* name : {"slerp", "kuijk-blake", "arc-vector", "arc"}) CHECK(rms(name) < 0.4);
}
