// SPDX-License-Identifier: MIT
#include <arcspan/vertex/back_faces.hpp>

namespace arcspan {

namespace {

/// How far an object's picture reaches, by the sphere about its origin.
struct SphereView {
  std::int64_t nearest;       ///< w of the sphere's nearest point
  std::int64_t farthest;      ///< and of the other, in object units
  std::int64_t widest_slope;  ///< most |x| / depth or |y| / depth, 16 fraction bits
};

/// v / divisor of what is not negative: unsigned, as the library divides elsewhere, which takes one routine
/// of the run-time library less.
std::int64_t quotient(std::int64_t v, std::int64_t divisor) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(v) / static_cast<std::uint64_t>(divisor));
}

std::int64_t times_power_of_two(std::int64_t v, int bits) {
  return bits >= 0 ? v * (std::int64_t{1} << bits) : v >> -bits;
}

constexpr int kEntryBits = 14;  ///< fraction bits of the matrix' entries beside clip space

/// What a row of the matrix is long at most: its unit, and what rounding and a rotation add to it.
std::int64_t longest_row(std::int64_t unit) { return unit + (unit >> 12) + 2; }

/// Whether a row is no longer: else the rotation is none, and no sphere tells where its vertices are.
bool within(const ClipTransform& transform, int row, std::int64_t unit) {
  return transform.row_square(row) <= longest_row(unit) * longest_row(unit);
}

/// How far a vertex may be from the origin along such a row, with more than its coordinates are off.
std::int64_t reach_along(std::int64_t reach, std::int64_t unit) {
  constexpr std::int64_t kRounding = 16;
  return ((reach * longest_row(unit)) >> kEntryBits) + kRounding;
}

/// False if the sphere may leave the view, or comes so near that a projected vertex is off by more than the
/// 16th part of a subpixel beside its rounding.
bool view_sphere(std::int64_t reach, const ClipTransform& transform, SphereView& view) {
  constexpr std::int64_t kPreciseW = std::int64_t{1} << 22;
  const ClipPosition origin = transform(ObjectPosition{});
  // Clip space has x and y times focal / kGuardBand.
  const std::int64_t focal = transform.focal().raw();
  const std::int64_t unit = std::int64_t{1} << (transform.w_bits() + kEntryBits);
  const std::int64_t unit_across = (focal * unit) >> detail::kGuardBits;
  if (!within(transform, 2, unit) || !within(transform, 0, unit_across) ||
      !within(transform, 1, unit_across)) {
    return false;
  }
  const std::int64_t radius = reach_along(reach, unit);
  view.nearest = origin.w - radius;
  if (view.nearest < transform.near_w() || view.nearest < kPreciseW) return false;
  view.farthest = times_power_of_two(origin.w + radius, -transform.w_bits()) + 1;
  const std::int64_t across = origin.x < 0 ? -std::int64_t{origin.x} : origin.x;
  const std::int64_t along = origin.y < 0 ? -std::int64_t{origin.y} : origin.y;
  const std::int64_t edge = (across > along ? across : along) + reach_along(reach, unit_across);
  if (edge > view.nearest) return false;
  view.widest_slope = quotient(quotient(edge << 16, view.nearest) << detail::kGuardBits, focal);
  return true;
}

/// What no plane's distance from the eye comes to.
constexpr std::int64_t kTooMuch = std::int64_t{1} << 30;

/// Twice as far as a vertex may move by snapping, 2 sqrt(2) * 9/16 of a subpixel, as an altitude in object
/// units times the cosine between the normal and the way to the eye times the distance from it;
/// kTooMuch or more if no triangle may be far enough from edge-on.
std::int64_t snapping_margin(const SphereView& view, PixelLength focal) {
  constexpr std::int64_t kMove = 204;  // 0.0995 pixels in units of PixelLength
  constexpr std::int64_t kWidest = std::int64_t{1} << 20;
  const std::int64_t ahead = quotient(view.farthest * view.farthest * kMove, focal.raw());
  if (ahead >= kTooMuch || view.widest_slope > kWidest) return kTooMuch;
  // sqrt(1 + t^2), t^2 = 2 slope^2, is at most 1 + slope^2.
  const std::int64_t slant = (std::int64_t{1} << 16) + ((view.widest_slope * view.widest_slope) >> 16) + 1;
  return ((ahead + 1) * slant >> 16) + 1;
}

std::int64_t sum_of_magnitudes(const ObjectPoint& p) {
  return detail::magnitude64(p.x) + detail::magnitude64(p.y) + detail::magnitude64(p.z);
}

}  // namespace

BackFaces::BackFaces(const MeshView& mesh, const ClipTransform& transform) {
  constexpr std::int64_t kFarthest = std::int64_t{1} << 22;
  const PlaneScale& scale = mesh.plane_scale();
  SphereView view{};
  if (mesh.planes() == nullptr || !view_sphere(scale.reach, transform, view)) return;
  const std::int64_t away = sum_of_magnitudes(transform.eye());
  const std::int64_t margin = snapping_margin(view, transform.focal());
  if (away > kFarthest || margin >= kTooMuch) return;
  // Half a unit for each byte, one of an offset made with a rounded normal; and what the eye is off by its
  // own rounding and the rotation's.
  const std::int64_t rounding = (away + (std::int64_t{1} << scale.offset_bits)) / 2 + 2;
  const std::int64_t eye_error = 3 * 127 * (2 + (away >> 18));
  const std::int64_t limit = times_power_of_two(margin, scale.normal_bits) + 1 + rounding + eye_error;
  if (limit >= kTooMuch) return;
  planes_ = mesh.planes();
  eye_ = transform.eye();
  offset_ = -(std::int32_t{1} << scale.offset_bits);
  limit_ = -static_cast<std::int32_t>(limit);
}

}  // namespace arcspan
