// SPDX-License-Identifier: MIT
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/rgb888.hpp>

#include <arcspan_tools/render/any_format.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <string>

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
  [[nodiscard]] Rgb8 pixel(std::int32_t x, std::int32_t y) const override { return frame_.pixel(x, y); }
  void move_to(std::int32_t first_row) override { frame_.move_to(first_row); }
  void clear(Rgb8 colour) override { frame_.clear(colour); }
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

using StoreMaker = std::unique_ptr<PixelStore> (*)(bool, std::int32_t, std::int32_t);

struct NamedFormat {
  std::string_view name;
  StoreMaker make;
};

constexpr NamedFormat kFormats[] = {{"rgb565", &make_store<Rgb565>},
                                    {"rgb888", &make_store<Rgb888>},
                                    {"gray8", &make_store<Gray8>},
                                    {"gray4", &make_store<Gray4>},
                                    {"mono", &make_store<Mono>}};

}  // namespace

std::unique_ptr<PixelStore> make_pixel_store(std::string_view format, bool dithers, std::int32_t width,
                                             std::int32_t rows) {
  for (const NamedFormat& named : kFormats) {
    if (named.name == format) return named.make(dithers, width, rows);
  }
  throw Failure(std::string(format), "no such pixel format");
}

}  // namespace arcspan::tools
