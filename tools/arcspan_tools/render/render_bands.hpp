// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>

#include <arcspan_tools/render/band_depth.hpp>
#include <arcspan_tools/render/job_outlines.hpp>
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/processor_time.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace arcspan::tools::detail {

/// A method's lighting for each part of a job.
template <class Method>
using PartLightings = std::vector<typename Method::Lighting>;

/// Draws one band once and returns the processor time in milliseconds. `arcspan compare` counts the
/// instructions of the functions of this name.
template <class Method, class Band>
[[gnu::noinline]] double draw_into(Band& band, const RenderJob& job, const PartLightings<Method>& lightings,
                                   const JobOutlines& outlines, const DepthBuffer& depth,
                                   std::span<CachedVertex<Method>> cache, RenderStats& stats) {
  std::uint32_t triangles = 0;
  const double start = processor_milliseconds();
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    const RenderPart& part = job.parts[i];
    for (const MeshView& mesh : {part.mesh, outlines.curves(i)}) {
      if (mesh.triangle_count() == 0) continue;
      const DrawResult drawn = draw_mesh<Method, Band::kFeatures>(
          mesh, job.transform, lightings[i], band.sink(), depth, cache, {part.two_sided});
      if (!ok(drawn.status)) throw Failure("pipeline", to_string(drawn.status));
      triangles += drawn.triangles;
    }
  }
  const double end = processor_milliseconds();
  // Every band counts the triangles that reach it; count_spans() counts those of the picture.
  stats.triangles = std::max(stats.triangles, triangles);
  return end - start;
}

/// Draws all bands of a picture. `depth` is tested unless the band ignores it.
template <class Method, class Band>
RenderResult render_bands(const RenderJob& job, const PixelChoice& pixels,
                          const PartLightings<Method>& lightings, const RowsDone& rows_done) {
  const Viewport& size = job.transform.viewport();
  const std::int32_t rows = std::clamp(job.band_rows, 1, size.height);
  RenderResult result;
  result.image = Image(size.width, size.height);
  JobOutlines outlines(job);
  const std::int32_t drawn_rows = rows == size.height ? rows : rows + 2 * outlines.margin();
  BandDepth depth(size.width, drawn_rows);
  Band band(pixels, size.width, drawn_rows, job.depth ? nullptr : &depth.buffer());
  std::vector<CachedVertex<Method>> cache(std::max(most_vertices(job), outlines.most_curve_vertices()));
  result.stats.frame_bytes = band.bytes();
  result.stats.depth_bytes = job.depth ? depth.bytes() : 0;
  for (std::int32_t first = 0; first < size.height; first += rows) {
    double milliseconds = 0;
    for (std::int32_t repeat = 0; repeat < job.repeats; ++repeat) {
      band.start(outlines.first_row(first), job.background);
      depth.start(outlines.first_row(first));
      milliseconds +=
          draw_into<Method>(band, job, lightings, outlines, depth.buffer(), std::span(cache), result.stats);
      outlines.finish_after(job.parts.size() - 1, band, depth.buffer());
    }
    result.stats.draw_milliseconds += milliseconds / job.repeats;
    copy_rows(band, first, rows, result.image);
    ++result.stats.bands;
    rows_done(static_cast<std::size_t>(first + rows));
  }
  outlines.finish(job.repeats, result.stats);
  return result;
}

/// The method's lighting of a part by an illumination, with the job's settings of the method if it has any.
template <class Method, class Lit>
typename Method::Lighting lighting_of(const RenderJob& job, const RenderPart& part, const Lit& illumination) {
  typename Method::Lighting lighting(illumination);
  Status status = Status::kOk;
  if constexpr (requires { lighting.set_segment_bits(1); }) {
    if (job.segment_bits == kAdaptiveSegments) {
      status = lighting.set_adaptive_segments(part.material.shininess);
    } else if (job.segment_bits != 0) {
      status = lighting.set_segment_bits(job.segment_bits);
    }
  }
  if (!ok(status)) throw Failure("--segment " + std::to_string(job.segment_bits), to_string(status));
  if constexpr (requires { lighting.set_tolerance(1); }) status = lighting.set_tolerance(job.tolerance);
  if (!ok(status)) throw Failure("--tolerance " + std::to_string(job.tolerance), to_string(status));
  return lighting;
}

template <class Method, class Lit>
PartLightings<Method> lightings_of(const RenderJob& job, const std::vector<Lit>& illuminations) {
  PartLightings<Method> lightings;
  for (std::size_t i = 0; i < illuminations.size(); ++i)
    lightings.push_back(lighting_of<Method>(job, job.parts[i], illuminations[i]));
  return lightings;
}

}  // namespace arcspan::tools::detail
