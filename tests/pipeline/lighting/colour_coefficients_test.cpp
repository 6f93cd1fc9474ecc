// SPDX-License-Identifier: MIT
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/lighting/illumination.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>

using namespace arcspan;

TEST_CASE("coefficients of bytes show these bytes in full light") {
  using Light = Illumination<1, Highlight::kPhong>;
  CHECK(coefficient_of(255) == Coefficient::of(1.0));
  CHECK(coefficient_of(0) == Coefficient{});
  for (int i = 0; i < 256; ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    CHECK(std::abs(coefficient_of(byte).raw() / 32768.0 - i / 255.0) < 0.51 / 32768);
    Material material;
    material.ambient = coefficients_of({byte, 0, 255});
    Light light;
    constexpr Direction kAhead = normalised(0, 0, 1);
    REQUIRE(Light::make(material, {DirectionalLight{kAhead}}, kAhead, light) == Status::kOk);
    CHECK(light.diffuse_colour({}).rgb8() == Rgb8{byte, 0, 255});
  }
}

TEST_CASE("a coefficient is a checked ratio of integers") {
  Coefficient c = Coefficient::of(0.25);
  CHECK(make_coefficient(35, 100, c) == Status::kOk);
  CHECK(c == Coefficient::of(0.35));
  CHECK(make_coefficient(0, 1, c) == Status::kOk);
  CHECK(c == Coefficient{});
  CHECK(make_coefficient(INT32_MAX, INT32_MAX, c) == Status::kOk);
  CHECK(c == Coefficient::of(1.0));
  for (const auto& [part, whole] : {std::pair{-1, 10}, {11, 10}, {0, 0}, {-3, -5}, {INT32_MIN, INT32_MIN}}) {
    CHECK(make_coefficient(part, whole, c) == Status::kInvalidArgument);
  }
  CHECK(c == Coefficient::of(1.0));
}

TEST_CASE("sRGB bytes and linear light convert both ways") {
  for (int i = 0; i < 256; ++i) {
    const double c = i / 255.0;
    const double light = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    const auto byte = static_cast<std::uint8_t>(i);
    CHECK(std::abs(linear_from_srgb(byte).raw() - 32768 * light) < 0.501);
    CHECK(srgb_from_linear(linear_from_srgb(byte)) == byte);
  }
  CHECK(srgb_from_linear(Coefficient::of(0.5)) == 188);
  CHECK(srgb_from_linear(Coefficient::of(0.2158)) == 128);
  CHECK(srgb_from_linear(Coefficient::from_raw(-5)) == 0);
  CHECK(srgb_from_linear(Coefficient::from_raw(40000)) == 255);
  CHECK(srgb_from_linear(Coefficient::from_raw(INT32_MIN)) == 0);
  CHECK(srgb_from_linear(Coefficient::from_raw(INT32_MAX)) == 255);
}

TEST_CASE("plastic has the shares of its colour") {
  constexpr Material kPlastic = plastic({255, 100, 0}, 16);
  CHECK(kPlastic.diffuse.r == Coefficient::of(0.8));
  CHECK(kPlastic.ambient.r == Coefficient::of(0.2));
  CHECK(std::abs(kPlastic.diffuse.g.raw() - 32768 * 0.8 * 100 / 255) < 0.6);
  CHECK(kPlastic.diffuse.b == Coefficient{});
  CHECK(kPlastic.shininess == 16);
  CHECK(kPlastic.specular.b == Coefficient::of(0.5));
}
