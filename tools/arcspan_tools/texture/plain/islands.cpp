// SPDX-License-Identifier: MIT
#include <arcspan_tools/texture/plain/islands.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace arcspan::tools {
namespace {

/// A range of columns or rows.
struct Range {
  double least = INFINITY;
  double most = -INFINITY;

  void include(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  [[nodiscard]] double size() const { return std::min(most - least, 1.0); }
};

/// Sets that are joined.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  [[nodiscard]] std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> parent_;
};

/// The numbers of a mesh's vertices, alike for those that differ by their normals only.
std::vector<std::size_t> places_of(const FixedMesh& mesh) {
  std::map<std::array<std::int32_t, 5>, std::size_t> known;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const ObjectPosition& p = mesh.positions[i];
    const TexturePoint& t = mesh.texture_points[i];
    places.push_back(known.try_emplace({p.x, p.y, p.z, t.u, t.v}, known.size()).first->second);
  }
  return places;
}

/// Triangles belong to one island if they have an edge in common, on the surface and in the texture.
IslandSize islands_of(const FixedMesh& mesh) {
  const std::vector<std::size_t> places = places_of(mesh);
  Groups islands(mesh.indices.size() / 3);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> edges;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t a = places[mesh.indices[i]];
    const std::size_t b = places[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
    const auto [at, is_new] = edges.try_emplace(std::minmax(a, b), i / 3);
    if (!is_new) islands.join(i / 3, at->second);
  }
  std::map<std::size_t, std::pair<Range, Range>> ranges;
  const double unit = std::ldexp(1, -mesh.texture_scale.fraction_bits);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const TexturePoint& t = mesh.texture_points[mesh.indices[i]];
    auto& [u, v] = ranges[islands.of(i / 3)];
    u.include(t.u * unit);
    v.include(t.v * unit);
  }
  IslandSize least;
  for (const auto& [island, range] : ranges) least.include({range.first.size(), range.second.size()});
  return least;
}

/// The columns and rows of the pixels that are connected with one, which is removed from `open` with them.
std::pair<Range, Range> take_region(std::vector<bool>& open, std::int32_t width, std::size_t first) {
  const auto height = static_cast<std::int32_t>(open.size()) / width;
  std::pair<Range, Range> region;
  std::vector<std::size_t> next{first};
  open[first] = false;
  while (!next.empty()) {
    const auto x = static_cast<std::int32_t>(next.back()) % width;
    const auto y = static_cast<std::int32_t>(next.back()) / width;
    next.pop_back();
    region.first.include(x);
    region.second.include(y);
    for (std::int32_t row = std::max(y - 1, 0); row <= std::min(y + 1, height - 1); ++row) {
      for (std::int32_t column = std::max(x - 1, 0); column <= std::min(x + 1, width - 1); ++column) {
        const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(column);
        if (!open[at]) continue;
        open[at] = false;
        next.push_back(at);
      }
    }
  }
  return region;
}

}  // namespace

void IslandSize::include(const IslandSize& other) {
  width = std::min(width, other.width);
  height = std::min(height, other.height);
}

IslandSize islands_of(const FixedModel& model, const FileTexture& texture) {
  IslandSize least;
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    if (model.looks[i].material.texture.get() == &texture && !model.meshes[i].texture_points.empty())
      least.include(islands_of(model.meshes[i]));
  }
  return least;
}

IslandSize islands_of(const RgbaImage& picture) {
  std::vector<bool> open;
  for (const Rgba8 c : picture.pixels) open.push_back(c.a >= 128);
  IslandSize least;
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (!open[i]) continue;
    const auto [columns, rows] = take_region(open, picture.width, i);
    // From the middle of the first texel to that of the last one.
    const double across = columns.most - columns.least;
    const double down = rows.most - rows.least;
    if (across < 1 || down < 1) continue;
    const auto part = [](double extent, std::int32_t side) { return extent < side - 1 ? extent / side : 1; };
    least.include({part(across, picture.width), part(down, picture.height)});
  }
  return least;
}

std::uint8_t levels_with_islands(const TextureSize& size, const IslandSize& least) {
  const auto levels = [&size](double part, int bits) {
    if (part >= 1) return int{size.levels};
    const double texels = part * (1 << bits) + 1;
    return std::clamp(static_cast<int>(std::floor(std::log2(texels / 2))) + 1, 1, int{size.levels});
  };
  return static_cast<std::uint8_t>(
      std::min(levels(least.width, size.width_bits), levels(least.height, size.height_bits)));
}

}  // namespace arcspan::tools
