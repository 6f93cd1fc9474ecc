// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/ink_outlines.hpp>
#include <arcspan/lighting/illumination.hpp>
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/fog.hpp>
#include <arcspan/vertex/clip_transform.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <arcspan_tools/image/image.hpp>
#include <arcspan_tools/render/pixel_choice.hpp>
#include <arcspan_tools/render/surface_operation.hpp>
#include <arcspan_tools/texture/plain/surface_texture.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// A mesh with one material.
struct RenderPart {
  MeshView mesh;
  Material material;
  bool two_sided = false;
  std::shared_ptr<const SurfaceTexture> texture{};  ///< multiplies the light on it; null if there is none
  bool vertex_colours = false;  ///< those of the mesh multiply the light, which is that of Gouraud shading
  Transparency transparency = Transparency::kNone;
  std::uint8_t opacity = 32;    ///< of transparency: 0...32, of kScreenDoor 0...8
  MeshNeighbours neighbours{};  ///< for outlines; all parts have some, or none has
};

/// RenderJob::segment_bits of segments that are as long as the accuracy allows.
inline constexpr std::int32_t kAdaptiveSegments = -1;

/// What is done with the outlines of parts that have neighbours.
struct OutlineLook {
  bool smooth = true;
  std::optional<OutlineInk> ink{};
  bool curved = false;  ///< by triangles beyond them; of jobs without surfaces (has_surfaces())
};

/// One picture for the pipeline: everything is fixed point or integer already.
struct RenderJob {
  std::vector<RenderPart> parts;  ///< 1 or more, drawn in this order by the same transform
  ClipTransform transform;
  std::vector<DirectionalLight> lights;  ///< 1 to 4
  Direction to_eye;
  Highlight highlight = Highlight::kBlinn;
  bool depth = true;
  /// Of methods with segments: these have 2^bits pixels. 0: the method's usual length.
  std::int32_t segment_bits = 0;
  std::int32_t tolerance = 1;   ///< of `arc`, in 8-bit steps
  std::int32_t toon_steps = 0;  ///< Illumination::set_toon(), or 0
  OutlineLook outlines;
  Rgb8 background;
  std::int32_t band_rows = 0;  ///< rows per band, 1 or more; the picture's height or more is a full frame
  std::int32_t repeats = 1;    ///< draws of every band, 1 or more, for measuring; the picture is the same
  std::shared_ptr<const Fog> fog{};                ///< null if there is none
  std::shared_ptr<const SurfaceTexture> matcap{};  ///< environment map in place of all light, or null
  Rotation rotation{};                             ///< from object to view space, for `matcap`
  double nearest = 0;   ///< vertex, its distance before the camera in the model's units; for messages
  double farthest = 0;  ///< vertex
  bool counts = true;   ///< count spans and pixels, by drawing once more
};

/// The number of vertices of the largest part, which is what a vertex cache has to hold.
[[nodiscard]] inline std::size_t most_vertices(const RenderJob& job) {
  std::size_t most = 0;
  for (const RenderPart& part : job.parts) most = std::max(most, part.mesh.vertex_count());
  return most;
}

/// Whether the shading of this name draws textures, vertex colours, transparency, fog and environment maps.
[[nodiscard]] bool shading_draws_effects(std::string_view shading);

struct RenderStats {
  std::uint32_t triangles = 0;  ///< of the picture; of the fullest band unless RenderJob::counts
  std::uint64_t spans = 0;      ///< 0 unless RenderJob::counts
  std::uint64_t pixels = 0;     ///< of the spans, hidden ones included; 0 unless RenderJob::counts
  std::uint64_t written = 0;    ///< pixels that a depth test lets pass; 0 unless RenderJob::counts
  std::uint64_t bands = 0;
  double draw_milliseconds = 0;  ///< processor time of drawing one frame, without clearing
  std::size_t frame_bytes = 0;
  std::size_t depth_bytes = 0;
  std::size_t cache_bytes = 0;
  std::size_t outline_edges = 0;   ///< 0 without smoothing and ink, like what follows
  std::size_t outline_bytes = 0;   ///< sides of triangles, edges and gaps
  double smooth_milliseconds = 0;  ///< processor time of finding outlines, inking and smoothing them
};

struct RenderResult {
  Image image;
  RenderStats stats;
};

/// Called with the number of rows that are finished.
using RowsDone = std::function<void(std::size_t)>;

using RenderFunction = RenderResult(const RenderJob& job, const PixelChoice& pixels,
                                    const RowsDone& rows_done);

/// A shading method by name.
struct ShadingRenderer {
  std::string_view shading;
  RenderFunction* function;
};

/// One renderer for each entry of shading_method_list.hpp, in its order.
[[nodiscard]] std::span<const ShadingRenderer> shading_renderers();

/// A shading method into a pixel format.
struct Renderer {
  std::string_view shading;
  PixelChoice pixels;
  RenderFunction* function;

  [[nodiscard]] RenderResult render(const RenderJob& job, const RowsDone& rows_done) const {
    return function(job, pixels, rows_done);
  }
};

/// Every shading method into every one of pixel_choices().
[[nodiscard]] std::span<const Renderer> renderers();

/// The renderer of these names; throws Failure if there is none. A format of 8 bits per channel is never
/// dithered.
[[nodiscard]] const Renderer& find_renderer(std::string_view shading, std::string_view format, bool dithers);

/// Every shading method's and every pixel format's name, each once, in the order of the lists.
[[nodiscard]] std::vector<std::string> shading_names();
[[nodiscard]] std::vector<std::string> format_names();

}  // namespace arcspan::tools
