// SPDX-License-Identifier: MIT
#include <arcspan/vertex/band_planes.hpp>

#include <bit>

namespace arcspan {

namespace {

constexpr int kFormBits = 13;                                   // magnitude of a form's entries
constexpr std::int64_t kLargestOffset = std::int64_t{1} << 30;  // more than a form's other terms add up to

std::int64_t magnitude(std::int64_t v) { return v < 0 ? -v : v; }

/// The form sign * (2^14 y - k w) of the clip-space position of a vertex, divided by a positive power of two
/// and lowered by more than its errors. It is positive only where sign * (Y - k) is, with Y = 2^14 y / w, the
/// row in sixteenths before rounding. |k| is below 2^15.
ObjectForm form_beyond(const ClipTransform& transform, std::int64_t k, std::int64_t sign,
                       std::uint16_t radius) {
  std::int64_t entries[3];  // below 2^43
  std::int64_t largest = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    entries[j] = sign * (transform.entry(1, j) * (std::int64_t{1} << 14) - k * transform.entry(2, j));
    if (magnitude(entries[j]) > largest) largest = magnitude(entries[j]);
  }
  const int bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(largest)));
  const int shift = bits > kFormBits ? bits - kFormBits : 0;
  const auto scaled = [shift](std::int64_t v) { return static_cast<std::int32_t>(v >> shift); };
  // Entries have 14 fraction bits more than offsets, which are below 2^30. The sum is below 2^60.
  const std::int64_t at_origin = sign *
                                 (transform.offset(1) * (std::int64_t{1} << 14) - k * transform.offset(2)) *
                                 (std::int64_t{1} << 14);
  // Each entry is rounded down by less than 1, which changes the form by less than the sum of the
  // coordinates' magnitudes, at most sqrt(3) * radius.
  const std::int64_t offset = (at_origin >> shift) - 2 * std::int64_t{radius} - 1;
  const std::int64_t clamped = offset > kLargestOffset    ? kLargestOffset
                               : offset < -kLargestOffset ? -kLargestOffset
                                                          : offset;
  return {scaled(entries[0]), scaled(entries[1]), scaled(entries[2]), static_cast<std::int32_t>(clamped)};
}

/// True if the form is positive within the whole sphere of `radius` around the origin.
bool is_positive_within(std::uint16_t radius, const ObjectForm& form) {
  if (form.offset <= 0) return false;
  const auto square = [](std::int32_t v) { return static_cast<std::uint64_t>(std::int64_t{v} * v); };
  const std::uint64_t gradient2 = square(form.x) + square(form.y) + square(form.z);  // below 2^28
  return square(form.offset) > gradient2 * (std::uint32_t{radius} * std::uint32_t{radius});
}

}  // namespace

void BandPlanes::set(const ClipTransform& transform, std::int32_t first, std::int32_t end,
                     std::uint16_t radius) {
  const Viewport& viewport = transform.viewport();
  const std::int32_t middle = viewport.height >> 1;
  const std::int32_t odd = (viewport.height & 1) * 8;
  // A vertex at y sixteenths is above the band if y <= 16 first - 8, where first_row_at(y) <= first, and
  // below it if y >= 16 end - 7. One sixteenth more is for its rounding and its error.
  const ObjectForm above = form_beyond(transform, 16 * (first - middle) + 7 - odd, -1, radius);
  const ObjectForm below = form_beyond(transform, 16 * (end - middle) - 6 - odd, 1, radius);
  first_tested_ = below.offset > above.offset ? below : above;
  second_tested_ = below.offset > above.offset ? above : below;
  known_ = true;
  excludes_all_ = is_positive_within(radius, first_tested_) || is_positive_within(radius, second_tested_);
}

}  // namespace arcspan
