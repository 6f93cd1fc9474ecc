// SPDX-License-Identifier: MIT
// What the compiler sets up is bit for bit what the program would.
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <catch2/catch.hpp>
#include <tests/frames/integer_shapes.hpp>

#include <cstring>
#include <type_traits>

using namespace arcspan;

namespace {

/// Hides from the compiler that an angle is known.
Turn at_run_time(std::uint16_t raw) {
  const volatile std::uint16_t hidden = raw;
  return {hidden};
}

template <class T>
bool same_bits(const T& a, const T& b) {
  static_assert(std::has_unique_object_representations_v<T>);
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

constexpr Rotation tilt(Turn x, Turn y, Turn z) {
  return Rotation::about_x(x) * Rotation::about_y(y) * Rotation::about_z(z);
}

constexpr Placement placed(const Rotation& rotation) {
  return {rotation, {ObjectLength::of(-100.25), ObjectLength::of(3), ObjectLength::of(-65536)}};
}
constexpr Projection kProjection{PixelLength::of(278.5), ObjectLength::of(32768), ObjectLength::of(98304)};
constexpr Viewport kViewport{319, 240};

constexpr Material shiny(std::int32_t n) {
  return {{Coefficient::of(0.1), Coefficient::of(0.2), Coefficient::of(0.3)},
          {Coefficient::of(0.7), Coefficient::of(0.5), Coefficient::of(0.25)},
          {Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.625)},
          n};
}

template <std::size_t Lights>
constexpr std::array<DirectionalLight, Lights> suns(const Rotation& rotation) {
  std::array<DirectionalLight, Lights> lights{};
  for (std::size_t i = 0; i < Lights; ++i) {
    const auto k = static_cast<std::int32_t>(i);
    lights[i] = {rotation.to_object(normalised(3 - k, 4 + k, 5)), Coefficient::of(0.75)};
  }
  return lights;
}

constexpr Rotation kTilt = tilt({4551}, {3000}, {60000});
constexpr Direction kEye = kTilt.to_object(normalised(0, 0, 1));

template <std::size_t Lights, Highlight Model, std::int32_t N>
void check_light() {
  using Light = Illumination<Lights, Model>;
  constexpr Light kConstant = Light::of(shiny(N), suns<Lights>(kTilt), kEye);
  const Rotation rotation = tilt(at_run_time(4551), at_run_time(3000), at_run_time(60000));
  const volatile std::int32_t n = N;
  Light made;
  REQUIRE(ok(Light::make(shiny(n), suns<Lights>(rotation), rotation.to_object(normalised(0, 0, 1)), made)));
  if constexpr (Lights == 1) {
    CHECK(same_bits(kConstant, made));
  } else {  // no ramp, in whose place there are bits that mean nothing
    for (std::int32_t x = -32000; x <= 32000; x += 1500) {
      const auto scalars = made.scalars(normalised(x, 9000, 20000));
      REQUIRE(kConstant.scalars(normalised(x, 9000, 20000)) == scalars);
      REQUIRE(same_bits(kConstant.colour(scalars), made.colour(scalars)));
    }
  }
}

}  // namespace

TEST_CASE("a rotation and a transform as constants are those made at run time") {
  const Rotation rotation = tilt(at_run_time(4551), at_run_time(3000), at_run_time(60000));
  CHECK(same_bits(kTilt, rotation));
  constexpr ClipTransform kConstant = ClipTransform::of(placed(kTilt), kProjection, kViewport);
  ClipTransform made;
  REQUIRE(ok(ClipTransform::make(placed(rotation), kProjection, kViewport, made)));
  CHECK(same_bits(kConstant, made));
}

TEST_CASE("an illumination as a constant is the one made at run time") {
  check_light<1, Highlight::kBlinn, 32>();
  check_light<1, Highlight::kPhong, 1>();
  check_light<1, Highlight::kPhong, 256>();
  check_light<4, Highlight::kBlinn, 7>();
}

TEST_CASE("so is one with a tolerance") {
  using Light = Illumination<1, Highlight::kPhong>;
  constexpr Light kConstant = [] {
    Light light = Light::of(shiny(16), suns<1>(kTilt), kEye);
    (void)light.set_tolerance(2);
    return light;
  }();
  Light light;
  const volatile std::int32_t n = 16;
  REQUIRE(ok(Light::make(shiny(n), suns<1>(kTilt), kEye, light)));
  REQUIRE(ok(light.set_tolerance(2)));
  CHECK(same_bits(kConstant, light));
}

TEST_CASE("a mesh as a constant views its arrays") {
  static constexpr auto kShape = scenes::make_sphere<8, 4>();
  static constexpr MeshView kMesh = MeshView::of(kShape.positions, kShape.normals, kShape.indices);
  static_assert(kMesh.vertex_count() == kShape.positions.size());
  static_assert(3 * kMesh.triangle_count() == kShape.indices.size());
  CHECK(&kMesh.position(0) == kShape.positions.data());
  CHECK(kMesh.triangle(1).b == kShape.indices[4]);
}
