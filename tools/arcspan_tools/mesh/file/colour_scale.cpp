// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/colour_scale.hpp>

#include <algorithm>

namespace arcspan::tools {

std::vector<std::optional<Vec3>> scaled_colours(std::vector<std::optional<Vec3>> colours) {
  bool any = false;
  double scale = 1;
  for (const std::optional<Vec3>& c : colours) {
    any = any || c.has_value();
    if (c && std::max({c->x, c->y, c->z}) > 1) scale = 1.0 / 255;
  }
  if (!any) return {};
  const auto scaled = [scale](double v) { return std::clamp(v * scale, 0.0, 1.0); };
  for (std::optional<Vec3>& c : colours) {
    if (c) c = Vec3{scaled(c->x), scaled(c->y), scaled(c->z)};
  }
  return colours;
}

}  // namespace arcspan::tools
