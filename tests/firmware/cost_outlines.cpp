// SPDX-License-Identifier: MIT
// Finds, inks and smooths the outlines of the jobs that the emulator has loaded, for
// scripts/simulate-estimates. Drawing is not measured. In whole pictures sides are noted while drawing, so
// finding them is not measured either; in bands they are those of the rows that drawing keeps.
#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/ink_outlines.hpp>
#include <arcspan/outline/curved_outlines.hpp>
#include <arcspan/smooth_outlines.hpp>

#include <tests/firmware/cost_jobs.hpp>

namespace {

using namespace arcspan;

[[gnu::section(".bss.frame")]] TriangleSide sides[20000];
[[gnu::section(".bss.frame")]] OutlineEdge edges[40000];
[[gnu::section(".bss.frame")]] OutlineGap<Rgb565> gaps[60000];
[[gnu::section(".bss.frame")]] CurveMemory<2000> curve_memory;

template <class Work>
Status measured(std::uint32_t number, const Work& work) {
  arcspan_mark();
  const Status status = work();
  arcspan_mark();
  bare::print_line("section: job ", number);
  bare::print_line("section: between");
  return status;
}

Status find(std::uint32_t number, const CostJob& job, const CostMethod::Lighting& lighting,
            OutlineList& outlines, CurvedOutlines& curves) {
  const bool in_bands = job.head.band_rows < job.head.height;
  VertexCache<CostMethod> cache(cost_cache, in_bands ? std::span(cost_rows) : std::span<TriangleRows>());
  const auto sides_found = [&] {
    return find_sides<CostMethod>(job.mesh, job.transform, lighting, cache, sides);
  };
  Status status = sides_found();
  if (ok(status) && in_bands) status = measured(number, sides_found);
  if (!ok(status)) return status;
  const VertexPositions positions(job.transform, std::span<const CachedVertex<CostMethod>>(cost_cache));
  return measured(number, [&] {
    return (job.head.outlines >> 16) != 0 ? curves.add(job.mesh, job.neighbours, positions, sides, outlines)
                                          : outlines.add(job.mesh, job.neighbours, positions, sides);
  });
}

bool draw(std::uint32_t number, const CostJob& job, const CostMethod::Lighting& lighting) {
  OutlineList outlines(edges);
  CurvedOutlines curves(curve_memory);
  if (!ok(find(number, job, lighting, outlines, curves))) return false;
  const OutlineInk ink{{}, static_cast<std::uint8_t>(job.head.outlines), (job.head.outlines & 256) != 0};
  const auto width = static_cast<std::int32_t>(job.head.width);
  const auto height = static_cast<std::int32_t>(job.head.height);
  const auto rows = static_cast<std::int32_t>(job.head.band_rows);
  const std::int32_t margin = rows == height ? 0 : ink.width != 0 && ink.creases ? 2 : 1;
  hal::Framebuffer<Rgb565> band(cost_colours, width, rows + 2 * margin);
  DepthBuffer depth(cost_depths, width, rows + 2 * margin);
  for (std::int32_t top = 0; top < height; top += rows) {
    band.move_to(top < margin ? 0 : top - margin);
    depth.move_to(top < margin ? 0 : top - margin);
    band.clear({0, 0, 0});
    depth.clear();
    for (const MeshView& mesh : {job.mesh, curves.mesh()}) {
      if (!ok(draw_mesh<CostMethod>(mesh, job.transform, lighting, band, depth, cost_cache).status))
        return false;
    }
    Status status = Status::kOk;
    if (ink.width != 0)
      status = measured(number, [&] { return ink_outlines(outlines, ink, band, depth, gaps); });
    if (ok(status)) status = measured(number, [&] { return smooth_outlines(outlines, band, depth, gaps); });
    if (!ok(status)) return false;
  }
  return true;
}

}  // namespace

int main() { return draw_cost_jobs(draw) ? 0 : 1; }
