// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/lighting/toon.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <arcspan_tools/render/render_bands.hpp>

#include <span>
#include <vector>

// A framebuffer of rgb565 with a depth buffer and one light, drawn exactly as firmware draws it: times and
// instructions of this drawing mean something.
namespace arcspan::tools::detail {

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
  void finish_outlines(const OutlineList& outlines, const OutlineLook& look, const DepthBuffer& depth,
                       SmoothCost& cost) {
    tools::finish_outlines(outlines, look, frame_, depth, cost);
  }
  [[nodiscard]] std::size_t bytes() const { return memory_.size() * sizeof(Rgb565::Word); }

 private:
  std::vector<Rgb565::Word> memory_;
  Sink frame_;
};

/// Renders into rgb565 with the first light and a depth test, whatever the job asks for.
template <template <class> class Method, Highlight Model>
RenderResult render_directly(const RenderJob& job, const PixelChoice& pixels, const RowsDone& rows_done) {
  using Lit = Illumination<1, Model>;
  std::vector<Lit> illuminations(job.parts.size());
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    Status status = Lit::make(job.parts[i].material, {job.lights.front()}, job.to_eye, illuminations[i]);
    if (ok(status) && job.toon_steps != 0) status = illuminations[i].set_toon(job.toon_steps);
    if (!ok(status)) throw Failure("illumination", to_string(status));
  }
  return render_bands<Method<Lit>, DirectBand>(job, pixels, lightings_of<Method<Lit>>(job, illuminations),
                                               rows_done);
}

}  // namespace arcspan::tools::detail
