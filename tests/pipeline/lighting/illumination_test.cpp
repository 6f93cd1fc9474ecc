// SPDX-License-Identifier: MIT
// Colours of several coloured lights with both highlights, against double precision.
#include <arcspan/lighting/illumination.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>
#include <tests/support/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr IlluminationFeatures kAll{.coloured_lights = true, .fading_highlights = true};
template <std::size_t Lights, Highlight Model>
using Coloured = Illumination<Lights, Model, kAll>;

using Levels = std::array<double, 3>;

Coefficient random_coefficient(Random& random, double most = 1) {
  const double value = random.chance(0.1) ? (random.chance(0.5) ? 0 : most) : random.real(0, most);
  return Coefficient::from_raw(static_cast<std::int32_t>(std::lround(value * 32768)));
}
ChannelCoefficients random_channels(Random& random, double most = 1) {
  return {random_coefficient(random, most), random_coefficient(random, most),
          random_coefficient(random, most)};
}
double to_double(Coefficient c) { return c.raw() / 32768.0; }
Levels to_levels(const ChannelCoefficients& c) { return {to_double(c.r), to_double(c.g), to_double(c.b)}; }

/// A material, lights and an eye; the sum of the lights rarely exceeds what a channel holds.
template <std::size_t Lights>
struct Scene {
  Material material;
  std::array<DirectionalLight, Lights> lights;
  Direction to_eye;

  explicit Scene(Random& random) {
    const double fade = random.chance(0.3) ? 0 : random.real(1.0 / 64, 0.5);
    material = {random_channels(random, 0.2), random_channels(random), random_channels(random, 0.5),
                static_cast<std::int32_t>(random.decades(1, 64)),
                Coefficient::from_raw(static_cast<std::int32_t>(fade * 32768))};
    const Vec3 front = random_unit(random);
    to_eye = to_direction(front);
    for (DirectionalLight& light : lights) {
      light.towards = to_direction(tilted(random, front, random.real(0, 2)));
      light.strength = random_coefficient(random);
      light.colour = random_channels(random);
    }
  }

  [[nodiscard]] double fade(double normal_light) const {
    const double end = to_double(material.highlight_fade);
    return normal_light >= end ? 1 : normal_light / end;
  }

  /// S0 eq. 1 and 12 with I(lambda) for the scalars as they are, before rounding, clamped to 0...255.
  template <Highlight Model, class Scalars>
  [[nodiscard]] Levels levels(const Scalars& scalars) const {
    Levels sums{};
    const Levels diffuse = to_levels(material.diffuse);
    const Levels specular = to_levels(material.specular);
    for (std::size_t i = 0; i < Lights; ++i) {
      const double normal_light = arcspan::test::to_double(scalars[i]);
      if (normal_light <= 0) continue;
      const double light_eye = dot(to_vec3(lights[i].towards), to_vec3(to_eye));
      const double other =
          arcspan::test::to_double(scalars[Model == Highlight::kBlinn ? Lights + i : Lights]);
      const double cosine = Model == Highlight::kBlinn ? other : 2 * normal_light * other - light_eye;
      const double shine = fade(normal_light) * std::pow(std::max(cosine, 0.0), material.shininess);
      const Levels colour = to_levels(lights[i].colour);
      for (std::size_t c = 0; c < 3; ++c) {
        sums[c] +=
            to_double(lights[i].strength) * colour[c] * (diffuse[c] * normal_light + specular[c] * shine);
      }
    }
    const Levels ambient = to_levels(material.ambient);
    for (std::size_t c = 0; c < 3; ++c) sums[c] = std::clamp(255 * (ambient[c] + sums[c]), 0.0, 255.0);
    return sums;
  }
};

template <class Scalars>
bool near_terminator(const Scalars& scalars, std::size_t lights) {
  for (std::size_t i = 0; i < lights; ++i) {
    if (std::abs(scalars[i].raw()) < 1 << 17) return true;
  }
  return false;
}

Levels to_levels(Rgb8 c) { return {double(c.r), double(c.g), double(c.b)}; }
Levels to_levels(const DeepColour& c) { return {c.r / 256.0, c.g / 256.0, c.b / 256.0}; }
double difference(const Levels& a, const Levels& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

struct Worst {
  double rounded = 0;  ///< of colour()
  double deep = 0;     ///< of deep_colour()
};

/// The largest difference from double precision over random scenes and normals.
template <std::size_t Lights, Highlight Model>
Worst worst_error(std::uint64_t seed) {
  Random random(seed);
  Worst worst;
  for (int i = 0; i < share_of(1000); ++i) {
    const Scene<Lights> scene(random);
    Coloured<Lights, Model> illumination;
    REQUIRE(ok(Coloured<Lights, Model>::make(scene.material, scene.lights, scene.to_eye, illumination)));
    for (int k = 0; k < 40; ++k) {
      const Vec3 normal = tilted(random, to_vec3(scene.to_eye), random.real(0, 1.5));
      const auto scalars = illumination.scalars(to_direction(normal));
      if (near_terminator(scalars, Lights)) continue;  // rounding may put it on either side
      const Levels wanted = scene.template levels<Model>(scalars);
      worst.rounded =
          std::max(worst.rounded, difference(to_levels(illumination.colour(scalars).rgb8()), wanted));
      worst.deep = std::max(worst.deep, difference(to_levels(illumination.deep_colour(scalars)), wanted));
    }
  }
  return worst;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("coloured lights and fading highlights are those of double precision", "",
                       ((std::size_t Lights), Lights), 1, 2, 4) {
  const Worst blinn = worst_error<Lights, Highlight::kBlinn>(191);
  const Worst phong = worst_error<Lights, Highlight::kPhong>(192);
  INFO("Blinn " << blinn.rounded << " and " << blinn.deep << ", Phong " << phong.rounded << " and "
                << phong.deep);
  // Half a step is rounding; a single light's ramp has steps of up to 255/256. Over 50 times as many scenes
  // these figures were 1.13, 0.67 and 0.27.
  const double most = Lights == 1 ? 1.2 : 0.7;
  CHECK(std::max(blinn.rounded, phong.rounded) < most);
  CHECK(std::max(blinn.deep, phong.deep) < 0.3);
}

namespace {

using Channels = std::array<std::int32_t, 3>;

/// The channels as PackedRgb has them: quarters of an 8-bit step, half a step added.
Channels quarters(PackedRgb c) {
  const std::uint32_t of_channel[] = {c.lanes >> 11 & 1023u, c.lanes >> 22, c.lanes & 1023u};
  return {static_cast<std::int32_t>(of_channel[0]), static_cast<std::int32_t>(of_channel[1]),
          static_cast<std::int32_t>(of_channel[2])};
}
Channels channels(const DeepColour& c) { return {c.r, c.g, c.b}; }

/// Whether the light at a normal with these scalars may be in the first entry of the ramp.
template <class Lit, std::size_t Lights>
bool in_first_entry(const Lit& lit, const std::array<DirectionalLight, Lights>& lights,
                    const typename Lit::Scalars& scalars) {
  double light = 0;
  for (std::size_t i = 0; i < Lights; ++i) {
    light += to_double(lights[i].strength) * std::max(0.0, arcspan::test::to_double(scalars[i]));
  }
  return light * lit.most_diffuse() * static_cast<double>(lit.ramp().size()) <= 1.05 * lit.most_light();
}

/// Half of the light that an entry of the ramp stands for, by its effect on a channel in 256ths of an 8-bit
/// step, with what the rounding of the lights' shares moves its ends.
template <class Lit>
double half_entry(const Lit& lit, double share_of_most) {
  const double entry = lit.most_light() * 8.0 / static_cast<double>(lit.ramp().size());
  return entry * share_of_most * (0.5 + static_cast<double>(Lit::kLights) / 32);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("each channel is that of white lights as strong as the channel", "",
                       ((Highlight Model, std::size_t Lights), Model, Lights), (Highlight::kBlinn, 2),
                       (Highlight::kPhong, 4)) {
  using White = Illumination<Lights, Model>;
  Random random(193);
  for (int i = 0; i < share_of(300); ++i) {
    Scene<Lights> scene(random);
    scene.material.highlight_fade = {};
    if (i % 4 == 0) scene.material.diffuse = {};  // highlights alone
    Coloured<Lights, Model> coloured;
    REQUIRE(ok(Coloured<Lights, Model>::make(scene.material, scene.lights, scene.to_eye, coloured)));
    std::array<White, 3> white;
    std::array<std::array<DirectionalLight, Lights>, 3> white_lights;
    for (std::size_t c = 0; c < 3; ++c) {
      auto& lights = white_lights[c] = scene.lights;
      for (DirectionalLight& light : lights) {
        const std::array<Coefficient, 3> colour{light.colour.r, light.colour.g, light.colour.b};
        light.strength = Coefficient::from_raw(
            static_cast<std::int32_t>(std::lround(light.strength.raw() * to_double(colour[c]))));
        light.colour = DirectionalLight{}.colour;
      }
      REQUIRE(ok(White::make(scene.material, lights, scene.to_eye, white[c])));
    }
    const Levels diffuse = to_levels(scene.material.diffuse);
    const double most_diffuse = std::max({diffuse[0], diffuse[1], diffuse[2], 1e-9});
    for (int k = 0; k < 40; ++k) {
      const auto scalars = coloured.scalars(to_direction(random_unit(random)));
      const Channels colour = quarters(coloured.colour(scalars));
      const Channels deep = channels(coloured.deep_colour(scalars));
      for (std::size_t c = 0; c < 3; ++c) {
        REQUIRE(deep[c] == channels(white[c].deep_colour(scalars))[c]);
        // Coloured lights are summed and cut off to quarters of a step.
        if (deep[c] < 65280) REQUIRE(std::abs(64 * colour[c] + 32 - (deep[c] + 128)) <= 33);
        // The diffuse part of white lights is that of the middle of the ramp's entry, rounded to a quarter;
        // in the first entry it is 0. The highlight is cut off to a quarter.
        const double half = half_entry(white[c], diffuse[c] / most_diffuse);
        const std::int32_t level = std::min(64 * quarters(white[c].colour(scalars))[c] - 128, 65280);
        REQUIRE(level - deep[c] <= half + 33);
        REQUIRE(deep[c] - level <= 2 * half + 33 + 64);
        if (!in_first_entry(white[c], white_lights[c], scalars)) REQUIRE(deep[c] - level <= half + 33 + 64);
      }
    }
  }
}

TEMPLATE_TEST_CASE_SIG("the ramp of several lights has the colours of the middles of its entries", "",
                       ((Highlight Model, std::size_t Lights), Model, Lights), (Highlight::kBlinn, 2),
                       (Highlight::kPhong, 4)) {
  using White = Illumination<Lights, Model>;
  Random random(196);
  for (int i = 0; i < share_of(40); ++i) {
    Scene<Lights> scene(random);
    scene.material.highlight_fade = {};
    scene.material.specular = {};
    for (DirectionalLight& light : scene.lights) light = {light.towards};
    White lit;
    REQUIRE(ok(White::make(scene.material, scene.lights, scene.to_eye, lit)));
    // Scalars of a sum of N·L, 15 fraction bits.
    const auto at = [](std::int32_t sum) {
      typename White::Scalars scalars{};
      for (std::size_t k = 0; k < Lights; ++k) {
        const std::int32_t part = std::min(sum, 32768);
        scalars[k] = Cosine::from_raw(part << 15);
        sum -= part;
      }
      return scalars;
    };
    // The ramp ends at three quarters of the full light if every channel is saturated there.
    constexpr auto kFull = static_cast<std::int32_t>(Lights) << 15;
    const Channels late = channels(lit.deep_colour(at(kFull / 4 * 3)));
    const std::int32_t range = late == Channels{65280, 65280, 65280} ? kFull / 4 * 3 : kFull;
    const auto size = static_cast<std::int32_t>(lit.ramp().size());
    for (std::int32_t entry = 0; entry < size; ++entry) {
      const std::int32_t middle =
          static_cast<std::int32_t>(std::int64_t{range} * (2 * entry + 1) / (2 * size));
      const Channels found = quarters(lit.colour(at(middle)));
      REQUIRE(found == quarters(lit.ramp()[static_cast<std::size_t>(entry)]));
      const Channels deep = channels(lit.deep_colour(at(entry == 0 ? 0 : middle)));
      for (std::size_t c = 0; c < 3; ++c) {
        // Rounded to a quarter; a tie may fall to either side, because deep colours are rounded themselves.
        const std::int32_t nearest = deep[c] + 128 + 32;
        const bool is_exact = found[c] == nearest / 64 || (nearest % 64 == 0 && found[c] == nearest / 64 - 1);
        const bool is_saturated = deep[c] == 65280 && found[c] >= 1022;
        CAPTURE(entry, c, deep[c], found[c]);
        REQUIRE((is_exact || is_saturated));
      }
    }
  }
}

TEMPLATE_TEST_CASE_SIG("an illumination whose directions were changed is the one made with them", "",
                       ((Highlight Model, std::size_t Lights), Model, Lights), (Highlight::kPhong, 1),
                       (Highlight::kBlinn, 2), (Highlight::kPhong, 4)) {
  Random random(194);
  for (int i = 0; i < share_of(300); ++i) {
    const Scene<Lights> before(random);
    const Scene<Lights> after(random);
    auto lights = before.lights;
    std::array<Direction, Lights> directions;
    for (std::size_t k = 0; k < Lights; ++k) lights[k].towards = directions[k] = after.lights[k].towards;
    Coloured<Lights, Model> changed;
    Coloured<Lights, Model> made;
    REQUIRE(ok(Coloured<Lights, Model>::make(before.material, before.lights, before.to_eye, changed)));
    REQUIRE(ok(Coloured<Lights, Model>::make(before.material, lights, after.to_eye, made)));
    changed.set_directions(directions, after.to_eye);
    for (int k = 0; k < 40; ++k) {
      const Direction normal = to_direction(random_unit(random));
      REQUIRE(changed.scalars(normal) == made.scalars(normal));
      REQUIRE(changed.colour(changed.scalars(normal)).rgb8() == made.colour(made.scalars(normal)).rgb8());
    }
  }
}

TEMPLATE_TEST_CASE_SIG("coloured lights on textures are those on other surfaces", "",
                       ((Highlight Model, std::size_t Lights), Model, Lights), (Highlight::kPhong, 2),
                       (Highlight::kBlinn, 4)) {
  Random random(221);
  bool shines = false;
  for (int i = 0; i < share_of(500); ++i) {
    const Scene<Lights> before(random);
    const Scene<Lights> scene(random);
    Coloured<Lights, Model> lit;
    REQUIRE(ok(Coloured<Lights, Model>::make(scene.material, before.lights, scene.to_eye, lit)));
    std::array<Direction, Lights> directions;
    for (std::size_t k = 0; k < Lights; ++k) directions[k] = scene.lights[k].towards;
    lit.set_directions(directions, scene.to_eye);
    lit.set_strengths(scene.lights);
    for (int k = 0; k < 40; ++k) {
      auto scalars = lit.scalars(to_direction(random_unit(random)));
      for (std::size_t s = 0; s < scalars.size(); ++s) scalars[s] = lit.pixel_scalar(scalars[s], s);
      const PixelLight parts = lit.surface_light(scalars);
      const ChannelLight found = lit.channel_light(scalars);
      constexpr std::array<unsigned, 3> kLanes{11, 22, 0};
      constexpr std::array<unsigned, 3> kBits{5, 6, 5};
      for (std::size_t c = 0; c < 3; ++c) {
        const auto lane = [&](PackedRgb colour) { return int(colour.lanes >> kLanes[c] & 1023u); };
        const int most = (1 << kBits[c]) - 1;
        const int shine = int(found.shine >> kLanes[c]) & most;
        CAPTURE(i, k, c, lane(parts.diffuse), found.factors[c], lane(parts.highlight), shine);
        REQUIRE(std::abs(int(found.factors[c]) - lane(parts.diffuse)) <= 2);
        // Its light is rounded down to a quarter of an 8-bit step.
        const double wanted = std::min(lane(parts.highlight) / 4.0, 255.0) * most / 255;
        REQUIRE(std::abs(shine - wanted) <= 0.5 + 0.3 * most / 255);
        shines = shines || shine > 1;
      }
    }
  }
  CHECK(shines);
}

TEST_CASE("the colour of a single light is one with the material's") {
  using Plain = Illumination<1, Highlight::kPhong>;
  Random random(194);
  Scene<1> scene(random);
  scene.material.highlight_fade = {};
  scene.material.diffuse = {Coefficient::of(0.5), Coefficient::of(1.0), Coefficient::of(0.25)};
  scene.material.specular = {Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5)};
  scene.lights[0].strength = Coefficient::of(1.0);
  scene.lights[0].colour = {Coefficient::of(1.0), Coefficient::of(0.5), Coefficient::of(0.25)};
  Plain lit;
  REQUIRE(ok(Plain::make(scene.material, scene.lights, scene.to_eye, lit)));
  scene.material.diffuse = {Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.0625)};
  scene.material.specular = {Coefficient::of(0.5), Coefficient::of(0.25), Coefficient::of(0.125)};
  scene.lights[0].colour = DirectionalLight{}.colour;
  Plain coloured;
  REQUIRE(ok(Plain::make(scene.material, scene.lights, scene.to_eye, coloured)));
  for (int k = 0; k < 500; ++k) {
    const auto scalars = lit.scalars(to_direction(random_unit(random)));
    REQUIRE(lit.colour(scalars).lanes == coloured.colour(scalars).lanes);
  }
}

TEST_CASE("a highlight fades to nothing at the terminator and is whole from the fade's end on") {
  // Blinn with n = 2: at N·L = 0 the highlight is still 0.4.
  using Fading = Coloured<1, Highlight::kBlinn>;
  Material material;
  material.specular = {Coefficient::of(1.0), Coefficient::of(1.0), Coefficient::of(1.0)};
  material.shininess = 2;
  const std::array<DirectionalLight, 1> lights{DirectionalLight{normalised(0, 0, 1)}};
  const Direction to_eye = normalised(1, 0, 0);
  Fading abrupt;
  Fading fading;
  REQUIRE(ok(Fading::make(material, lights, to_eye, abrupt)));
  material.highlight_fade = Coefficient::of(0.125);
  REQUIRE(ok(Fading::make(material, lights, to_eye, fading)));
  CHECK(fading.fade().end() == Cosine::of(0.125));
  CHECK(abrupt.fade().end() == Cosine{});
  const auto level = [](const Fading& lit, double normal_light) {
    const Vec3 normal{std::sqrt(1 - normal_light * normal_light), 0, normal_light};
    return int{lit.colour(lit.scalars(to_direction(normal))).rgb8().r};
  };
  CHECK(level(abrupt, 0.001) > 100);
  CHECK(level(abrupt, -0.001) == 0);
  CHECK(level(fading, 0.001) <= 2);
  CHECK(level(fading, 0.0625) == Approx(0.5 * level(abrupt, 0.0625)).margin(1.5));
  CHECK(level(fading, 0.13) == level(abrupt, 0.13));
  int last = 0;
  for (double normal_light = -0.1; normal_light < 0.125; normal_light += 0.001) {
    const int next = level(fading, normal_light);
    CHECK(next - last >= 0);
    CHECK(next - last <= 3);
    last = next;
  }
}

TEST_CASE("without highlight a normal has the colour of the sum of several grey lights") {
  using Three = Illumination<3, Highlight::kPhong>;
  Random random(31);
  constexpr auto grey = [](Coefficient c) { return ChannelCoefficients{c, c, c}; };
  const Material material{
      grey(Coefficient::of(0.1)), {Coefficient::of(0.5), Coefficient::of(1), Coefficient::of(0.2)}, {}, 8};
  int partly = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    std::array<DirectionalLight, 3> lights{};
    for (DirectionalLight& light : lights) {
      light.towards = to_direction(random_unit(random));
      light.strength = Coefficient::from_raw(static_cast<std::int32_t>(random.integer(0, 32768)));
    }
    Three lit;
    REQUIRE(ok(Three::make(material, lights, to_direction(random_unit(random)), lit)));
    const auto scalars = lit.scalars(to_direction(random_unit(random)));
    REQUIRE(lit.diffuse_colour(lit.diffuse_sum(scalars)).lanes == lit.colour(scalars).lanes);
    std::uint32_t lit_mask = 0;
    for (std::size_t k = 0; k < 3; ++k) lit_mask |= scalars[k].raw() > 0 ? 1u << k : 0u;
    partly += lit_mask != 0 && lit_mask != 7 ? 1 : 0;
    // diffuse_scalar() of the lights that reach the normal differs by rounding only.
    const std::int32_t mean = lit.diffuse_scalar(scalars, lit_mask).raw();
    REQUIRE(std::abs(mean - lit.diffuse_sum(scalars).raw()) < 1 << 18);
  }
  CHECK(partly > share_of(20000) / 2);
}

TEMPLATE_TEST_CASE_SIG("where highlights of grey lights coincide, each channel saturates by itself", "",
                       ((std::size_t Lights, Highlight Model), Lights, Model), (2, Highlight::kPhong),
                       (4, Highlight::kBlinn)) {
  using Lit = Illumination<Lights, Model>;
  Random random(32);
  int saturated = 0;
  for (int i = 0; i < share_of(5000); ++i) {
    const Material material{{}, {}, random_channels(random), random.integer(1, 16)};
    const Vec3 front = random_unit(random);
    std::array<DirectionalLight, Lights> lights{};
    for (DirectionalLight& light : lights) light.towards = to_direction(tilted(random, front, 0.2));
    Lit lit;
    REQUIRE(ok(Lit::make(material, lights, to_direction(front), lit)));
    const auto scalars = lit.scalars(to_direction(tilted(random, front, random.real(0, 0.3))));
    auto of_pixel = scalars;
    for (std::size_t k = 0; k < scalars.size(); ++k) of_pixel[k] = lit.pixel_scalar(scalars[k], k);
    const Rgb8 arc = lit.surface_colour(of_pixel).rgb8();
    const Rgb8 exact = lit.colour(scalars).rgb8();  // as Flat has it
    saturated += exact.r == 255 && exact.g < 255 ? 1 : 0;
    CAPTURE(i, material.shininess);
    REQUIRE(std::abs(arc.r - exact.r) <= 4);
    REQUIRE(std::abs(arc.g - exact.g) <= 4);
    REQUIRE(std::abs(arc.b - exact.b) <= 4);
  }
  CHECK(saturated > share_of(100));
}

TEST_CASE("lights and fades that an illumination cannot have are refused, and it stays as it was") {
  using Plain2 = Illumination<2, Highlight::kBlinn>;
  using Coloured2 = Coloured<2, Highlight::kBlinn>;
  Random random(195);
  const Scene<2> scene(random);
  Material material = scene.material;
  material.highlight_fade = {};
  std::array<DirectionalLight, 2> lights = scene.lights;
  const Direction front = scene.to_eye;
  lights[0].colour = lights[1].colour = DirectionalLight{}.colour;
  Plain2 plain;
  REQUIRE(ok(Plain2::make(material, lights, front, plain)));
  const auto before = plain.colour(plain.scalars(front)).lanes;

  SECTION("several coloured lights need the feature; grey ones do not") {
    lights[1].colour = {Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5)};
    CHECK(Plain2::make(material, lights, front, plain) == Status::kOk);
    CHECK(Plain2::make(material, scene.lights, front, plain) == Status::kUnsupported);
    lights[1].colour.g = Coefficient::of(0.25);
    CHECK(Plain2::make(material, lights, front, plain) == Status::kUnsupported);
    Coloured2 coloured;
    CHECK(Coloured2::make(material, lights, front, coloured) == Status::kOk);
  }
  SECTION("a fade needs the feature") {
    material.highlight_fade = Coefficient::from_raw(1);
    CHECK(Plain2::make(material, lights, front, plain) == Status::kUnsupported);
    CHECK(plain.colour(plain.scalars(front)).lanes == before);
  }
  SECTION("colours and fades are 0...1") {
    for (const std::int32_t raw : {-1, 32769, INT32_MAX, INT32_MIN}) {
      for (auto channel : {&ChannelCoefficients::r, &ChannelCoefficients::g, &ChannelCoefficients::b}) {
        lights[1].colour = DirectionalLight{}.colour;
        lights[1].colour.*channel = Coefficient::from_raw(raw);
        Coloured2 coloured;
        CHECK(Coloured2::make(material, lights, front, coloured) == Status::kInvalidArgument);
        CHECK(Plain2::make(material, lights, front, plain) == Status::kInvalidArgument);
      }
      lights[1].colour = DirectionalLight{}.colour;
      Material faded = material;
      faded.highlight_fade = Coefficient::from_raw(raw);
      Coloured2 coloured;
      CHECK(Coloured2::make(faded, lights, front, coloured) == Status::kInvalidArgument);
    }
    CHECK(plain.colour(plain.scalars(front)).lanes == before);
  }
}
