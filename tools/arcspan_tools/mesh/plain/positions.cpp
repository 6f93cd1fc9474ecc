// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/positions.hpp>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace arcspan::tools {

Positions positions_of(const std::vector<Vec3>& vertices) {
  const auto key = [&vertices](std::uint32_t i) {
    const Vec3& p = vertices[i];
    return std::tie(p.x, p.y, p.z);
  };
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&key](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  Positions found;
  found.ids.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || key(order[i - 1]) != key(order[i])) found.points.push_back(vertices[order[i]]);
    found.ids[order[i]] = static_cast<std::uint32_t>(found.points.size() - 1);
  }
  return found;
}

}  // namespace arcspan::tools
