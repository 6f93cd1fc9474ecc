// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>

#include <arcspan_tools/render/counting_sink.hpp>
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <chrono>

namespace arcspan::tools {
namespace detail {

/// A band of a picture in memory of its own, with or without depth.
template <class Format>
struct Band {
  std::int32_t rows;
  std::vector<typename Format::Unit> frame_memory;
  std::vector<std::uint16_t> depth_memory;
  hal::Framebuffer<Format> frame;
  DepthBuffer depth;

  Band(std::int32_t width, std::int32_t band_rows, bool with_depth)
      : rows(band_rows),
        frame_memory(hal::Framebuffer<Format>::units(width, band_rows)),
        depth_memory(with_depth ? DepthBuffer::units(width, band_rows) : 0),
        frame(frame_memory, width, band_rows),
        depth(depth_memory, width, with_depth ? band_rows : 0) {}
};

template <class Format>
void copy_rows(const Band<Format>& band, Image& image) {
  const std::int32_t first = band.frame.bounds().top;
  const std::int32_t end = std::min(first + band.rows, image.height);
  for (std::int32_t y = first; y < end; ++y) {
    for (std::int32_t x = 0; x < image.width; ++x) image.at(x, y) = band.frame.pixel(x, y);
  }
}

template <class Method, class Format, class Depth>
void draw_band(const RenderJob& job, const typename Method::Object& object, Band<Format>& band,
               const Depth& depth, std::span<CachedVertex<Method>> cache, RenderStats& stats) {
  CountingSink sink(band.frame);
  const auto start = std::chrono::steady_clock::now();
  const DrawResult drawn =
      draw_mesh<Method>(job.mesh, job.transform, object, sink, depth, cache, {job.two_sided});
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  if (!ok(drawn.status)) throw Failure("pipeline", to_string(drawn.status));
  // Every band walks all triangles of the picture and counts those that reach it.
  stats.triangles = std::max(stats.triangles, drawn.triangles);
  stats.spans += sink.spans();
  stats.pixels += sink.pixels();
  stats.draw_milliseconds += elapsed.count();
}

template <class Method, class Format>
RenderResult render_bands(const RenderJob& job, const typename Method::Object& object,
                          const RowsDone& rows_done) {
  const Viewport& size = job.transform.viewport();
  RenderResult result;
  result.image = Image(size.width, size.height);
  Band<Format> band(size.width, std::clamp(job.band_rows, 1, size.height), job.depth);
  std::vector<CachedVertex<Method>> cache(job.mesh.vertex_count());
  result.stats.frame_bytes = band.frame_memory.size() * sizeof(typename Format::Unit);
  result.stats.depth_bytes = band.depth_memory.size() * sizeof(std::uint16_t);
  result.stats.cache_bytes = cache.size() * sizeof(CachedVertex<Method>);
  for (std::int32_t first = 0; first < size.height; first += band.rows) {
    band.frame.move_to(first);
    band.frame.clear(job.background);
    if (job.depth) {
      band.depth.move_to(first);
      band.depth.clear();
      draw_band<Method>(job, object, band, band.depth, std::span(cache), result.stats);
    } else {
      draw_band<Method>(job, object, band, NoDepth{}, std::span(cache), result.stats);
    }
    copy_rows(band, result.image);
    ++result.stats.bands;
    rows_done(static_cast<std::size_t>(first + band.rows));
  }
  return result;
}

template <template <class> class Method, class Format, std::size_t Lights, Highlight Model>
RenderResult render_lit(const RenderJob& job, const RowsDone& rows_done) {
  using Lit = Illumination<Lights, Model>;
  std::array<DirectionalLight, Lights> lights;
  for (std::size_t i = 0; i < Lights; ++i) lights[i].towards = job.lights[i];
  Lit object;
  const Status status = Lit::make(job.material, lights, job.to_eye, object);
  if (!ok(status)) throw Failure("illumination", to_string(status));
  return render_bands<Method<Lit>, Format>(job, object, rows_done);
}

template <template <class> class Method, class Format, Highlight Model>
RenderResult render_model(const RenderJob& job, const RowsDone& rows_done) {
  switch (job.lights.size()) {
    case 1:
      return render_lit<Method, Format, 1, Model>(job, rows_done);
    case 2:
      return render_lit<Method, Format, 2, Model>(job, rows_done);
    case 3:
      return render_lit<Method, Format, 3, Model>(job, rows_done);
    case 4:
      return render_lit<Method, Format, 4, Model>(job, rows_done);
    default:
      throw Failure("--light", "1 to 4 lights, not " + std::to_string(job.lights.size()));
  }
}

}  // namespace detail

/// Renders with the shading `Method` into the pixel format `Format`; the rest of the job picks among the
/// instantiations made here.
template <template <class> class Method, class Format>
RenderResult render_with(const RenderJob& job, const RowsDone& rows_done) {
  return job.highlight == Highlight::kBlinn
             ? detail::render_model<Method, Format, Highlight::kBlinn>(job, rows_done)
             : detail::render_model<Method, Format, Highlight::kPhong>(job, rows_done);
}

}  // namespace arcspan::tools
