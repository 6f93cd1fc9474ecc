// SPDX-License-Identifier: MIT
#include <arcspan/vertex/rotation.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>

using namespace arcspan;

namespace {

constexpr double kTau = 6.283185307179586;

double value(RotationEntry entry) { return entry.raw() / 1073741824.0; }

}  // namespace

TEST_CASE("sine and cosine of every angle are within 2^-28") {
  double worst = 0;
  for (int i = 0; i < 65536; ++i) {
    const Turn angle{static_cast<std::uint16_t>(i)};
    worst = std::max(worst, std::abs(value(sine(angle)) - std::sin(kTau * i / 65536)));
    worst = std::max(worst, std::abs(value(cosine(angle)) - std::cos(kTau * i / 65536)));
  }
  CHECK(worst < 1.0 / (1 << 28));
}

TEST_CASE("rotations are right-handed") {
  const Turn quarter{0x4000};
  // About x, y goes to z; about y, z goes to x; about z, x goes to y: columns are images of the axes.
  CHECK(value(Rotation::about_x(quarter).m[2][1]) == Approx(1));
  CHECK(value(Rotation::about_y(quarter).m[0][2]) == Approx(1));
  CHECK(value(Rotation::about_z(quarter).m[1][0]) == Approx(1));
}

TEST_CASE("a product applies its right factor first and stays orthonormal") {
  const Rotation a = Rotation::about_z({5000});
  const Rotation b = Rotation::about_x({12345});
  const Rotation product = a * b;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double sum = 0;
      double square = 0;
      for (int k = 0; k < 3; ++k) {
        sum += value(a.m[i][k]) * value(b.m[k][j]);
        square += value(product.m[i][k]) * value(product.m[j][k]);
      }
      CHECK(std::abs(value(product.m[i][j]) - sum) < 3e-9);
      CHECK(std::abs(square - (i == j)) < 1e-8);
    }
  }
}

TEST_CASE("a thousand products are still precise enough for culling by planes, a hundred thousand are not") {
  const Rotation turn = Rotation::about_y({37}) * Rotation::about_x({11});
  Rotation turned = Rotation::identity();
  for (int i = 0; i < 1000; ++i) turned = turn * turned;
  CHECK(detail::is_orthonormal(turned));
  for (int i = 0; i < 99000; ++i) turned = turn * turned;
  CHECK_FALSE(detail::is_orthonormal(turned));
}

// As a constant, to_object() of numbers that are neither a rotation nor a direction compiles only if no sum
// overflows.
namespace {
constexpr auto kLeastEntry = RotationEntry::from_raw(INT32_MIN);
constexpr auto kLeastComponent = DirectionComponent::from_raw(INT32_MIN);
constexpr Rotation kNoRotation{{{kLeastEntry, kLeastEntry, kLeastEntry},
                                {kLeastEntry, kLeastEntry, kLeastEntry},
                                {kLeastEntry, kLeastEntry, kLeastEntry}}};
constexpr Direction kAnywhere = kNoRotation.to_object({kLeastComponent, kLeastComponent, kLeastComponent});
static_assert(kAnywhere.x == kAnywhere.y && kAnywhere.y == kAnywhere.z);
static_assert(normalised_wide(INT64_MIN, 0, 0) == normalised_wide(-1, 0, 0));
}  // namespace

TEST_CASE("to_object undoes the rotation of a direction") {
  const Rotation rotation = Rotation::about_y({1000}) * Rotation::about_x({60000});
  const Direction lighting = normalised(3, -5, 7);
  double view[3];
  for (int i = 0; i < 3; ++i) {
    view[i] = value(rotation.m[i][0]) * lighting.x.raw() + value(rotation.m[i][1]) * lighting.y.raw() +
              value(rotation.m[i][2]) * lighting.z.raw();
  }
  const Direction back =
      rotation.to_object(normalised(static_cast<std::int32_t>(std::lround(view[0] * 1000)),
                                    static_cast<std::int32_t>(std::lround(view[1] * 1000)),
                                    static_cast<std::int32_t>(std::lround(view[2] * 1000))));
  CHECK(std::abs(back.x.raw() - lighting.x.raw()) <= 2);
  CHECK(std::abs(back.y.raw() - lighting.y.raw()) <= 2);
  CHECK(std::abs(back.z.raw() - lighting.z.raw()) <= 2);
}
