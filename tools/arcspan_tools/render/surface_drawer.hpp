// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/shading/with_operation.hpp>
#include <arcspan/span/depth_mode.hpp>

#include <arcspan_tools/render/any_illumination.hpp>
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/render/surface_sink.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace arcspan::tools {

/// Draws a part of a job with operations on its pixels.
class SurfaceDrawer {
 public:
  virtual ~SurfaceDrawer() = default;
  /// `depth` is of the buffer that `sink` writes to.
  virtual DrawResult draw(SurfaceSink& sink, const ReadOnlyDepth& depth) = 0;
  /// Bytes of a vertex in the cache of a firmware.
  [[nodiscard]] virtual std::size_t vertex_bytes() const = 0;
};

/// Draws by a method. Job and part must outlive it.
template <class Method>
class SurfaceDrawerOf final : public SurfaceDrawer {
 public:
  using Operated = WithOperation<Method, SurfaceOperation>;

  SurfaceDrawerOf(const RenderJob& job, const RenderPart& part, const typename Method::Lighting& lighting,
                  const SurfaceOperation& operation, std::size_t vertex_bytes)
      : job_(job),
        part_(part),
        lighting_(lighting, operation),
        cache_(part.mesh.vertex_count()),
        vertex_bytes_(vertex_bytes) {}

  DrawResult draw(SurfaceSink& sink, const ReadOnlyDepth& depth) override {
    return draw_mesh<Operated>(part_.mesh, job_.transform, lighting_, sink, depth, std::span(cache_),
                               {part_.two_sided});
  }
  [[nodiscard]] std::size_t vertex_bytes() const override { return vertex_bytes_; }

 private:
  const RenderJob& job_;
  const RenderPart& part_;
  typename Operated::Lighting lighting_;
  std::vector<CachedVertex<Operated>> cache_;
  std::size_t vertex_bytes_;
};

/// Makes the drawer of a part that is drawn by the job's shading method, with a texture or without.
using MakeSurfaceDrawer = std::unique_ptr<SurfaceDrawer>(const RenderJob& job, const RenderPart& part,
                                                         IlluminationCalls& illumination,
                                                         const SurfaceOperation& operation);

/// The texture of a part; a white one, which changes no pixel, if it has none.
[[nodiscard]] inline const Texture<SurfaceTexels>& texture_of(const RenderPart& part) {
  return part.texture == nullptr ? white_texture() : part.texture->view;
}

/// Returns make<Filter, Borders>() for the sampler of a part's texture.
template <class Make>
std::unique_ptr<SurfaceDrawer> make_for_sampler(const RenderPart& part, const Make& make) {
  const TextureSampler& sampler = texture_of(part).sampler();
  const auto with_filter = [&]<TextureFilter kFilter>() {
    return sampler.repeats() ? make.template operator()<kFilter, TextureBorders::kRepeat>()
                             : make.template operator()<kFilter, TextureBorders::kOfTexture>();
  };
  return sampler.filter == TextureFilter::kBilinear
             ? with_filter.template operator()<TextureFilter::kBilinear>()
             : with_filter.template operator()<TextureFilter::kNearest>();
}

/// Whether a part has a texture, vertex colours or transparency, or the job fog or an environment map.
[[nodiscard]] bool has_surfaces(const RenderJob& job);

/// Renders such a job. `make` is for parts that are lit by the shading method; those with vertex colours are
/// drawn by VertexColoured, and all by EnvironmentMap if the job has one.
[[nodiscard]] RenderResult render_surfaces(const RenderJob& job,
                                           const std::vector<std::unique_ptr<IlluminationCalls>>& calls,
                                           const PixelChoice& pixels, const RowsDone& rows_done,
                                           MakeSurfaceDrawer& make);

}  // namespace arcspan::tools
