// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/status.hpp>
#include <arcspan/vertex/placement.hpp>

#include <cstdint>

/// The reasons for which constants of transforms and cameras do not compile.
namespace arcspan {

namespace detail {

// The reasons of ClipTransform::of() and Camera::of().
namespace refused {
void picture_side_outside_1_to_2048();
void focal_length_not_above_0();
void translation_beyond_2_to_the_22();
}  // namespace refused

inline constexpr std::int32_t kMostPictureSide = 2048;

[[nodiscard]] constexpr bool is_picture_size(const Viewport& viewport) {
  constexpr std::int32_t kMost = kMostPictureSide;
  return viewport.width >= 1 && viewport.height >= 1 && viewport.width <= kMost && viewport.height <= kMost;
}

constexpr void refuse_transform(const Projection& projection, const Viewport& viewport) {
  const bool ordered = projection.near_plane.raw() > 0 && projection.far_plane > projection.near_plane;
  if (!is_picture_size(viewport)) refused::picture_side_outside_1_to_2048();
  if (projection.focal.raw() <= 0) refused::focal_length_not_above_0();
  if (!ordered) refused::near_plane_not_between_0_and_far_plane();
  if (ordered) refused::translation_beyond_2_to_the_22();
}

}  // namespace detail

}  // namespace arcspan
