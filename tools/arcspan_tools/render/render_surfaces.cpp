// SPDX-License-Identifier: MIT
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/environment_map.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/vertex_coloured.hpp>

#include <arcspan_tools/render/band_depth.hpp>
#include <arcspan_tools/render/job_outlines.hpp>
#include <arcspan_tools/render/surface_drawer.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/processor_time.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

using Drawers = std::vector<std::unique_ptr<SurfaceDrawer>>;

bool is_grey(const ChannelCoefficients& c) { return c.r == c.g && c.g == c.b; }

/// Whether the light on a part, highlights apart, has equal channels.
bool has_grey_light(const RenderJob& job, const RenderPart& part) {
  return is_grey(part.material.ambient) && is_grey(part.material.diffuse) &&
         std::all_of(job.lights.begin(), job.lights.end(),
                     [](const DirectionalLight& light) { return is_grey(light.colour); });
}

Drawers make_drawers(const RenderJob& job, const std::vector<std::unique_ptr<IlluminationCalls>>& calls,
                     MakeSurfaceDrawer& make) {
  using Chrome = Arc<EnvironmentMap<SurfaceTexels>>;
  using Painted = VertexColoured<AnyIllumination<true>>;
  Drawers drawers;
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    const RenderPart& part = job.parts[i];
    const SurfaceOperation operation{job.fog.get(), part.transparency, part.opacity, part.texture != nullptr,
                                     !part.vertex_colours && has_grey_light(job, part)};
    if (job.matcap != nullptr) {
      drawers.push_back(std::make_unique<SurfaceDrawerOf<Chrome>>(
          job, part, EnvironmentMap<SurfaceTexels>(job.matcap->view, job.rotation), operation,
          sizeof(CachedVertex<Chrome>)));
    } else if (part.vertex_colours) {
      drawers.push_back(make_for_sampler(part, [&]<TextureFilter kFilter, TextureBorders kBorders>() {
        using Coloured = Textured<Painted, SurfaceTexels, TexelLight::kColoured, kFilter, kBorders>;
        const typename Coloured::Lighting lighting(AnyIllumination<true>(*calls[i]), texture_of(part));
        return std::unique_ptr<SurfaceDrawer>(std::make_unique<SurfaceDrawerOf<Coloured>>(
            job, part, lighting, operation,
            part.texture == nullptr ? sizeof(CachedVertex<Painted>) : sizeof(CachedVertex<Coloured>)));
      }));
    } else {
      drawers.push_back(make(job, part, *calls[i], operation));
    }
  }
  return drawers;
}

/// What drawing all parts once took.
struct PartsDrawn {
  std::uint32_t triangles = 0;
  double milliseconds = 0;  ///< of processor time
};

/// Draws all parts once, and calls after(i) after each.
template <class After>
PartsDrawn draw_parts(const Drawers& drawers, SurfaceSink& sink, const DepthBuffer& depth,
                      const After& after) {
  PartsDrawn all;
  for (std::size_t i = 0; i < drawers.size(); ++i) {
    const double start = processor_milliseconds();
    const DrawResult drawn = drawers[i]->draw(sink, ReadOnlyDepth(depth));
    all.milliseconds += processor_milliseconds() - start;
    if (!ok(drawn.status)) throw Failure("pipeline", to_string(drawn.status));
    all.triangles += drawn.triangles;
    after(i);
  }
  return all;
}

/// Counts by drawing into nothing.
void count_spans(const RenderJob& job, const Drawers& drawers, RenderStats& stats) {
  const Viewport& size = job.transform.viewport();
  NoPixels nothing({0, 0, size.width, size.height});
  const BandDepth depth(size.width, size.height);
  SurfaceSink sink(nothing, depth.buffer(), false);
  stats.triangles = draw_parts(drawers, sink, depth.buffer(), [](std::size_t) {}).triangles;
  stats.spans = sink.spans();
  stats.pixels = sink.pixels();
  stats.written = nothing.written();
}

}  // namespace

bool has_surfaces(const RenderJob& job) {
  return job.fog != nullptr || job.matcap != nullptr ||
         std::any_of(job.parts.begin(), job.parts.end(), [](const RenderPart& part) {
           return part.texture != nullptr || part.vertex_colours || part.transparency != Transparency::kNone;
         });
}

RenderResult render_surfaces(const RenderJob& job,
                             const std::vector<std::unique_ptr<IlluminationCalls>>& calls,
                             const PixelChoice& pixels, const RowsDone& rows_done, MakeSurfaceDrawer& make) {
  if (job.outlines.curved) {
    throw Failure("--curved-outlines",
                  "not of textures, vertex colours, transparency, fog and environment maps");
  }
  const Drawers drawers = make_drawers(job, calls, make);
  const Viewport& size = job.transform.viewport();
  const std::int32_t rows = std::clamp(job.band_rows, 1, size.height);
  RenderResult result;
  result.image = Image(size.width, size.height);
  JobOutlines outlines(job);
  const std::int32_t drawn_rows = rows == size.height ? rows : rows + 2 * outlines.margin();
  BandDepth depth(size.width, drawn_rows);
  const std::unique_ptr<PixelStore> store = make_pixel_store(pixels, size.width, drawn_rows);
  result.stats.frame_bytes = store->bytes();
  result.stats.depth_bytes = job.depth ? depth.bytes() : 0;
  for (const std::unique_ptr<SurfaceDrawer>& drawer : drawers) {
    result.stats.cache_bytes =
        std::max(result.stats.cache_bytes, most_vertices(job) * drawer->vertex_bytes());
  }
  SurfaceSink sink(*store, depth.buffer(), !job.depth);
  for (std::int32_t first = 0; first < size.height; first += rows) {
    double milliseconds = 0;
    for (std::int32_t repeat = 0; repeat < job.repeats; ++repeat) {
      store->move_to(outlines.first_row(first));
      store->clear(job.background);
      depth.start(outlines.first_row(first));
      const PartsDrawn drawn = draw_parts(drawers, sink, depth.buffer(), [&](std::size_t part) {
        outlines.finish_after(part, *store, depth.buffer());
      });
      result.stats.triangles = std::max(result.stats.triangles, drawn.triangles);
      milliseconds += drawn.milliseconds;
    }
    result.stats.draw_milliseconds += milliseconds / job.repeats;
    copy_rows(*store, first, rows, result.image);
    ++result.stats.bands;
    rows_done(static_cast<std::size_t>(first) + static_cast<std::size_t>(rows));
  }
  outlines.finish(job.repeats, result.stats);
  if (job.counts) count_spans(job, drawers, result.stats);
  return result;
}

}  // namespace arcspan::tools
