// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>
#include <arcspan_tools/support/vec3.hpp>

#include <array>
#include <cstdint>

namespace arcspan::tools {

/// A corner of a flat polygon: position in the plane, and the surface's normal there (unit length).
struct PolygonCorner {
  double x = 0;
  double y = 0;
  Vec3 normal;
};

/// The polygon of S1's figure 26.3: Q, R, P, S, counter-clockwise, with a reflex corner at P.
using Quadrilateral = std::array<PolygonCorner, 4>;
[[nodiscard]] Quadrilateral concave_polygon();

/// Interpolation along the polygon's edges and then along each row between two edges: of intensities, or of
/// normals.
enum class ScanLineKind : std::uint8_t { kGouraud, kPhong };

/// A polygon that is shaded as S1 describes it, as a whole and not by triangles, in doubles. Brightness is
/// `diffuse` times the normal's z. `scale`: pixels per unit; the origin is the middle of the picture.
[[nodiscard]] Image draw_by_scan_lines(const Quadrilateral& polygon, ScanLineKind kind, double diffuse,
                                       double scale, std::int32_t width, std::int32_t height);

}  // namespace arcspan::tools
