// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/checked.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/unit_vector.hpp>
#include <arcspan/scene/world.hpp>
#include <arcspan/status.hpp>
#include <arcspan/vertex/clip_transform.hpp>
#include <arcspan/vertex/rotation.hpp>
#include <arcspan/vertex/screen_point.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace arcspan {

class Object;  // forward: scene/object.hpp

/// Where a camera stands and which point appears in the middle of its picture.
struct LookAt {
  WorldPoint eye;
  WorldPoint target;
  Direction up = normalised(0, 1, 0);  ///< appears upright; any direction that is not that of the view
};

/// How a camera pictures the world, in one of three ways. Ranges are checked by Camera::make().
class Lens {
 public:
  /// Perspective. `vertical` is the angle between the upper and the lower edge of the picture, above 0 and
  /// below half a turn. Parts nearer than `near_plane` or farther than `far_plane` are clipped.
  /// 0 < near < far.
  [[nodiscard]] static constexpr Lens field_of_view(Turn vertical, WorldLength near_plane,
                                                    WorldLength far_plane) {
    return {Kind::kFieldOfView, vertical.raw, near_plane, far_plane};
  }
  /// Perspective. `focal` is the distance of the picture plane in pixels, above 0.
  [[nodiscard]] static constexpr Lens focal_length(PixelLength focal, WorldLength near_plane,
                                                   WorldLength far_plane) {
    return {Kind::kFocalLength, focal.raw(), near_plane, far_plane};
  }
  /// Parallel projection of `height` world units to the height of the picture. It is computed as a
  /// perspective from 4096 times the distance between the planes, so that perspective cameras need no other
  /// code: a point on the near or far plane is drawn too far from or too near to the picture's middle by
  /// 1/8192 of its distance, 0.02 pixels at 160. far - near should not exceed 64 times `height`; beyond,
  /// positions are coarser than 1/16 of a pixel in a picture of 240 rows. Back faces are not found by planes.
  [[nodiscard]] static constexpr Lens orthographic(WorldLength height, WorldLength near_plane,
                                                   WorldLength far_plane) {
    return {Kind::kOrthographic, height.raw(), near_plane, far_plane};
  }

 private:
  friend class Camera;
  enum class Kind : std::uint8_t { kFieldOfView, kFocalLength, kOrthographic };
  constexpr Lens(Kind kind, std::int32_t amount, WorldLength near_plane, WorldLength far_plane)
      : kind_(kind), amount_(amount), near_(near_plane), far_(far_plane) {}

  Kind kind_;
  std::int32_t amount_;  ///< the first argument's raw()
  WorldLength near_;
  WorldLength far_;
};

namespace detail::refused {  // further reasons of Camera::of()
void field_of_view_out_of_range();
void orthographic_height_out_of_range();
}  // namespace detail::refused

/// A camera in world space, with a lens and the size of its picture. It looks along -z of its own axes; y is
/// up. The whole is a constant if made by of().
class Camera {
 public:
  constexpr Camera() = default;

  /// Returns, and does not change `camera` unless kOk:
  ///
  ///   kNoViewDirection    the eye is at its target, or `view.up` is parallel to the view
  ///   kNearNotBeforeFar   the planes of the lens are not 0 < near < far
  ///   kInvalidArgument    another argument is out of its range: picture size 1...2048, field of view, focal
  ///                       length, height, or a focal length that is above 2^20 pixels
  [[nodiscard]] static constexpr Status make(const LookAt& view, const Lens& lens, const Viewport& viewport,
                                             Camera& camera) {
    Camera made;
    const Status status = made.set_lens(lens, viewport);
    if (!ok(status)) return status;
    const Status looks = made.look_at(view);
    if (ok(looks)) camera = made;
    return looks;
  }

  /// make() as a constant, which can lie in flash. Arguments that make() rejects do not compile.
  [[nodiscard]] static consteval Camera of(const LookAt& view, const Lens& lens, const Viewport& viewport) {
    Camera camera;
    const Status status = make(view, lens, viewport, camera);
    if (status == Status::kInvalidArgument) {
      if (!detail::is_picture_size(viewport)) {
        detail::refused::picture_side_outside_1_to_2048();
      } else if (lens.kind_ == Lens::Kind::kFieldOfView) {
        detail::refused::field_of_view_out_of_range();
      } else if (lens.kind_ == Lens::Kind::kFocalLength) {
        detail::refused::focal_length_not_above_0();
      } else {
        detail::refused::orthographic_height_out_of_range();
      }
    } else if (!ok(status)) {
      detail::refuse(status);
    }
    return camera;
  }

  /// Moves and turns the camera. Returns kNoViewDirection and changes nothing as make() does. The axes are
  /// within 2^-26 of the exact ones if `up` is at least 10 degrees from the view.
  [[nodiscard]] constexpr Status look_at(const LookAt& view);

  /// Moves and turns the camera freely; the rows of `rotation` are the camera's axes in world space: x to the
  /// right, y up, z backwards.
  constexpr void set_pose(const WorldPoint& eye, const Rotation& rotation) {
    ARCSPAN_CHECK(detail::is_orthonormal(rotation), "Camera::set_pose: the rotation is not orthonormal");
    eye_ = eye;
    rotation_ = rotation;
  }

  [[nodiscard]] constexpr const WorldPoint& eye() const { return eye_; }
  /// The rotation from world space to view space.
  [[nodiscard]] constexpr const Rotation& rotation() const { return rotation_; }
  [[nodiscard]] constexpr const Viewport& viewport() const { return lens_.viewport(); }

  static constexpr WorldLength kLeastScale = WorldLength::of(1.0 / 1024);

  /// Makes the transform of an object that stands at `position`, with `rotation` from object to world space;
  /// `scale` is the world length of 32768 object units. The translation keeps 30 bits. Returns false, and
  /// does not change `transform`, if `scale` is below kLeastScale, the camera has not been made, or the
  /// object is more than 2^31 times as far away as it is large, so that it covers no pixel.
  [[nodiscard]] bool place(const WorldPoint& position, const Rotation& rotation, WorldLength scale,
                           ClipTransform& transform) const;

  /// How far a point of the world lies before the eye, along the view: 16 fraction bits, below 2^33 in
  /// magnitude, negative behind it.
  [[nodiscard]] std::int64_t distance_to(const WorldPoint& point) const;

  /// Returns where a point of the world appears. It is within 1/16 of a pixel, and the rounding of 16
  /// fraction bits of a world unit, of the exact place. A camera that has not been made sees nothing
  /// (`in_front` is false).
  [[nodiscard]] ScreenPoint project(const WorldPoint& point) const;
  /// Returns where `point` of an object's mesh appears, in object units: bit for bit where draw_scene() puts
  /// a vertex at that position. `in_front` is false also if place() refuses the object.
  [[nodiscard]] ScreenPoint project(const Object& object, const ObjectPosition& point) const;

 private:
  /// An orthographic lens has its eye this many times the distance of its planes before them.
  static constexpr std::int32_t kParallel = 4096;

  [[nodiscard]] constexpr Status set_lens(const Lens& lens, const Viewport& viewport);
  [[nodiscard]] constexpr Status set_parallel(const Lens& lens, const Viewport& viewport);

  // The widest members come first. Where padding lies between members, clang 14 puts the result of of() in
  // the wrong place if the camera is a variable.
  std::int64_t near_ = 0;      ///< 16 fraction bits; kParallel times the planes' distance if orthographic
  std::int64_t set_back_ = 0;  ///< distance from the eye of an orthographic lens to eye_, 16 fraction bits
  Rotation rotation_ = Rotation::identity();
  WorldPoint eye_{};
  ClipTransform lens_;      ///< viewport and depths; an object's transform is a copy with another placement
  std::int32_t focal_ = 0;  ///< times 2^focal_bits_: 11 fraction bits of a pixel
  int focal_bits_ = 0;
  std::int32_t planes_apart_ = 0;  ///< 16 fraction bits
  bool parallel_ = false;
};

constexpr Status Camera::look_at(const LookAt& view) {
  using Vector = std::array<std::int64_t, 3>;
  using Unit = std::array<std::int32_t, 3>;
  const Unit back = unit_vector30<3>(detail::difference(view.target, view.eye));
  // The terms are halved because back * up is below 2^60 only if up is a unit vector of 15 bits.
  const auto cross = [](const Unit& a, const Unit& b) {
    const auto cofactor = [&](std::size_t i, std::size_t j) {
      return ((std::int64_t{a[i]} * b[j]) >> 1) - ((std::int64_t{a[j]} * b[i]) >> 1);
    };
    return Vector{cofactor(1, 2), cofactor(2, 0), cofactor(0, 1)};
  };
  const Unit up{view.up.x.raw(), view.up.y.raw(), view.up.z.raw()};
  const Unit right = unit_vector30<3>(cross(up, back));
  if (is_zero(right)) return Status::kNoViewDirection;  // also if `back` is zero
  const Unit above = unit_vector30<3>(cross(back, right));
  const Unit axes[3] = {right, above, back};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) rotation_.m[i][j] = detail::rotation_entry(axes[i][j]);
  }
  eye_ = view.eye;
  return Status::kOk;
}

constexpr Status Camera::set_lens(const Lens& lens, const Viewport& viewport) {
  if (lens.near_.raw() <= 0 || lens.far_ <= lens.near_) return Status::kNearNotBeforeFar;
  if (!detail::is_picture_size(viewport)) return Status::kInvalidArgument;
  planes_apart_ = lens.far_.raw() - lens.near_.raw();
  if (lens.kind_ == Lens::Kind::kOrthographic) return set_parallel(lens, viewport);
  std::int64_t focal = lens.amount_;
  if (lens.kind_ == Lens::Kind::kFieldOfView) {
    // (height / 2) / tan(a / 2), tan(a / 2) = sin a / (1 + cos a).
    const Turn angle{static_cast<std::uint16_t>(lens.amount_)};
    const std::int32_t opposite = sine(angle).raw();
    if (opposite <= 0) return Status::kInvalidArgument;
    const std::int64_t adjacent = detail::kOne30 + cosine(angle).raw();
    focal = static_cast<std::int64_t>(
        static_cast<std::uint64_t>((std::int64_t{viewport.height} << (PixelLength::kFraction - 1)) *
                                   adjacent) /
        static_cast<std::uint32_t>(opposite));
    if (focal > INT32_MAX) return Status::kInvalidArgument;
  }
  focal_ = static_cast<std::int32_t>(focal);
  near_ = lens.near_.raw();
  // Depths depend on the ratio of the planes only.
  return ClipTransform::make({Rotation::identity(), {}},
                             {PixelLength::from_raw(focal_), ObjectLength::from_raw(lens.near_.raw()),
                              ObjectLength::from_raw(lens.far_.raw())},
                             viewport, lens_);
}

constexpr Status Camera::set_parallel(const Lens& lens, const Viewport& viewport) {
  if (lens.amount_ <= 0) return Status::kInvalidArgument;
  const std::int64_t range = planes_apart_;
  static_assert(
      (65535 - 2 * ClipTransform::kDepthMargin) * std::int64_t{kParallel + 1} < (std::int32_t{1} << 28) - 1,
      "ClipTransform::make() would cut the slope of depths");
  near_ = kParallel * range;
  set_back_ = near_ - lens.near_.raw();
  parallel_ = true;
  // focal = (viewport.height / height) * (kParallel + 1/2) * range pixels. The dividend is shifted to 63
  // bits.
  const std::uint64_t dividend =
      static_cast<std::uint64_t>(range) * static_cast<std::uint32_t>(viewport.height * (2 * kParallel + 1));
  const int up = std::countl_zero(dividend) - 1;
  const std::uint64_t focal = (dividend << up) / static_cast<std::uint32_t>(lens.amount_);
  const int down = static_cast<int>(std::bit_width(focal)) - 31;
  focal_ = static_cast<std::int32_t>(focal >> down);
  focal_bits_ = PixelLength::kFraction - 1 - up + down;
  if (focal_bits_ < -30 || focal_bits_ > 21) return Status::kInvalidArgument;
  constexpr auto kNear = ObjectLength::from_raw(kParallel);
  constexpr auto kFar = ObjectLength::from_raw(kParallel + 1);
  return ClipTransform::make({Rotation::identity(), {}}, {PixelLength::from_raw(1), kNear, kFar}, viewport,
                             lens_);
}

}  // namespace arcspan
