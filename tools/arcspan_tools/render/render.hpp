// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/lighting/illumination.hpp>

#include <arcspan_tools/image/image.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// One picture for the pipeline: everything is fixed point or integer already.
struct RenderJob {
  MeshView mesh;
  ClipTransform transform;
  Material material;
  /// 1 to 4 of them.
  std::vector<DirectionalLight> lights;
  Direction to_eye;
  Highlight highlight = Highlight::kBlinn;
  bool depth = true;
  bool two_sided = false;
  std::int32_t segment_bits = 2;  ///< of `segment`
  std::int32_t tolerance = 1;     ///< of `adaptive`, in 8-bit steps
  Rgb8 background;
  /// Rows of a band, 1 or more; a band of the picture's height or more is a full frame.
  std::int32_t band_rows = 0;
  /// How often every band is cleared and drawn, 1 or more, for measuring: the picture is the same.
  std::int32_t repeats = 1;
  bool counts = true;  ///< spans and pixels, by drawing once more
};

struct RenderStats {
  std::uint32_t triangles = 0;
  std::uint64_t spans = 0;  ///< 0 unless they are counted, as are pixels
  /// Of the spans: those that the depth test hid are counted too.
  std::uint64_t pixels = 0;
  std::uint64_t bands = 0;
  /// Processor time of drawing, clearing apart; of one frame, if it is repeated.
  double draw_milliseconds = 0;
  std::size_t frame_bytes = 0;
  std::size_t depth_bytes = 0;
  std::size_t cache_bytes = 0;
};

struct RenderResult {
  Image image;
  RenderStats stats;
};

/// Told the number of rows that are finished.
using RowsDone = std::function<void(std::size_t)>;

/// What pixels are stored as.
struct PixelChoice {
  std::string_view format;
  bool dithers = false;
};

using RenderFunction = RenderResult(const RenderJob& job, const PixelChoice& pixels,
                                    const RowsDone& rows_done);

/// A shading method that was chosen at compile time.
struct ShadingRenderer {
  std::string_view shading;
  RenderFunction* function;
};

/// All of them (generated, one translation unit each).
[[nodiscard]] std::span<const ShadingRenderer> shading_renderers();

/// A shading method into a pixel format.
struct Renderer {
  std::string_view shading;
  std::string_view format;
  bool dithers;
  RenderFunction* function;

  [[nodiscard]] RenderResult render(const RenderJob& job, const RowsDone& rows_done) const {
    return function(job, {format, dithers}, rows_done);
  }
};

/// Every shading into every format, without dither and with it where that makes a difference.
[[nodiscard]] std::span<const Renderer> renderers();

/// The renderer of that name, which must be one; formats of 8 bits a channel look the same with dither.
[[nodiscard]] const Renderer& find_renderer(std::string_view shading, std::string_view format, bool dithers);

/// Names for messages and options: every shading, every format, each once, in order.
[[nodiscard]] std::vector<std::string> shading_names();
[[nodiscard]] std::vector<std::string> format_names();

}  // namespace arcspan::tools
