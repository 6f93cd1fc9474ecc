// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/textured/textured.hpp>

#include <arcspan_tools/render/any_format.hpp>
#include <arcspan_tools/render/any_illumination.hpp>
#include <arcspan_tools/render/pixel_format_name.hpp>
#include <arcspan_tools/render/render_bands.hpp>
#include <arcspan_tools/render/surface_drawer.hpp>
#include <arcspan_tools/shading_method_list.hpp>

#include <algorithm>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

// Every shading method draws any pixel format and any lights behind virtual calls, with a depth test or
// without. Methods that take textures are instantiated once more, for all textures and pixel operations
// (surface_operation.hpp). Drawings whose times are reported go through render_directly.hpp. All draw the
// pixels that firmware draws.
namespace arcspan::tools::detail {

/// A band of a picture in any format.
class AnyBand {
 public:
  using Sink = AnySink;
  static constexpr DrawFeatures kFeatures{};

  AnyBand(const PixelChoice& pixels, std::int32_t width, std::int32_t rows, const DepthBuffer* painted_over)
      : store_(make_pixel_store(pixels, width, rows)), sink_(*store_, painted_over) {}

  [[nodiscard]] Sink& sink() { return sink_; }
  void start(std::int32_t first_row, Rgb8 background) {
    store_->move_to(first_row);
    store_->clear(background);
  }
  void read_row(std::int32_t y, std::span<Rgb8> row) const { store_->read_row(y, row); }
  void finish_outlines(const OutlineList& outlines, const OutlineLook& look, const DepthBuffer& depth,
                       SmoothCost& cost) {
    store_->finish_outlines(outlines, look, depth, cost);
  }
  [[nodiscard]] std::size_t bytes() const { return store_->bytes(); }

 private:
  std::unique_ptr<PixelStore> store_;
  AnySink sink_;
};

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

/// Whether firmware without further features draws this: rgb565, one light, a depth buffer.
inline bool is_drawn_directly(const RenderJob& job, const PixelChoice& pixels) {
  return job.lights.size() == 1 && job.depth && pixels.format == pixel_format_name<Rgb565>() &&
         !pixels.dithers && std::all_of(job.parts.begin(), job.parts.end(), [](const RenderPart& part) {
           return part.material.highlight_fade.raw() == 0;
         });
}

template <template <class> class Method, class Lit>
RenderResult render_any(const RenderJob& job, const std::vector<std::unique_ptr<IlluminationCalls>>& calls,
                        const PixelChoice& pixels, const RowsDone& rows_done, RenderFunction* directly) {
  std::vector<Lit> illuminations;
  for (const std::unique_ptr<IlluminationCalls>& of_part : calls) illuminations.emplace_back(*of_part);
  const auto lightings = lightings_of<Method<Lit>>(job, illuminations);
  RenderResult result = Lit::kHasRamp && directly != nullptr && is_drawn_directly(job, pixels)
                            ? directly(job, pixels, rows_done)
                            : render_bands<Method<Lit>, AnyBand>(job, pixels, lightings, rows_done);
  result.stats.cache_bytes = most_vertices(job) * cached_vertex_bytes_of<Method>(job);
  if (job.counts) count_spans<Method<Lit>>(job, lightings, result.stats);
  return result;
}

/// Makes the drawer of a part with a texture or without. That has a white one, which changes no pixel.
template <template <class> class Method, bool kAsksForRamp>
std::unique_ptr<SurfaceDrawer> make_surface_drawer(const RenderJob& job, const RenderPart& part,
                                                   IlluminationCalls& calls,
                                                   const SurfaceOperation& operation) {
  const std::size_t vertex_bytes =
      cached_vertex_bytes_of<Method>(job) + (part.texture != nullptr ? sizeof(MappedPoint) : 0);
  const auto make = [&]<class Lit>(const Lit& illumination) {
    const auto lit = lighting_of<Method<Lit>>(job, part, illumination);
    return make_for_sampler(part, [&]<TextureFilter kFilter, TextureBorders kBorders>() {
      using Drawn = Textured<Method<Lit>, SurfaceTexels, TexelLight::kColoured, kFilter, kBorders>;
      return std::unique_ptr<SurfaceDrawer>(std::make_unique<SurfaceDrawerOf<Drawn>>(
          job, part, typename Drawn::Lighting(lit, texture_of(part)), operation, vertex_bytes));
    });
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
/// `kDrawsEffects` textures, vertex colours, transparency, fog and environment maps are left out. `directly`
/// draws what is_drawn_directly(), unless it is a null pointer.
template <template <class> class Method, bool kAsksForRamp, bool kDrawsEffects>
RenderResult render_with(const RenderJob& job, const PixelChoice& pixels, const RowsDone& rows_done,
                         RenderFunction* directly) {
  std::vector<std::unique_ptr<IlluminationCalls>> calls;
  for (const RenderPart& part : job.parts) {
    calls.push_back(make_any_illumination(part.material, job));
  }
  if constexpr (kDrawsEffects) {
    if (has_surfaces(job)) {
      return render_surfaces(job, calls, pixels, rows_done,
                             detail::make_surface_drawer<Method, kAsksForRamp>);
    }
  }
  if constexpr (kAsksForRamp) {
    if (!calls.front()->has_ramp())
      return detail::render_any<Method, AnyIllumination<false>>(job, calls, pixels, rows_done, directly);
  }
  return detail::render_any<Method, AnyIllumination<true>>(job, calls, pixels, rows_done, directly);
}

}  // namespace arcspan::tools
