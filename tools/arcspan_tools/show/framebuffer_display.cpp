// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/framebuffer/framebuffer_sink.hpp>

#include <arcspan_tools/show/framebuffer_display.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <optional>

namespace arcspan::tools {
namespace {

class FramebufferDisplay final : public Display {
 public:
  explicit FramebufferDisplay(const std::string& path) : path_(path) {
    check(device_.open(path.c_str()));
    description_ = std::string("framebuffer ") + device_.name() + ", " +
                   std::to_string(device_.layout().bits) + " bits per pixel";
    sink_.emplace(device_);
  }

  [[nodiscard]] Size size() const override { return {device_.width(), device_.height()}; }
  [[nodiscard]] std::string format() const override { return device_.layout().pipeline_format(); }
  [[nodiscard]] std::string description() const override { return description_; }

  void show(const Image& image) override {
    const std::int32_t left = (device_.width() - image.width) / 2;
    const std::int32_t top = (device_.height() - image.height) / 2;
    for (std::int32_t y = 0; y < image.height; ++y) {
      auto cursor = sink_->open({top + y, left, image.width});
      for (std::int32_t x = 0; x < image.width; ++x, cursor.next()) cursor.write(image.at(x, y));
    }
    check(sink_->show());
  }

  void finish() override { check(device_.restore()); }

 private:
  void check(const linux_host::Result& result) const {
    if (!ok(result)) throw Failure(path_, result.text());
  }

  std::string path_;
  linux_host::FramebufferDevice device_;
  std::string description_;
  std::optional<linux_host::FramebufferSink> sink_;
};

}  // namespace

std::unique_ptr<Display> open_framebuffer_display(const std::string& path) {
  return std::make_unique<FramebufferDisplay>(path);
}

}  // namespace arcspan::tools
