// SPDX-License-Identifier: MIT
// Materials whose light has steps.
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/lighting/toon.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/textured.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/scene_support.hpp>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using OneLamp = Illumination<1, Highlight::kBlinn>;

/// Checks that set_toon() of a material gives its light the ramp of an illumination with set_toon().
template <class Method>
void check_ramp() {
  const LightList light{kLights.lights.first(1)};
  PreparedMaterial<Method> smooth;
  REQUIRE(ok(PreparedMaterial<Method>::make(plastic({220, 130, 70}), light, {}, smooth)));
  PreparedMaterial<Method> toon = smooth;
  CHECK(toon.set_toon(1) == Status::kInvalidArgument);
  REQUIRE(ok(toon.set_toon(4)));
  OneLamp expected = smooth.lighting();
  REQUIRE(ok(expected.set_toon(4)));
  CHECK(toon.lighting().tolerance() == smooth.lighting().tolerance());
  bool same = true;
  bool changed = false;
  for (std::size_t i = 0; i < OneLamp::kRampSize; ++i) {
    same = same && toon.lighting().ramp()[i].lanes == expected.ramp()[i].lanes;
    changed = changed || toon.lighting().ramp()[i].lanes != smooth.lighting().ramp()[i].lanes;
  }
  CHECK(same);
  CHECK(changed);
}

}  // namespace

TEST_CASE("Toon: a material has the steps of its illumination") {
  check_ramp<Arc<OneLamp>>();
  check_ramp<Textured<Arc<OneLamp>, DirectTexels<>>>();
}
