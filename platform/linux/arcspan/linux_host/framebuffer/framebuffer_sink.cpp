// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/framebuffer/framebuffer_sink.hpp>

namespace arcspan::linux_host {

FramebufferSink::FramebufferSink(FramebufferDevice& device)
    : device_(&device), picture_(device.bytes_per_row() * static_cast<std::size_t>(device.height())) {
  clear({});
}

FramebufferFormat::Row FramebufferSink::row(std::int32_t y) {
  return {picture_.data() + device_->bytes_per_row() * static_cast<std::size_t>(y), &device_->layout()};
}

void FramebufferSink::clear(Rgb8 colour) {
  for (std::int32_t y = 0; y < device_->height(); ++y) {
    Format::Cursor cursor = open({y, 0, device_->width()});
    for (std::int32_t x = 0; x < device_->width(); ++x, cursor.next()) cursor.write(colour);
  }
}

Rgb8 FramebufferSink::pixel(std::int32_t x, std::int32_t y) const {
  const std::uint8_t* bytes = picture_.data() + device_->bytes_per_row() * static_cast<std::size_t>(y);
  return device_->layout().load(bytes, static_cast<std::size_t>(x));
}

}  // namespace arcspan::linux_host
