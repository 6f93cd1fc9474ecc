// SPDX-License-Identifier: MIT
#include <arcspan_tools/fixed_point/material.hpp>
#include <arcspan_tools/mesh/file/triangle_colours.hpp>
#include <arcspan_tools/output/palette.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace arcspan::tools {
namespace {

Rgb8 mean(const TriangleColour& colour) {
  return to_rgb8((colour.corners[0] + colour.corners[1] + colour.corners[2]) * (1.0 / 3));
}

bool differs(const TriangleColour& colour) {
  const Rgb8 first = to_rgb8(colour.corners[0]);
  return to_rgb8(colour.corners[1]) != first || to_rgb8(colour.corners[2]) != first;
}

Vec3 to_vec3(Rgb8 c) { return Vec3{double(c.r), double(c.g), double(c.b)} * (1.0 / 255); }

/// Gives triangles that have different colours in their corners, and others of their look, corners with
/// colours in place of RawModel::colours.
void keep_colours(RawModel& model) {
  std::set<std::uint32_t> differing;
  for (std::size_t i = 0; i < model.colours.size(); ++i) {
    if (model.colours[i].known && differs(model.colours[i])) differing.insert(model.look_of[i]);
  }
  std::map<std::uint32_t, std::uint32_t> white;  // looks in place of others
  for (std::size_t i = 0; i < model.colours.size(); ++i) {
    const std::uint32_t old = model.look_of[i];
    if (!model.colours[i].known || differing.count(old) == 0) continue;
    model.colours[i].known = false;
    for (std::size_t k = 0; k < 3; ++k) {
      model.mesh.triangles[i][k].colour = to_rgb8(model.colours[i].corners[k]);
    }
    const auto [at, is_new] = white.try_emplace(old, static_cast<std::uint32_t>(model.looks.size()));
    if (is_new) {
      PartLook look = model.looks[old];
      look.material.colour = Vec3{1, 1, 1};
      look.material.ambient_colour.reset();
      model.looks.push_back(std::move(look));
    }
    model.look_of[i] = at->second;
  }
}

/// The means of all triangles as a picture of one row, which is what a palette is made for.
Image means(const std::vector<TriangleColour>& colours) {
  Image row;
  for (const TriangleColour& colour : colours) {
    if (colour.known) row.pixels.push_back(mean(colour));
  }
  row.width = static_cast<std::int32_t>(row.pixels.size());
  row.height = 1;
  return row;
}

void warn_of(RawModel& model, const std::vector<TriangleColour>& colours, const Image& row,
             const Palette& palette) {
  const auto differing = std::count_if(colours.begin(), colours.end(), [](const TriangleColour& colour) {
    return colour.known && differs(colour);
  });
  if (differing > 0) {
    model.warnings.push_back("vertex colours that differ within a triangle are drawn as their mean (" +
                             std::to_string(differing) + " triangles)");
  }
  const auto is_kept = [&palette](Rgb8 colour) {
    const std::vector<Rgb8>& kept = palette.colours();
    return std::find(kept.begin(), kept.end(), colour) != kept.end();
  };
  if (!std::all_of(row.pixels.begin(), row.pixels.end(), is_kept)) {
    model.warnings.push_back("of its colours, the nearest of " + std::to_string(palette.colours().size()) +
                             " are drawn");
  }
}

}  // namespace

void apply_colours(RawModel& model, VertexColours choice) {
  if (choice == VertexColours::kKept) keep_colours(model);
  const std::vector<TriangleColour> colours = std::move(model.colours);
  model.colours.clear();
  const Image row = means(colours);
  if (row.pixels.empty()) return;
  Palette palette(std::span(&row, 1));
  warn_of(model, colours, row, palette);
  std::map<std::pair<std::uint32_t, std::uint8_t>, std::uint32_t> looks;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    if (!colours[i].known) continue;
    const std::uint32_t old = model.look_of[i];
    const std::uint8_t index = palette.index(mean(colours[i]));
    const auto next = static_cast<std::uint32_t>(model.looks.size());
    const auto [at, is_new] = looks.try_emplace({old, index}, next);
    if (is_new) {
      PartLook look = model.looks[old];
      look.material.colour = to_vec3(palette.colours()[index]);
      look.material.ambient_colour.reset();
      model.looks.push_back(std::move(look));
    }
    model.look_of[i] = at->second;
  }
}

}  // namespace arcspan::tools
