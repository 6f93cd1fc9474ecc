// SPDX-License-Identifier: MIT
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/scene/camera.hpp>
#include <arcspan/scene/object.hpp>

#include <bit>

namespace arcspan {

namespace {

/// Converts world lengths (16 fraction bits) to object units of one object (8 fraction bits), in units of
/// 2^unit_bits that let the largest of them fit 30 bits.
class UnitConversion {
 public:
  UnitConversion(WorldLength scale, std::uint64_t largest, int least_unit_bits) {
    // length * 2^15 * 2^8 / scale, by a reciprocal with 30 bits.
    const WideReciprocal inverse = wide_reciprocal(static_cast<std::uint32_t>(scale.raw()));
    factor_ = inverse.mantissa >> 1;
    dropped_ = width(largest) > 33 ? width(largest) - 33 : 0;
    const int shift = inverse.exponent - 1 - (15 + ObjectLength::kFraction) - dropped_;
    const int bits = width((largest >> dropped_) * factor_) - shift;
    unit_bits_ = bits - 30 > least_unit_bits ? bits - 30 : least_unit_bits;
    shift_ = shift + unit_bits_;
  }
  [[nodiscard]] int unit_bits() const { return unit_bits_; }
  [[nodiscard]] std::int64_t operator()(std::int64_t length) const {
    return ((length >> dropped_) * static_cast<std::int64_t>(factor_)) >> shift_;
  }

 private:
  static int width(std::uint64_t v) { return static_cast<int>(std::bit_width(v)); }

  std::uint64_t factor_;
  int dropped_;  ///< lower bits of lengths that a product of 64 bits has no room for
  int shift_;
  int unit_bits_;
};

/// a * b, rounded once per entry.
Rotation product(const Rotation& a, const Rotation& b) {
  Rotation rotation;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      std::uint64_t sum = std::uint64_t{1} << 29;  // wraps if neither is a rotation
      for (std::size_t k = 0; k < 3; ++k)
        sum += static_cast<std::uint64_t>(std::int64_t{a.m[i][k].raw()} * b.m[k][j].raw());
      rotation.m[i][j] = detail::rotation_entry(static_cast<std::int64_t>(sum) >> 30);
    }
  }
  return rotation;
}

/// The component of a vector along axis `i` of a rotation.
std::int64_t along(const Rotation& rotation, std::size_t i, const std::array<std::int64_t, 3>& vector) {
  std::int64_t sum = 0;
  for (std::size_t j = 0; j < 3; ++j) sum += detail::product30(rotation.m[i][j].raw(), vector[j]);
  return sum;
}

}  // namespace

std::int64_t Camera::distance_to(const WorldPoint& point) const {
  return -along(rotation_, 2, detail::difference(eye_, point));
}

bool Camera::place(const WorldPoint& position, const Rotation& rotation, WorldLength scale,
                   ClipTransform& transform) const {
  if (scale < kLeastScale || near_ == 0) return false;
  ARCSPAN_CHECK(detail::is_orthonormal(rotation), "scene: the rotation of an object is not orthonormal");
  const std::array<std::int64_t, 3> from_eye = detail::difference(eye_, position);
  std::int64_t view[3] = {};
  // The near plane is converted too. Where it is farther away than the object, it hides the object.
  std::uint64_t largest = static_cast<std::uint64_t>(near_);
  for (std::size_t i = 0; i < 3; ++i) {
    view[i] = along(rotation_, i, from_eye);
    if (i == 2) view[i] -= set_back_;
    largest |= magnitude(view[i]);
  }
  const UnitConversion to_units(scale, largest, parallel_ ? 1 : WidePlacement::kLeastUnitBits);
  if (to_units.unit_bits() > WidePlacement::kMostUnitBits) return false;
  WidePlacement placement{product(rotation_, rotation), {}, to_units(near_), focal_, focal_bits_,
                          to_units.unit_bits()};
  if (placement.near_plane < 1) placement.near_plane = 1;
  const std::int64_t far_plane = placement.near_plane + to_units(planes_apart_) + 2;  // both round down
  if (far_plane < WidePlacement::kNoFarPlane) placement.far_plane = far_plane;
  for (std::size_t i = 0; i < 3; ++i) placement.translation[i] = to_units(view[i]);
  transform.set_lens(lens_);
  transform.set_placement(placement);
  return true;
}

ScreenPoint Camera::project(const WorldPoint& point) const {
  ClipTransform transform;
  if (!place(point, Rotation::identity(), WorldLength::of(1.0), transform)) return {};
  return screen_point(transform, {0, 0, 0});
}

ScreenPoint Camera::project(const Object& object, const ObjectPosition& point) const {
  ClipTransform transform;
  if (!place(object.position, object.rotation, object.scale, transform)) return {};
  return screen_point(transform, point);
}

}  // namespace arcspan
