// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/textured/textured.hpp>

#include <arcspan_tools/render/any_format.hpp>
#include <arcspan_tools/render/any_illumination.hpp>
#include <arcspan_tools/render/band_depth.hpp>
#include <arcspan_tools/render/pixel_format_name.hpp>
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/render/surface_drawer.hpp>
#include <arcspan_tools/shading_method_list.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/processor_time.hpp>

#include <algorithm>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

// Every shading method is instantiated with two kinds of targets: a framebuffer of rgb565 with a depth buffer
// and one light, drawn exactly as firmware draws it, whose times mean something; and any pixel format and any
// lights behind virtual calls, with a depth test or without. Methods that take textures have a third one, for
// all textures and pixel operations (surface_operation.hpp). All draw the pixels that firmware draws.
//
// ARCSPAN_ALWAYS_VIRTUAL leaves the first kind out: the same pictures, drawn slower and compiled faster.
namespace arcspan::tools::detail {

#ifdef ARCSPAN_ALWAYS_VIRTUAL
inline constexpr bool kDrawsDirectly = false;
#else
inline constexpr bool kDrawsDirectly = true;
#endif

/// A band of a picture in rgb565.
class DirectBand {
 public:
  using Sink = hal::Framebuffer<Rgb565>;
  static constexpr DrawFeatures kFeatures{};

  DirectBand(const PixelChoice&, std::int32_t width, std::int32_t rows, const DepthBuffer*)
      : memory_(Sink::words(width, rows)), frame_(memory_, width, rows) {}

  [[nodiscard]] Sink& sink() { return frame_; }
  void start(std::int32_t first_row, Rgb8 background) {
    frame_.move_to(first_row);
    frame_.clear(background);
  }
  void read_row(std::int32_t y, std::span<Rgb8> row) const { decode_row(frame_, y, row); }
  [[nodiscard]] std::size_t bytes() const { return memory_.size() * sizeof(Rgb565::Word); }

 private:
  std::vector<Rgb565::Word> memory_;
  Sink frame_;
};

/// A band of a picture in any format.
class AnyBand {
 public:
  using Sink = AnySink;
  static constexpr DrawFeatures kFeatures{.whole_rows = false};  // nothing to gain beside virtual calls

  AnyBand(const PixelChoice& pixels, std::int32_t width, std::int32_t rows, const DepthBuffer* painted_over)
      : store_(make_pixel_store(pixels, width, rows)), sink_(*store_, painted_over) {}

  [[nodiscard]] Sink& sink() { return sink_; }
  void start(std::int32_t first_row, Rgb8 background) {
    store_->move_to(first_row);
    store_->clear(background);
  }
  void read_row(std::int32_t y, std::span<Rgb8> row) const { store_->read_row(y, row); }
  [[nodiscard]] std::size_t bytes() const { return store_->bytes(); }

 private:
  std::unique_ptr<PixelStore> store_;
  AnySink sink_;
};

/// A method's lighting for each part of a job.
template <class Method>
using PartLightings = std::vector<typename Method::Lighting>;

/// Draws one band once and returns the processor time in milliseconds. `arcspan compare` counts the
/// instructions of the functions of this name.
template <class Method, class Band>
[[gnu::noinline]] double draw_into(Band& band, const RenderJob& job, const PartLightings<Method>& lightings,
                                   const DepthBuffer& depth, std::span<CachedVertex<Method>> cache,
                                   RenderStats& stats) {
  std::uint32_t triangles = 0;
  const double start = processor_milliseconds();
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    const RenderPart& part = job.parts[i];
    const DrawResult drawn = draw_mesh<Method, Band::kFeatures>(part.mesh, job.transform, lightings[i],
                                                                band.sink(), depth, cache, {part.two_sided});
    if (!ok(drawn.status)) throw Failure("pipeline", to_string(drawn.status));
    triangles += drawn.triangles;
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
  BandDepth depth(size.width, rows);
  Band band(pixels, size.width, rows, job.depth ? nullptr : &depth.buffer());
  std::vector<CachedVertex<Method>> cache(most_vertices(job));
  result.stats.frame_bytes = band.bytes();
  result.stats.depth_bytes = job.depth ? depth.bytes() : 0;
  for (std::int32_t first = 0; first < size.height; first += rows) {
    double milliseconds = 0;
    for (std::int32_t repeat = 0; repeat < job.repeats; ++repeat) {
      band.start(first, job.background);
      depth.start(first);
      milliseconds += draw_into<Method>(band, job, lightings, depth.buffer(), std::span(cache), result.stats);
    }
    result.stats.draw_milliseconds += milliseconds / job.repeats;
    copy_rows(band, first, rows, result.image);
    ++result.stats.bands;
    rows_done(static_cast<std::size_t>(first + rows));
  }
  return result;
}

/// Counts the triangles of the picture, their spans and their pixels, hidden ones included, by drawing into
/// nothing. Neither bands nor depth change the counts, and what is timed does not count.
template <class Method>
void count_spans(const RenderJob& job, const PartLightings<Method>& lightings, RenderStats& stats) {
  const Viewport& size = job.transform.viewport();
  NoPixels nothing({0, 0, size.width, size.height});
  AnySink sink(nothing);
  const BandDepth depth(size.width, size.height);
  std::vector<CachedVertex<Method>> cache(most_vertices(job));
  stats.triangles = 0;
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    const RenderPart& part = job.parts[i];
    const DrawResult drawn = draw_mesh<Method, AnyBand::kFeatures>(
        part.mesh, job.transform, lightings[i], sink, depth.buffer(), std::span(cache), {part.two_sided});
    stats.triangles += drawn.triangles;
  }
  stats.spans = sink.spans();
  stats.pixels = sink.pixels();
  stats.written = nothing.written();
}

/// The method's lighting by an illumination, with the job's settings of the method if it has any.
template <class Method, class Lit>
typename Method::Lighting lighting_of(const RenderJob& job, const Lit& illumination) {
  typename Method::Lighting lighting(illumination);
  Status status = Status::kOk;
  if constexpr (requires { lighting.set_segment_bits(1); })
    status = lighting.set_segment_bits(job.segment_bits);
  if (!ok(status)) throw Failure("--segment " + std::to_string(job.segment_bits), to_string(status));
  if constexpr (requires { lighting.set_tolerance(1); }) status = lighting.set_tolerance(job.tolerance);
  if (!ok(status)) throw Failure("--tolerance " + std::to_string(job.tolerance), to_string(status));
  return lighting;
}

template <class Method, class Lit>
PartLightings<Method> lightings_of(const RenderJob& job, const std::vector<Lit>& illuminations) {
  PartLightings<Method> lightings;
  for (const Lit& illumination : illuminations) lightings.push_back(lighting_of<Method>(job, illumination));
  return lightings;
}

/// Whether no part needs a feature of an illumination that is off unless firmware asks for it.
inline bool is_plain(const RenderJob& job) {
  return std::all_of(job.parts.begin(), job.parts.end(),
                     [](const RenderPart& part) { return part.material.highlight_fade.raw() == 0; });
}

/// Renders into rgb565 with one light.
template <template <class> class Method, Highlight Model>
RenderResult render_directly(const RenderJob& job, const PixelChoice& pixels, const RowsDone& rows_done) {
  using Lit = Illumination<1, Model>;
  std::vector<Lit> illuminations(job.parts.size());
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    const Status status =
        Lit::make(job.parts[i].material, {job.lights.front()}, job.to_eye, illuminations[i]);
    if (!ok(status)) throw Failure("illumination", to_string(status));
  }
  return render_bands<Method<Lit>, DirectBand>(job, pixels, lightings_of<Method<Lit>>(job, illuminations),
                                               rows_done);
}

/// The bytes of a vertex in the cache of a firmware with these lights.
template <template <class> class Method, Highlight Model>
std::size_t cached_vertex_bytes(std::size_t lights) {
  constexpr std::size_t kBytes[] = {sizeof(CachedVertex<Method<Illumination<1, Model>>>),
                                    sizeof(CachedVertex<Method<Illumination<2, Model>>>),
                                    sizeof(CachedVertex<Method<Illumination<3, Model>>>),
                                    sizeof(CachedVertex<Method<Illumination<4, Model>>>)};
  return kBytes[lights - 1];
}

template <template <class> class Method>
std::size_t cached_vertex_bytes_of(const RenderJob& job) {
  return job.highlight == Highlight::kBlinn
             ? cached_vertex_bytes<Method, Highlight::kBlinn>(job.lights.size())
             : cached_vertex_bytes<Method, Highlight::kPhong>(job.lights.size());
}

template <template <class> class Method, class Lit>
RenderResult render_any(const RenderJob& job, const std::vector<std::unique_ptr<IlluminationCalls>>& calls,
                        const PixelChoice& pixels, const RowsDone& rows_done) {
  std::vector<Lit> illuminations;
  for (const std::unique_ptr<IlluminationCalls>& of_part : calls) illuminations.emplace_back(*of_part);
  const auto lightings = lightings_of<Method<Lit>>(job, illuminations);
  RenderResult result;
  bool is_drawn = false;
  if constexpr (kDrawsDirectly && Lit::kHasRamp) {
    if (job.lights.size() == 1 && job.depth && is_plain(job) &&
        pixels.format == pixel_format_name<Rgb565>() && !pixels.dithers) {
      result = job.highlight == Highlight::kBlinn
                   ? render_directly<Method, Highlight::kBlinn>(job, pixels, rows_done)
                   : render_directly<Method, Highlight::kPhong>(job, pixels, rows_done);
      is_drawn = true;
    }
  }
  if (!is_drawn) result = render_bands<Method<Lit>, AnyBand>(job, pixels, lightings, rows_done);
  result.stats.cache_bytes = most_vertices(job) * cached_vertex_bytes_of<Method>(job);
  if (job.counts) count_spans<Method<Lit>>(job, lightings, result.stats);
  return result;
}

/// Makes the drawer of a part with a texture or without. That has a white one, which changes no pixel.
template <template <class> class Method, bool kAsksForRamp>
std::unique_ptr<SurfaceDrawer> make_surface_drawer(const RenderJob& job, const RenderPart& part,
                                                   const IlluminationCalls& calls,
                                                   const SurfaceOperation& operation) {
  const auto make = [&]<class Lit>(const Lit& illumination) -> std::unique_ptr<SurfaceDrawer> {
    using Drawn = Textured<Method<Lit>, SurfaceTexels, TexelLight::kColoured>;
    const bool textured = part.texture != nullptr;
    const typename Drawn::Lighting lighting(lighting_of<Method<Lit>>(job, illumination), texture_of(part));
    return std::make_unique<SurfaceDrawerOf<Drawn>>(
        job, part, lighting, operation,
        cached_vertex_bytes_of<Method>(job) + (textured ? sizeof(MappedPoint) : 0));
  };
  if constexpr (kAsksForRamp) {
    if (!calls.has_ramp()) return make(AnyIllumination<false>(calls));
  }
  return make(AnyIllumination<true>(calls));
}

}  // namespace arcspan::tools::detail

namespace arcspan::tools {

/// Renders with the shading `Method`; the rest of the job picks among the instantiations made here.
/// `kAsksForRamp` is false for methods that do not ask whether an illumination has a ramp. Without
/// `kDrawsEffects` textures, vertex colours, transparency, fog and environment maps are left out.
template <template <class> class Method, bool kAsksForRamp, bool kDrawsEffects>
RenderResult render_with(const RenderJob& job, const PixelChoice& pixels, const RowsDone& rows_done) {
  std::vector<std::unique_ptr<IlluminationCalls>> calls;
  for (const RenderPart& part : job.parts) {
    calls.push_back(make_any_illumination(part.material, job.lights, job.to_eye, job.highlight));
  }
  if constexpr (kDrawsEffects) {
    if (has_surfaces(job)) {
      return render_surfaces(job, calls, pixels, rows_done,
                             detail::make_surface_drawer<Method, kAsksForRamp>);
    }
  }
  if constexpr (kAsksForRamp) {
    if (!calls.front()->has_ramp())
      return detail::render_any<Method, AnyIllumination<false>>(job, calls, pixels, rows_done);
  }
  return detail::render_any<Method, AnyIllumination<true>>(job, calls, pixels, rows_done);
}

}  // namespace arcspan::tools
