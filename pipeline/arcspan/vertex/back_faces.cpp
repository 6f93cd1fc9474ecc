// SPDX-License-Identifier: MIT
#include <arcspan/vertex/back_faces.hpp>

namespace arcspan {

namespace {

/// Bounds of an object seen by the camera, from the sphere around its origin.
struct SphereView {
  std::int64_t nearest;       ///< w of the sphere's nearest point
  std::int64_t farthest;      ///< distance of the farthest point before the camera, in object units
  std::int64_t widest_slope;  ///< largest |x| / distance or |y| / distance, 16 fraction bits
  bool may_pass_far;          ///< the sphere reaches beyond the far plane
};

/// v / divisor, rounded down, for v >= 0 and divisor > 0. Unsigned like the library's other divisions, which
/// saves a routine of the compiler's run-time library.
std::int64_t quotient(std::int64_t v, std::int64_t divisor) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(v) / static_cast<std::uint64_t>(divisor));
}

/// v * 2^bits, rounded down.
std::int64_t times_power_of_two(std::int64_t v, int bits) {
  return bits >= 0 ? v * (std::int64_t{1} << bits) : v >> -bits;
}

constexpr int kEntryBits = 14;  ///< fraction bits of the matrix' entries beyond those of clip space

/// The largest length of a row of the matrix: its nominal length `unit` plus the errors of rounding and of a
/// rotation.
std::int64_t longest_row(std::int64_t unit) { return unit + (unit >> 12) + 2; }

/// True if a row is no longer than that. Otherwise the placement's matrix is no rotation, and the sphere does
/// not bound the vertices.
bool within(const ClipTransform& transform, std::size_t row, std::int64_t unit) {
  return transform.row_square(row) <= longest_row(unit) * longest_row(unit);
}

/// A bound of a vertex' distance from the origin along a row, in clip space, larger by more than the error of
/// its coordinates.
std::int64_t distance_along(std::int64_t radius, std::int64_t unit) {
  constexpr std::int64_t kRounding = 16;
  return ((radius * longest_row(unit)) >> kEntryBits) + kRounding;
}

/// Sets `view` for a sphere of `radius` object units around the origin. Returns false if the sphere may leave
/// the view, or comes so near that the error of a projected vertex exceeds a 16th of a subpixel, its rounding
/// excluded.
bool view_sphere(std::int64_t radius, const ClipTransform& transform, SphereView& view) {
  constexpr std::int64_t kPreciseW = std::int64_t{1} << 22;
  const ClipPosition origin = transform(ObjectPosition{});
  // In clip space, x and y are multiplied by focal / kGuardBand.
  const std::int64_t focal = transform.focal().raw();
  const std::int64_t unit = std::int64_t{1} << (transform.w_bits() + kEntryBits);
  const std::int64_t unit_across = (focal * unit) >> detail::kGuardLengthBits;
  if (!within(transform, 2, unit) || !within(transform, 0, unit_across) ||
      !within(transform, 1, unit_across)) {
    return false;
  }
  const std::int64_t depth_radius = distance_along(radius, unit);
  view.nearest = origin.w - depth_radius;
  if (view.nearest < transform.near_w() || view.nearest < kPreciseW) return false;
  view.may_pass_far = origin.w + depth_radius > transform.w_range().farthest;
  view.farthest = times_power_of_two(origin.w + depth_radius, -transform.w_bits()) + 1;
  const std::int64_t across = detail::magnitude64(origin.x);
  const std::int64_t down = detail::magnitude64(origin.y);
  const std::int64_t edge = (across > down ? across : down) + distance_along(radius, unit_across);
  if (edge > view.nearest) return false;
  view.widest_slope = quotient(quotient(edge << 16, view.nearest) << detail::kGuardLengthBits, focal);
  return true;
}

/// True if all vertices are certainly before the far plane. Entries of the matrix lose kDropped bits, so that
/// sums of 32 bits suffice; kError is the most that w changes by that.
bool is_before_far(const MeshView& mesh, const ClipTransform& transform) {
  constexpr int kDropped = 15;
  constexpr std::int64_t kError = std::int64_t{3} << (15 + kDropped - kEntryBits);
  const auto entry = [&](std::size_t j) {
    return static_cast<std::int32_t>(transform.entry(2, j) >> kDropped);
  };
  const std::int32_t m[3] = {entry(0), entry(1), entry(2)};
  const auto most = static_cast<std::int32_t>((transform.w_range().farthest - transform.offset(2) - kError) >>
                                              (kDropped - kEntryBits));
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const ObjectPosition& p = mesh.position(i);
    if (m[0] * p.x + m[1] * p.y + m[2] * p.z > most) return false;
  }
  return true;
}

/// More than any plane's distance from the eye, in its own units.
constexpr std::int64_t kTooMuch = std::int64_t{1} << 30;

/// The least product of a triangle's altitude (object units), the cosine between its normal and the direction
/// to the eye, and the eye's distance (object units) with which the triangle keeps its side when its vertices
/// snap to the raster. It stands for twice the distance that snapping moves a vertex, 2 sqrt(2) * 9/16 of a
/// subpixel. kTooMuch or more if no triangle can be far enough from edge-on.
std::int64_t snapping_margin(const SphereView& view, PixelLength focal) {
  constexpr std::int64_t kMove = 204;  // 0.0995 pixels, as a PixelLength
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
  const std::int64_t away = sum_of_magnitudes(transform.eye());
  SphereView view{};
  if (mesh.planes() == nullptr || away > kFarthest || !view_sphere(scale.radius, transform, view)) return;
  // A far plane close behind an object cuts the sphere, but no vertex. Looking at all vertices costs less
  // than drawing without planes.
  if (view.may_pass_far && !is_before_far(mesh, transform)) return;
  const std::int64_t margin = snapping_margin(view, transform.focal());
  if (margin >= kTooMuch) return;
  // Bytes of a plane are rounded by half a unit each, its offset by one more, being made of a rounded normal.
  // The eye has the error of its own rounding and that of the rotation's.
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
