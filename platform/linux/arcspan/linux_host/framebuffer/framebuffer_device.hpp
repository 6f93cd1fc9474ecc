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

/// A framebuffer device of the kernel (/dev/fb0) in its present mode.
///
/// It is written with pwrite instead of being mapped: this works with every driver, including those that
/// refresh a panel over SPI, and a removed device causes an error instead of a signal. While it is open, the
/// text console does not draw on it. restore(), which the destructor calls, brings back the previous picture.
class FramebufferDevice {
 public:
  FramebufferDevice() = default;
  FramebufferDevice(const FramebufferDevice&) = delete;
  FramebufferDevice& operator=(const FramebufferDevice&) = delete;
  ~FramebufferDevice();

  /// Opens `path` and saves the visible picture. kNotReady if the device does not exist or may not be used.
  /// kUnsupported, with the reason, if it is not a framebuffer or its pixel format is not supported.
  Result open(const char* path);

  /// Size of the visible picture in pixels; 0 if not open.
  [[nodiscard]] std::int32_t width() const { return width_; }
  [[nodiscard]] std::int32_t height() const { return height_; }
  [[nodiscard]] const PixelLayout& layout() const { return layout_; }
  /// Bytes of one visible row in write_rows().
  [[nodiscard]] std::size_t bytes_per_row() const {
    return layout_.bytes_per_row(static_cast<std::size_t>(width_));
  }
  /// Name that the driver reports.
  [[nodiscard]] const char* name() const { return name_; }

  /// Writes `rows`, whole rows of bytes_per_row() bytes without gaps, to the picture from row `first` on.
  /// kInvalidArgument if they do not lie in the picture; kTransferFailed or kTransferShort from the kernel.
  Result write_rows(std::int32_t first, std::span<const std::uint8_t> rows);

  /// Reads the visible picture in the form of write_rows().
  Result read_rows(std::vector<std::uint8_t>& rows);

  /// Restores the picture, palette and console from before open() and closes the device. Tries all of them,
  /// and every row, and returns the first failure. kOk if not open.
  Result restore();

 private:
  Result read_format(int fd);
  Result replace_palette(int fd);
  [[nodiscard]] std::size_t position(std::int32_t row) const;

  FileDescriptor file_;
  ConsoleGuard console_;
  PixelLayout layout_;
  std::int32_t width_ = 0;
  std::int32_t height_ = 0;
  std::size_t pitch_ = 0;   // bytes from one row to the next
  std::size_t origin_ = 0;  // bytes before the first visible pixel
  char name_[17] = {};
  Palette palette_before_;
  std::vector<std::uint8_t> picture_before_;
};

}  // namespace arcspan::linux_host
