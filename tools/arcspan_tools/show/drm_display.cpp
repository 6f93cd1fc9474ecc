// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/drm/drm_device.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/xrgb8888.hpp>

#include <arcspan_tools/render/pixel_format_name.hpp>
#include <arcspan_tools/show/drm_display.hpp>
#include <arcspan_tools/support/failure.hpp>

namespace arcspan::tools {
namespace {

class DrmDisplay final : public Display {
 public:
  explicit DrmDisplay(const std::string& path) : path_(path) {
    check(device_.open(path.c_str()));
    description_ = device_.connector() + " of DRM driver " + device_.driver() + ", " +
                   std::to_string(device_.bits()) + " bits per pixel";
  }

  [[nodiscard]] Size size() const override { return {device_.width(), device_.height()}; }
  [[nodiscard]] std::string format() const override {
    return std::string(is_16_bit() ? pixel_format_name<Rgb565>() : pixel_format_name<Xrgb8888>());
  }
  [[nodiscard]] std::string description() const override { return description_; }

  void show(const Image& image) override {
    if (is_16_bit()) {
      draw<Rgb565>(image);
    } else {
      draw<Xrgb8888>(image);
    }
    check(device_.show());
  }

  void finish() override { check(device_.restore()); }

 private:
  [[nodiscard]] bool is_16_bit() const { return device_.bits() == Rgb565::kBitsPerPixel; }

  template <class Format>
  void draw(const Image& image) const {
    const std::int32_t left = (device_.width() - image.width) / 2;
    const std::int32_t top = (device_.height() - image.height) / 2;
    const auto window = device_.window<Format>({left, top, left + image.width, top + image.height});
    if (!ok(window.status())) throw Failure(path_, to_string(window.status()));
    for (std::int32_t y = 0; y < image.height; ++y) {
      typename Format::Cursor cursor(window.row(y), 0);
      for (std::int32_t x = 0; x < image.width; ++x, cursor.next()) {
        cursor.write(Format::encode(image.at(x, y)));
      }
    }
  }

  void check(const linux_host::Result& result) const {
    if (!ok(result)) throw Failure(path_, result.text());
  }

  std::string path_;
  linux_host::DrmDevice device_;
  std::string description_;
};

}  // namespace

std::unique_ptr<Display> open_drm_display(const std::string& path) {
  return std::make_unique<DrmDisplay>(path);
}

}  // namespace arcspan::tools
