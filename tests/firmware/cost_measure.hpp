// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/bare/stack.hpp>

#include <tests/firmware/cost_method.hpp>
#include <tests/firmware/cost_stage.hpp>

namespace arcspan {

/// Clears and draws, each in a section of its own, whose name ends with the sphere and the number. "stack:"
/// gives the stack that the call used, "drawn:" the visible triangles.
inline bool measure_draw(const char* section, const char* sphere, std::uint32_t number, const MeshView& mesh,
                         const ClipTransform& transform, const CostMethod::Lighting& lighting) {
  hal::Framebuffer<Rgb565> frame(cost_colours, kCostWidth, kCostHeight);
  CostSink sink(cost_colours, kCostWidth, kCostHeight);
  DepthBuffer depth(cost_depths, kCostWidth, kCostHeight);
  bare::paint_stack();
  arcspan_mark();
  frame.clear({0, 0, 0});
  depth.clear();
  arcspan_mark();
  const DrawResult drawn = draw_mesh<CostMethod>(mesh, transform, lighting, sink, depth, cost_cache);
  arcspan_mark();
  const std::uint32_t depth_here = bare::stack_depth();
  bare::print_line("section: clear ", sphere, " ", number);
  bare::print_line("section: ", section, sphere, " ", number);
  bare::print_line("section: between");
  bare::print_line("stack: ", section, sphere, " ", number, " ", bare::deepest_stack() - depth_here);
  bare::print_line("drawn: ", section, sphere, " ", number, " ", drawn.triangles);
  return ok(drawn.status);
}

}  // namespace arcspan
