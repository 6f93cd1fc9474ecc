// SPDX-License-Identifier: MIT
#include <arcspan/pixel/pixel_format_list.hpp>

#include <arcspan_tools/render/any_format.hpp>
#include <arcspan_tools/render/band_depth.hpp>
#include <arcspan_tools/render/job_outlines.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <string>
#include <vector>

namespace arcspan::tools {
namespace {

template <class Format>
class FormatStore final : public PixelStore {
 public:
  FormatStore(std::int32_t width, std::int32_t rows)
      : memory_(hal::Framebuffer<Format>::words(width, rows)), frame_(memory_, width, rows) {}

  void write(std::int32_t x, std::int32_t y, PackedRgb colour) override {
    frame_.open({y, x, 1}).write(encode_at<Format>(colour, x, y));
  }
  void write(std::int32_t x, std::int32_t y, const SurfacePixel& surface) override {
    auto cursor = frame_.open({y, x, 1});
    cursor.write(operated_pixel<Format>(surface, cursor.read(), x, y));
  }
  [[nodiscard]] Rgb8 pixel(std::int32_t x, std::int32_t y) const override { return frame_.pixel(x, y); }
  void read_row(std::int32_t y, std::span<Rgb8> row) const override { decode_row(frame_, y, row); }
  void move_to(std::int32_t first_row) override { frame_.move_to(first_row); }
  void clear(Rgb8 colour) override { frame_.clear(colour); }
  void finish_outlines(const OutlineList& outlines, const OutlineLook& look, const DepthBuffer& depth,
                       SmoothCost& cost) override {
    tools::finish_outlines(outlines, look, frame_, depth, cost);
  }
  [[nodiscard]] Rect bounds() const override { return frame_.bounds(); }
  [[nodiscard]] std::size_t bytes() const override { return memory_.size() * sizeof(typename Format::Word); }

 private:
  std::vector<typename Format::Word> memory_;
  hal::Framebuffer<Format> frame_;
};

template <class Format>
std::unique_ptr<PixelStore> make_store(bool dithers, std::int32_t width, std::int32_t rows) {
  if (dithers) return std::make_unique<FormatStore<Dithered<Format>>>(width, rows);
  return std::make_unique<FormatStore<Format>>(width, rows);
}

}  // namespace

std::unique_ptr<PixelStore> make_pixel_store(const PixelChoice& pixels, std::int32_t width,
                                             std::int32_t rows) {
#define ARCSPAN_MAKE_IF_CHOSEN(name, Format) \
  if (pixels.format == #name) return make_store<Format>(pixels.dithers, width, rows);
  ARCSPAN_FOR_EACH_PIXEL_FORMAT(ARCSPAN_MAKE_IF_CHOSEN)
#undef ARCSPAN_MAKE_IF_CHOSEN
  throw Failure(std::string(pixels.format), "no such pixel format");
}

}  // namespace arcspan::tools
