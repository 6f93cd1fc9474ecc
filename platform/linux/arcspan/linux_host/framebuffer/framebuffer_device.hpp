// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/file_descriptor.hpp>
#include <arcspan/linux_host/framebuffer/console_guard.hpp>
#include <arcspan/linux_host/framebuffer/palette.hpp>
#include <arcspan/linux_host/framebuffer/pixel_layout.hpp>
#include <arcspan/linux_host/result.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace arcspan::linux_host {

/// A framebuffer of the kernel (/dev/fb0), as it is set up: nothing of its mode is changed.
///
/// It is written with pwrite, not mapped: that works with every driver, those that refresh a panel over SPI
/// too, and a device that goes away gives an error instead of a signal. While it is open, the text console
/// does not draw on it if it would; what was to be seen before comes back with `restore`, which the
/// destructor calls.
class FramebufferDevice {
 public:
  FramebufferDevice() = default;
  FramebufferDevice(const FramebufferDevice&) = delete;
  FramebufferDevice& operator=(const FramebufferDevice&) = delete;
  ~FramebufferDevice();

  /// Opens `path` and keeps a copy of the visible picture. kNotReady if there is no such device or it may not
  /// be used; kUnsupported, with the reason, if it is no framebuffer or its pixels cannot be drawn.
  Result open(const char* path);

  /// Visible pixels; 0 if not open.
  [[nodiscard]] std::int32_t width() const { return width_; }
  [[nodiscard]] std::int32_t height() const { return height_; }
  [[nodiscard]] const PixelLayout& layout() const { return layout_; }
  /// Bytes of one visible row, as `write_rows` takes them.
  [[nodiscard]] std::size_t bytes_per_row() const {
    return layout_.bytes_per_row(static_cast<std::size_t>(width_));
  }
  /// What the driver calls itself.
  [[nodiscard]] const char* name() const { return name_; }

  /// Shows `rows`, which are a whole number of rows of bytes_per_row() without gaps, from row `first` on.
  /// kInvalidArgument if they do not lie in the picture; kTransferFailed or kTransferShort from the kernel.
  Result write_rows(std::int32_t first, std::span<const std::uint8_t> rows);

  /// The visible picture, in the form of `write_rows`.
  Result read_rows(std::vector<std::uint8_t>& rows);

  /// Shows again what was to be seen before `open`, gives the console back, and closes. The first thing that
  /// goes wrong is returned, the others are done nevertheless. kOk if not open.
  Result restore();

 private:
  Result take_format(int fd);
  Result take_palette(int fd);
  [[nodiscard]] std::size_t position(std::int32_t row) const;

  FileDescriptor file_;
  ConsoleGuard console_;
  PixelLayout layout_;
  std::int32_t width_ = 0;
  std::int32_t height_ = 0;
  std::size_t pitch_ = 0;   // bytes from row to row
  std::size_t origin_ = 0;  // bytes before the first visible pixel
  char name_[17] = {};
  Palette palette_before_;
  std::vector<std::uint8_t> picture_before_;
};

}  // namespace arcspan::linux_host
