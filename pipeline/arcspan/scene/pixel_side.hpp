// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/scene/scene_frame.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// The side of a pixel's column (or row) that a vertex lies on. The plane through the eye and the middle of
/// the column is a linear function of the position, so that vertices need not be transformed: a triangle
/// whose vertices all lie on one side has no pixel in the column. Near the middle, within a tolerance for all
/// that rounding may move a vertex, a vertex lies on neither side.
///
/// |f| < 2^31 for all positions: the coefficients add up to at most 2^14, and the tolerance is below 2^28.
struct PixelSide {
  std::int32_t x;
  std::int32_t y;
  std::int32_t z;
  std::int32_t at;    ///< at the origin, plus the tolerance
  std::int32_t band;  ///< twice the tolerance

  /// 1 on the side of lower columns, 2 on the other side, 0 near the middle.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t operator()(const ObjectPosition& p) const {
    const std::int32_t f = at + x * p.x + y * p.y + z * p.z;
    return (static_cast<std::uint32_t>(f) >> 31) | ((static_cast<std::uint32_t>(band - f) >> 31) << 1);
  }
};

/// The axes of the picture, as rows of ClipTransform.
enum class PictureAxis : std::uint8_t { kColumns = 0, kRows = 1 };

/// Makes the PixelSide of a column or row of the picture for the object of `slot`. The tolerance is 1/8 of a
/// pixel, and a pixel more if `edges` are drawn.
[[nodiscard]] PixelSide make_pixel_side(const SceneSlot& slot, PictureAxis axis, std::int32_t pixel,
                                        bool edges);

}  // namespace arcspan::detail
