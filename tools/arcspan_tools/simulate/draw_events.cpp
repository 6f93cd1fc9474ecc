// SPDX-License-Identifier: MIT
#include <arcspan_tools/simulate/draw_events.hpp>

namespace arcspan::tools {
namespace {

void add(const std::string& name, double amount, std::vector<CostTerm>& terms) {
  if (amount != 0) terms.push_back({name, amount});
}

void add_paths(const std::string& kind, const std::array<DrawEvents::Path, DrawEvents::kPaths>& paths,
               std::vector<CostTerm>& terms) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    std::string name(kind);
    name += ' ';
    name += std::to_string(i);
    name += ' ';
    add(name + "triangle", paths[i].triangles, terms);
    add(name + "span", paths[i].spans, terms);
    add(name + "pixel", paths[i].pixels, terms);
    add(name + "written", paths[i].written, terms);
    add(name + "segment", paths[i].segments, terms);
  }
}

}  // namespace

std::vector<CostTerm> DrawEvents::terms() const {
  std::vector<CostTerm> terms;
  add("call", calls, terms);
  add("vertex", vertices, terms);
  add("wanted vertex", wanted_vertices, terms);
  add("forgotten vertex", forgotten, terms);
  add("shaded vertex", shaded_vertices, terms);
  add("face", faces, terms);
  add("plane", planes, terms);
  add("row triangle", row_triangles, terms);
  add("row front", row_fronts, terms);
  add("row entry", row_entries, terms);
  add("batch", batches, terms);
  add("triangle", triangles, terms);
  add("facing triangle", facing, terms);
  add("front", fronts, terms);
  add("facing front", facing_fronts, terms);
  add("clipped triangle", clipped, terms);
  add("clip step", clip_steps, terms);
  add("clip cut", clip_cuts, terms);
  add("clip corner", clip_corners, terms);
  add("triangle in view", in_view, terms);
  add("back", backs, terms);
  add("small row", small_rows, terms);
  add("small empty", small_empty, terms);
  add("small rowless", small_rowless, terms);
  add("small halves", small_halves, terms);
  add("small dark", small_dark, terms);
  add("small levelled", small_levelled, terms);
  add("small refused", refused, terms);
  add("row", rows, terms);
  add("half", halves, terms);
  add("edge", edges, terms);
  add("dark triangle", dark, terms);
  add("levelled triangle", levelled, terms);
  add("perspective edge", perspective_edges, terms);
  add("perspective triangle", perspective_triangles, terms);
  add("perspective span", perspective_spans, terms);
  add("piece", pieces, terms);
  add("new level", new_levels, terms);
  add("masked texel", masked, terms);
  add("shiny pixel", shiny, terms);
  add("tinted pixel", tinted, terms);
  add_paths("small", small, terms);
  add_paths("path", large, terms);
  add_paths("perspective", perspective, terms);
  return terms;
}

}  // namespace arcspan::tools
