// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/check_transform.hpp>
#include <arcspan/vertex/placement.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// Half the width of the guard band is 2^kGuardBits pixels: projected vertices are less than that far from
/// the viewport's middle in x and in y, so that differences of two are below 2^(kGuardBits + 1). Everything
/// that depends on the guard band follows from this constant. What limits it:
///
///   what                            needs                                    allows, at most
///   RasterPosition                  coordinates in sixteenths in 16 bits     11 bits
///   doubled_area()                  its products of differences in 32 bits   10 bits
///   divide(), Reciprocal::times()   heights in sixteenths below 2^15         10 bits
///   EdgeWalk                        exact columns over all rows              10 bits
///   Linear                          errors of gradients below 1/8 per row    10 bits
///   TriangleCommand, SmallSpan      rows and columns in 16 bits              14 bits
///
/// Smaller values clip more triangles, and allow smaller pictures: up to 2 * kGuardBand pixels in each
/// direction.
inline constexpr int kGuardBits = 10;
inline constexpr std::int32_t kGuardBand = std::int32_t{1} << kGuardBits;
static_assert(kGuardBits + Subpixel::kFraction <= 15, "RasterPosition has 16 bits");
static_assert(2 * (kGuardBits + 1 + Subpixel::kFraction) <= 30, "doubled_area() has 32 bits");
static_assert(kGuardBits + 1 + Subpixel::kFraction <= 15, "detail::divide() takes heights below 2^15");
static_assert(kGuardBits - 1 <= Linear::kFraction - 3,
              "half a unit of Linear per pixel adds up to more than 1/8");

namespace detail {

/// An entry of a matrix, below 2^28 in magnitude, for cores with a long multiply.
struct WholeEntry {
  std::int32_t raised;  ///< times 2^3, so that scaled_sum() needs the upper half of a sum only

  WholeEntry() = default;
  constexpr explicit WholeEntry(std::int32_t entry) : raised(wrap_shl(entry, kRaise)) {}
  [[nodiscard]] constexpr std::int64_t value() const { return raised >> kRaise; }
  static constexpr int kRaise = 3;
  friend constexpr bool operator==(const WholeEntry&, const WholeEntry&) = default;
};

/// The same as high * 2^14 + low: `high` has 15 bits with the sign and `low` 14, so that sums of three
/// products with 16-bit positions fit 32 bits. On cores with registers of 8 bits it is half as large.
struct SplitEntry {
  std::int_fast16_t high;
  std::int_fast16_t low;

  SplitEntry() = default;
  constexpr explicit SplitEntry(std::int32_t entry)
      : high(static_cast<std::int_fast16_t>(entry >> 14)),
        low(static_cast<std::int_fast16_t>(entry & 0x3FFF)) {}
  [[nodiscard]] constexpr std::int64_t value() const { return std::int64_t{high} * (1 << 14) + low; }
  friend constexpr bool operator==(const SplitEntry&, const SplitEntry&) = default;
};

using MatrixEntry = std::conditional_t<kHasLongMultiply, WholeEntry, SplitEntry>;

/// Returns the product of a row and a position, divided by 2^14 and rounded down, modulo 2^32. Both functions
/// return the same bits.
[[nodiscard]] constexpr std::int32_t scaled_sum(const WholeEntry (&row)[3], ObjectPosition p) {
  const auto product = [](const WholeEntry& entry, std::int32_t coordinate) {
    return std::int64_t{entry.raised} *
           (coordinate * (std::int32_t{1} << (32 - 14 - WholeEntry::kRaise)));  // up to 2^61
  };
  return static_cast<std::int32_t>((product(row[0], p.x) + product(row[1], p.y) + product(row[2], p.z)) >>
                                   32);
}
[[nodiscard]] constexpr std::int32_t scaled_sum(const SplitEntry (&row)[3], ObjectPosition p) {
  const auto product = [](std::int_fast16_t half, std::int32_t coordinate) {
    return wrap_mul(static_cast<std::int32_t>(half), coordinate);
  };
  const std::int32_t high =
      wrap_add(wrap_add(product(row[0].high, p.x), product(row[1].high, p.y)), product(row[2].high, p.z));
  const std::int32_t low = product(row[0].low, p.x) + product(row[1].low, p.y) + product(row[2].low, p.z);
  return wrap_add(high, low >> 14);
}

}  // namespace detail

/// A vertex in clip space, before the division by w; y points down. It is inside the guard band if |x| <= w
/// and |y| <= w, and between the near and the far plane if w is within ClipTransform::w_range(). The three
/// have the same scale (ClipTransform::w_bits()) and are below 2^30 in magnitude.
struct ClipPosition {
  std::int32_t x;
  std::int32_t y;
  std::int32_t w;
};

/// The w between the near and the far plane, both ends included; 1...2^30. The farthest is rounded up.
struct WRange {
  std::int32_t nearest = 1;
  std::int32_t farthest = 1;

  friend constexpr bool operator==(const WRange&, const WRange&) = default;
};

/// A point in object units that may lie outside the range of vertices: |coordinate| < 2^24.
struct ObjectPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;

  friend constexpr bool operator==(const ObjectPoint&, const ObjectPoint&) = default;
};

/// The transform from object space to clip space, and the depth of a clip-space vertex. Made once per object
/// and frame.
class ClipTransform {
 public:
  constexpr ClipTransform() = default;

  friend constexpr bool operator==(const ClipTransform&, const ClipTransform&) = default;

  /// Returns kInvalidArgument, and does not change `transform`, if the viewport's size is not 1...2048, the
  /// focal length not above 0, the planes not 0 < near < far, or a translation above 2^22 units in magnitude.
  /// Depths are less steep than the planes allow where far / (far - near) is above 4128.
  static constexpr Status make(const Placement& placement, const Projection& projection,
                               const Viewport& viewport, ClipTransform& transform);

  /// make() as a constant, which can lie in flash. Arguments that make() rejects do not compile.
  [[nodiscard]] static consteval ClipTransform of(const Placement& placement, const Projection& projection,
                                                  const Viewport& viewport) {
    ClipTransform transform;
    if (!ok(make(placement, projection, viewport, transform))) {
      detail::refuse_transform(projection, viewport);
    }
    return transform;
  }

  /// Changes the placement, the planes and the focal length. The viewport and the ratio of the far plane to
  /// the near one, from which depths are computed, stay. For objects of different scale before one camera.
  constexpr void set_placement(const WidePlacement& placement);
  /// Takes the viewport and the depths of another transform.
  constexpr void set_lens(const ClipTransform& other) {
    viewport_ = other.viewport_;
    rounding_[0] = other.rounding_[0];
    rounding_[1] = other.rounding_[1];
    depth_range_ = other.depth_range_;
    depth_shift_ = other.depth_shift_;
  }

  /// The clip-space position of a vertex.
  [[nodiscard]] constexpr ClipPosition operator()(ObjectPosition p) const {
    const auto row = [&](int i) { return wrap_add(detail::scaled_sum(matrix_[i], p), offset_[i]); };
    return {row(0), row(1), row(2)};
  }

  /// w of points that the near and the far plane do not cut off.
  [[nodiscard]] constexpr const WRange& w_range() const { return w_range_; }
  /// w of the near plane.
  [[nodiscard]] constexpr std::int32_t near_w() const { return w_range_.nearest; }
  /// The camera's position in object space; (2^23, 0, 0) if set_placement() was given unit bits above 0.
  [[nodiscard]] constexpr const ObjectPoint& eye() const { return eye_; }
  /// The focal length that make() was given. After set_placement() it is times 2^focal_bits.
  [[nodiscard]] constexpr PixelLength focal() const { return focal_; }
  /// The scale of clip space, -4...13: w of a point is its distance before the camera in object units times
  /// 2^w_bits(). Down to -51 if set_placement() was given unit or focal bits.
  [[nodiscard]] constexpr int w_bits() const { return w_bits_; }
  /// The factor of coordinate j (0, 1, 2) in row i of the matrix, for x, y or w (i = 0, 1, 2): below 2^28 in
  /// magnitude, 14 fraction bits more than clip space.
  [[nodiscard]] constexpr std::int64_t entry(std::size_t i, std::size_t j) const {
    return matrix_[i][j].value();
  }
  /// The clip-space coordinate x, y or w (i = 0, 1, 2) of the object's origin.
  [[nodiscard]] constexpr std::int64_t offset(std::size_t i) const { return offset_[i]; }
  /// The squared length of row i of the matrix, below 3 * 2^56; scaled as entry().
  [[nodiscard]] constexpr std::int64_t row_square(std::size_t i) const {
    std::int64_t sum = 0;
    for (std::size_t j = 0; j < 3; ++j) sum += entry(i, j) * entry(i, j);
    return sum;
  }
  [[nodiscard]] constexpr const Viewport& viewport() const { return viewport_; }
  /// The summand that rounds x / w (i = 0) or y / w (i = 1), 29 fraction bits, to a Subpixel when bits are
  /// dropped; half a pixel more where the viewport's size is odd.
  [[nodiscard]] constexpr std::int32_t rounding(std::size_t i) const { return rounding_[i]; }
  /// Upper bounds of the clip-space lengths, in w and in x or y, of an object-space length of at most 56756
  /// (the diagonal of the range of positions).
  [[nodiscard]] constexpr std::int32_t length_ahead(std::uint32_t length) const;
  [[nodiscard]] constexpr std::int32_t length_across(std::uint32_t length) const;
  /// A length of at most 65535 in x or y, rounded down.
  [[nodiscard]] constexpr std::int32_t scaled_across(std::uint32_t length) const;

  /// The depth of a vertex: 16 bits, nearer is smaller, linear on the screen. `near_over_w` is near_w() / w
  /// with 29 fraction bits. The result is clamped to kDepthMargin ... 65535 - kDepthMargin, so that steps
  /// along rows and edges cannot wrap.
  [[nodiscard]] constexpr std::uint16_t depth(std::int32_t near_over_w) const {
    const std::int32_t beyond = (std::int32_t{1} << 29) - near_over_w;
    if (beyond <= 0) return static_cast<std::uint16_t>(kDepthMargin);
    const std::int32_t depth = kDepthMargin + (multiply_high(depth_range_, beyond) >> depth_shift_);
    return static_cast<std::uint16_t>(depth > 65535 - kDepthMargin ? 65535 - kDepthMargin : depth);
  }

  static constexpr std::int32_t kDepthMargin = 256;

 private:
  detail::MatrixEntry matrix_[3][3] = {};
  std::int32_t offset_[3] = {};
  WRange w_range_{};
  std::int32_t depth_range_ = 0;  ///< times 2^-(depth_shift_ - 3)
  std::int32_t rounding_[2] = {};
  Viewport viewport_{};
  ObjectPoint eye_{};
  PixelLength focal_{};
  short depth_shift_ = 0;
  signed char focal_bits_ = 0;
  signed char w_bits_ = 0;
};

}  // namespace arcspan

#include <arcspan/vertex/make_clip_transform.hpp>
