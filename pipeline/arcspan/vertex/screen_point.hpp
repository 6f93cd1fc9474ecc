// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstdint>

namespace arcspan {

/// Where a point appears in a picture: for labels, leader lines and lens flares.
struct ScreenPoint {
  /// Pixels from the left and from the upper side of the picture, 4 fraction bits: column c is c ... c + 1,
  /// its centre c + 1/2. Outside of the guard band they saturate at kGuardBand pixels from the middle. 0
  /// unless `in_front`.
  Subpixel x{};
  Subpixel y{};
  std::uint16_t depth = 0;  ///< as a DepthBuffer has it, nearer is smaller; 0 unless `in_front`
  bool in_front = false;    ///< at least as far away as the near plane; perhaps beyond the far plane
  bool in_picture = false;  ///< in front, and in a pixel of the picture

  /// The pixel that contains the point.
  [[nodiscard]] constexpr std::int32_t column() const { return x.raw() >> Subpixel::kFraction; }
  [[nodiscard]] constexpr std::int32_t row() const { return y.raw() >> Subpixel::kFraction; }

  friend constexpr bool operator==(const ScreenPoint&, const ScreenPoint&) = default;
};

/// Returns where `point` of an object appears, bit for bit where draw_mesh() puts a vertex at that position.
[[nodiscard]] ScreenPoint screen_point(const ClipTransform& transform, const ObjectPosition& point);

}  // namespace arcspan
