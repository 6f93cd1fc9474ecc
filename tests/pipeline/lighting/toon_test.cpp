// SPDX-License-Identifier: MIT
// Light in steps: equal entries of the ramp within a step, and highlights that are there or not.
#include <arcspan/lighting/illumination.hpp>
#include <arcspan/lighting/toon.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

using namespace arcspan;

namespace {

constexpr Direction kAhead = normalised(0, 0, 1);

Material orange() {
  Material m;
  m.ambient = {Coefficient::of(0.1), Coefficient::of(0.05), Coefficient::of(0.02)};
  m.diffuse = {Coefficient::of(0.8), Coefficient::of(0.5), Coefficient::of(0.2)};
  m.specular = {Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5)};
  m.shininess = 20;
  return m;
}

template <std::size_t Lights, Highlight Model = Highlight::kBlinn>
Illumination<Lights, Model> lit() {
  std::array<DirectionalLight, Lights> lights;
  for (DirectionalLight& light : lights) light = {kAhead, Coefficient::of(0.6)};
  Illumination<Lights, Model> made;
  REQUIRE(ok(Illumination<Lights, Model>::make(orange(), lights, kAhead, made)));
  return made;
}

template <std::size_t Lights>
void check_steps(std::int32_t steps) {
  const auto smooth = lit<Lights>();
  auto toon = smooth;
  REQUIRE(ok(toon.set_toon(steps)));
  const auto& ramp = toon.ramp();
  const std::size_t size = ramp.size();
  CHECK(ramp.front().rgb8() == smooth.ramp().front().rgb8());
  const Rgb8 brightest = smooth.ramp().back().rgb8();
  CHECK(std::abs(int{ramp.back().rgb8().r} - brightest.r) <= 2);
  std::size_t changes = 0;
  for (std::size_t i = 1; i < size; ++i) {
    CHECK(ramp[i].rgb8().r >= ramp[i - 1].rgb8().r);
    if (ramp[i].lanes == ramp[i - 1].lanes) continue;
    ++changes;
    // Within the edge of a step, which begins at a multiple of size / steps.
    const std::size_t inside = i * static_cast<std::size_t>(steps) % size;
    CHECK(inside <= static_cast<std::size_t>(steps) * (size / 64 + 1));
  }
  CHECK(changes >= static_cast<std::size_t>(steps) - 1);
  for (std::int32_t k = 0; k < steps; ++k) {
    // The middle of a step has the light of k / (steps - 1).
    const auto middle = (2 * static_cast<std::size_t>(k) + 1) * size / (2 * static_cast<std::size_t>(steps));
    const auto same = static_cast<std::size_t>(k) * (size - 1) / (static_cast<std::size_t>(steps) - 1);
    CHECK(std::abs(int{ramp[middle].rgb8().r} - smooth.ramp()[same].rgb8().r) <= 2);
  }
}

}  // namespace

TEST_CASE("Toon: the ramp has equal steps with narrow edges") {
  for (std::int32_t steps = 2; steps <= 16; ++steps) {
    check_steps<1>(steps);
    check_steps<2>(steps);
    check_steps<4>(steps);
  }
}

TEST_CASE("Toon: an illumination that was never made stays black") {
  Illumination<1, Highlight::kBlinn> dark;
  REQUIRE(ok(dark.set_toon(3)));
  CHECK(dark.ramp().back().lanes == dark.ramp().front().lanes);
}

TEST_CASE("Toon: another number of steps takes the place of the first") {
  auto once = lit<2>();
  REQUIRE(ok(once.set_toon(5)));
  auto twice = lit<2>();
  REQUIRE(ok(twice.set_toon(2)));
  REQUIRE(ok(twice.set_toon(5)));
  for (std::size_t i = 0; i < once.ramp().size(); ++i) REQUIRE(twice.ramp()[i].lanes == once.ramp()[i].lanes);
  for (std::int32_t at = 1; at < 1 << 25; at += 1 << 17) {
    REQUIRE(twice.highlight_at(at).lanes == once.highlight_at(at).lanes);
  }
}

TEST_CASE("Toon: other numbers of steps are refused") {
  auto light = lit<1>();
  const auto before = light.ramp();
  for (const std::int32_t steps : {-1, 0, 1, 17, INT32_MAX}) {
    CHECK(light.set_toon(steps) == Status::kInvalidArgument);
  }
  for (std::size_t i = 0; i < before.size(); ++i) CHECK(light.ramp()[i].lanes == before[i].lanes);
}

TEMPLATE_TEST_CASE_SIG("Toon: a highlight is as bright as its middle, or not there", "",
                       ((Highlight Model), Model), Highlight::kBlinn, Highlight::kPhong) {
  const auto smooth = lit<1, Model>();
  auto toon = smooth;
  REQUIRE(ok(toon.set_toon(3)));
  const auto highlight = [&](const auto& light, std::int32_t closeness) {
    return int{light.highlight_at(closeness).rgb8().r};
  };
  const std::int32_t reach = (std::int32_t{1} << 25) - 1;
  const int peak = highlight(smooth, reach);
  REQUIRE(peak > 60);
  CHECK(std::abs(highlight(toon, reach) - peak) <= 1);
  int between = 0;
  int bright = 0;
  for (std::int32_t c = 1; c < reach; c += 1 << 15) {
    const int soft = highlight(smooth, c);
    const int hard = highlight(toon, c);
    if (hard > 1 && hard < peak - 1) ++between;
    if (hard >= peak - 1) ++bright;
    if (soft > peak * 0.6) CHECK(hard >= peak - 1);
    if (soft < peak * 0.4) CHECK(hard <= 1);
  }
  CHECK(bright > 50);
  CHECK(between <= 8);  // one interval of the table
}
