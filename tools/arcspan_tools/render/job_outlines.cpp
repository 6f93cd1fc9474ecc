// SPDX-License-Identifier: MIT
#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/pixel/pixel_format_list.hpp>
#include <arcspan/shading/unlit.hpp>

#include <arcspan_tools/render/job_outlines.hpp>

#include <numeric>

namespace arcspan::tools {

bool can_smooth(const PixelChoice& pixels) {
#define ARCSPAN_IF_CHOSEN(name, Format) \
  if (pixels.format == #name) return arcspan::detail::kCanBlend<Format>;
  ARCSPAN_FOR_EACH_PIXEL_FORMAT(ARCSPAN_IF_CHOSEN)
#undef ARCSPAN_IF_CHOSEN
  return false;
}

JobOutlines::JobOutlines(const RenderJob& job) : look_(job.outlines) {
  const double start = processor_milliseconds();
  std::vector<std::size_t> edges;  // of each group, at most; a crease is two
  const auto begins = [&job](std::size_t i) { return i == 0 || is_blended(job.parts[i].transparency); };
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    if (begins(i)) edges.push_back(0);
    edges.back() += 3 * job.parts[i].neighbours.triangle_count();
  }
  if (std::accumulate(edges.begin(), edges.end(), std::size_t{0}) == 0) return;
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    if (begins(i)) groups_.emplace_back(edges[groups_.size()]);
    add(job, i, groups_.back());
  }
  find_milliseconds_ = processor_milliseconds() - start;
}

void JobOutlines::add(const RenderJob& job, std::size_t part, OutlinedParts& group) {
  group.last_part = part;
  const MeshView& mesh = job.parts[part].mesh;
  // Which sides are seen does not depend on the shading.
  std::vector<CachedVertex<Unlit>> vertices(mesh.vertex_count());
  VertexCache<Unlit> cache(vertices);
  sides_.resize(std::max(sides_.size(), mesh.triangle_count()));
  Status status =
      find_sides<Unlit>(mesh, job.transform, Unlit::lighting({}), cache, sides_, {job.parts[part].two_sided});
  const VertexPositions positions(job.transform, std::span<const CachedVertex<Unlit>>(vertices));
  const MeshNeighbours& neighbours = job.parts[part].neighbours;
  if (ok(status) && look_.curved) {
    status = curves_.emplace_back().found.add(mesh, neighbours, positions, sides_, group.outlines);
    if (status == Status::kScaleOutOfRange) status = Status::kOk;  // some edges stay straight
  } else if (ok(status)) {
    status = group.outlines.add(mesh, neighbours, positions, sides_);
  }
  if (!ok(status)) throw Failure("outlines", to_string(status));
}

void JobOutlines::finish(std::int32_t repeats, RenderStats& stats) const {
  stats.smooth_milliseconds = find_milliseconds_ + cost_.milliseconds / repeats;
  stats.outline_bytes = sides_.size() * sizeof(TriangleSide) + cost_.gap_bytes;
  for (const PartCurves& part : curves_)
    stats.outline_bytes += part.found.mesh().triangle_count() * sizeof(CurveMemory<1>);
  for (const OutlinedParts& group : groups_) {
    stats.outline_edges += group.outlines.edges().size();
    stats.outline_bytes += group.outlines.edges().size() * sizeof(OutlineEdge);
  }
}

}  // namespace arcspan::tools
