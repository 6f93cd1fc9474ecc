// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/bare/stack.hpp>

#include <tests/firmware/cost_figure.hpp>
#include <tests/firmware/cost_method.hpp>
#include <tests/frames/stage_set.hpp>

namespace arcspan {

/// Draws a figure of small triangles: 240x320, turned by 30 degrees, without face planes, because a figure
/// that moves has none.
inline bool draw_cost_character() {
  constexpr std::int32_t kWidth = 240;
  constexpr std::int32_t kHeight = 320;
  static scenes::StageSet stage;
  MeshView mesh;
  if (!ok(scenes::set_character_stage({kWidth, kHeight}, stage)) || !make_character_mesh(mesh)) return false;
  const auto& lighting = make_cost_lighting(stage.light);
  CostSink frame(cost_colours, kWidth, kHeight);
  DepthBuffer depth(cost_depths, kWidth, kHeight);
  frame.clear({0, 0, 0});
  depth.clear();
  bare::paint_stack();
  arcspan_mark();
  const DrawResult drawn = draw_mesh<CostMethod>(mesh, stage.transform, lighting, frame, depth, cost_cache);
  arcspan_mark();
  const std::uint32_t depth_here = bare::stack_depth();
  bare::print_line("section: draw character");
  bare::print_line("section: between");
  bare::print_line("stack: draw character ", bare::deepest_stack() - depth_here);
  bare::print_line("drawn: draw character ", drawn.triangles);
  std::uint32_t lit = 0;
  std::uint32_t hash = 2166136261u;
  for (std::int32_t i = 0; i < kWidth * kHeight; ++i) {
    lit += cost_colours[i] != 0 ? 1 : 0;
    hash = (hash ^ cost_colours[i]) * 16777619u;
  }
  bare::print_line("lit: ", lit, " hash: ", hash);
  return ok(drawn.status);
}

}  // namespace arcspan
