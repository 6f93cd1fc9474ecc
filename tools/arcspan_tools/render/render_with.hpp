// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <arcspan_tools/render/any_format.hpp>
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/processor_time.hpp>

#include <algorithm>
#include <memory>
#include <vector>

namespace arcspan::tools {
namespace detail {

/// A band of a picture in the one format that is instantiated by itself.
class DirectBand {
 public:
  using Sink = hal::Framebuffer<Rgb565>;

  DirectBand(const PixelChoice&, std::int32_t width, std::int32_t rows)
      : memory_(Sink::words(width, rows)), frame_(memory_, width, rows) {}

  [[nodiscard]] Sink& sink() { return frame_; }
  void start(std::int32_t first_row, Rgb8 background) {
    frame_.move_to(first_row);
    frame_.clear(background);
  }
  [[nodiscard]] Rgb8 pixel(std::int32_t x, std::int32_t y) const { return frame_.pixel(x, y); }
  [[nodiscard]] std::size_t bytes() const { return memory_.size() * sizeof(Rgb565::Word); }

 private:
  std::vector<Rgb565::Word> memory_;
  Sink frame_;
};

/// A band of a picture in any format.
class AnyBand {
 public:
  using Sink = AnySink;

  AnyBand(const PixelChoice& pixels, std::int32_t width, std::int32_t rows)
      : store_(make_pixel_store(pixels.format, pixels.dithers, width, rows)), sink_(*store_) {}

  [[nodiscard]] Sink& sink() { return sink_; }
  void start(std::int32_t first_row, Rgb8 background) {
    store_->move_to(first_row);
    store_->clear(background);
  }
  [[nodiscard]] Rgb8 pixel(std::int32_t x, std::int32_t y) const { return store_->pixel(x, y); }
  [[nodiscard]] std::size_t bytes() const { return store_->bytes(); }

 private:
  std::unique_ptr<PixelStore> store_;
  AnySink sink_;
};

/// The depth of a band, or that there is none.
template <class Depth>
class BandDepth {
 public:
  BandDepth(std::int32_t, std::int32_t) {}

  [[nodiscard]] const NoDepth& buffer() const { return none_; }
  void start(std::int32_t) {}
  [[nodiscard]] std::size_t bytes() const { return 0; }

 private:
  NoDepth none_;
};

template <>
class BandDepth<DepthBuffer> {
 public:
  BandDepth(std::int32_t width, std::int32_t rows)
      : memory_(DepthBuffer::words(width, rows)), buffer_(memory_, width, rows) {}

  [[nodiscard]] const DepthBuffer& buffer() const { return buffer_; }
  void start(std::int32_t first_row) {
    buffer_.move_to(first_row);
    buffer_.clear();
  }
  [[nodiscard]] std::size_t bytes() const { return memory_.size() * sizeof(std::uint16_t); }

 private:
  std::vector<std::uint16_t> memory_;
  DepthBuffer buffer_;
};

template <class Band>
void copy_rows(const Band& band, std::int32_t first, std::int32_t rows, Image& image) {
  const std::int32_t end = std::min(first + rows, image.height);
  for (std::int32_t y = first; y < end; ++y) {
    for (std::int32_t x = 0; x < image.width; ++x) image.at(x, y) = band.pixel(x, y);
  }
}

/// Draws a band; processor milliseconds.
template <class Method, class Sink, class Depth>
[[gnu::noinline]] double draw_into(Sink& sink, const RenderJob& job,
                                   const typename Method::Lighting& lighting, const Depth& depth,
                                   std::span<CachedVertex<Method>> cache, RenderStats& stats) {
  const double start = processor_milliseconds();
  const DrawResult drawn =
      draw_mesh<Method>(job.mesh, job.transform, lighting, sink, depth, cache, {job.two_sided});
  const double end = processor_milliseconds();
  if (!ok(drawn.status)) throw Failure("pipeline", to_string(drawn.status));
  // Every band walks all triangles of the picture and counts those that reach it.
  stats.triangles = std::max(stats.triangles, drawn.triangles);
  return end - start;
}

/// Counts spans and their pixels, which depth does not change, by drawing into nothing: what is timed does
/// not count.
template <class Method>
void count_band(const RenderJob& job, const typename Method::Lighting& lighting, const Rect& bounds,
                std::span<CachedVertex<Method>> cache, RenderStats& stats) {
  NoPixels nothing(bounds);
  AnySink sink(nothing);
  (void)draw_mesh<Method>(job.mesh, job.transform, lighting, sink, NoDepth{}, cache, {job.two_sided});
  stats.spans += sink.spans();
  stats.pixels += sink.pixels();
}

/// Draws a band `repeats` times; milliseconds of one.
template <class Method, class Band, class Depth, class Start>
double draw_band(const RenderJob& job, const typename Method::Lighting& lighting, Band& band,
                 const Depth& depth, std::span<CachedVertex<Method>> cache, const Start& start,
                 RenderStats& stats) {
  double timed = 0;
  for (std::int32_t repeat = 0; repeat < job.repeats; ++repeat) {
    start();
    timed += draw_into<Method>(band.sink(), job, lighting, depth, cache, stats);
  }
  return timed / job.repeats;
}

template <class Method, class Band, class Depth>
RenderResult render_bands(const RenderJob& job, const PixelChoice& pixels,
                          const typename Method::Lighting& lighting, const RowsDone& rows_done) {
  const Viewport& size = job.transform.viewport();
  const std::int32_t rows = std::clamp(job.band_rows, 1, size.height);
  RenderResult result;
  result.image = Image(size.width, size.height);
  Band band(pixels, size.width, rows);
  BandDepth<Depth> depth(size.width, rows);
  std::vector<CachedVertex<Method>> cache(job.mesh.vertex_count());
  result.stats.frame_bytes = band.bytes();
  result.stats.depth_bytes = depth.bytes();
  result.stats.cache_bytes = cache.size() * sizeof(CachedVertex<Method>);
  for (std::int32_t first = 0; first < size.height; first += rows) {
    const auto start = [&] {
      band.start(first, job.background);
      depth.start(first);
    };
    result.stats.draw_milliseconds +=
        draw_band<Method>(job, lighting, band, depth.buffer(), std::span(cache), start, result.stats);
    if (job.counts) count_band<Method>(job, lighting, band.sink().bounds(), std::span(cache), result.stats);
    copy_rows(band, first, rows, result.image);
    ++result.stats.bands;
    rows_done(static_cast<std::size_t>(first + rows));
  }
  return result;
}

/// What the method makes of an illumination, with the job's settings if it has any.
template <class Method, class Lit>
typename Method::Lighting object_of(const RenderJob& job, const Lit& illumination) {
  typename Method::Lighting lighting(illumination);
  Status status = Status::kOk;
  if constexpr (requires { lighting.set_segment_bits(1); })
    status = lighting.set_segment_bits(job.segment_bits);
  if (!ok(status)) throw Failure("--segment " + std::to_string(job.segment_bits), to_string(status));
  if constexpr (requires { lighting.set_tolerance(1); }) status = lighting.set_tolerance(job.tolerance);
  if (!ok(status)) throw Failure("--tolerance " + std::to_string(job.tolerance), to_string(status));
  return lighting;
}

template <template <class> class Method, std::size_t Lights, Highlight Model>
RenderResult render_lit(const RenderJob& job, const PixelChoice& pixels, const RowsDone& rows_done) {
  using Lit = Illumination<Lights, Model>;
  // Lights beyond those given are dark, which adds nothing: 2 and 3 need no instantiation of their own.
  std::array<DirectionalLight, Lights> lights;
  lights.fill({job.lights[0].towards, Coefficient{}});
  std::copy(job.lights.begin(), job.lights.end(), lights.begin());
  Lit illumination;
  const Status status = Lit::make(job.material, lights, job.to_eye, illumination);
  if (!ok(status)) throw Failure("illumination", to_string(status));
  const auto lighting = object_of<Method<Lit>>(job, illumination);
  if constexpr (Lights == 1) {
    // What is drawn most often is drawn as a firmware would.
    if (pixels.format == "rgb565" && !pixels.dithers && job.depth) {
      return render_bands<Method<Lit>, DirectBand, DepthBuffer>(job, pixels, lighting, rows_done);
    }
  }
  return job.depth ? render_bands<Method<Lit>, AnyBand, DepthBuffer>(job, pixels, lighting, rows_done)
                   : render_bands<Method<Lit>, AnyBand, NoDepth>(job, pixels, lighting, rows_done);
}

template <template <class> class Method, Highlight Model>
RenderResult render_model(const RenderJob& job, const PixelChoice& pixels, const RowsDone& rows_done) {
  constexpr std::size_t kMost = 4;
  if (job.lights.empty() || job.lights.size() > kMost) {
    throw Failure("--light", "1 to 4 lights, not " + std::to_string(job.lights.size()));
  }
  return job.lights.size() == 1 ? render_lit<Method, 1, Model>(job, pixels, rows_done)
                                : render_lit<Method, kMost, Model>(job, pixels, rows_done);
}

}  // namespace detail

/// Renders with the shading `Method`; the rest of the job picks among the instantiations made here.
template <template <class> class Method>
RenderResult render_with(const RenderJob& job, const PixelChoice& pixels, const RowsDone& rows_done) {
  return job.highlight == Highlight::kBlinn
             ? detail::render_model<Method, Highlight::kBlinn>(job, pixels, rows_done)
             : detail::render_model<Method, Highlight::kPhong>(job, pixels, rows_done);
}

/// As render_with(), of one light and Blinn's highlight only: for what is measured and not offered.
template <template <class> class Method>
RenderResult render_usual(const RenderJob& job, const PixelChoice& pixels, const RowsDone& rows_done) {
  if (job.lights.size() != 1 || job.highlight != Highlight::kBlinn) {
    throw Failure("a measured method", "has one light and Blinn's highlight");
  }
  return detail::render_lit<Method, 1, Highlight::kBlinn>(job, pixels, rows_done);
}

}  // namespace arcspan::tools
