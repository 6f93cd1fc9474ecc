// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/linux_host/result.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace arcspan::linux_host {

/// A display of a graphics card (/dev/dri/card0) in its preferred mode, through DRM and libdrm.
///
/// Two pictures in memory take turns: one is visible, the other one is drawn and then shown as a whole by a
/// page flip. The driver selects the pixel format, Rgb565 or Xrgb8888. restore(), which the destructor calls,
/// brings back the former mode and picture. While it is open no other program can use the card's displays.
class DrmDevice {
 public:
  DrmDevice();
  DrmDevice(const DrmDevice&) = delete;
  DrmDevice& operator=(const DrmDevice&) = delete;
  ~DrmDevice();

  /// Opens `path` and chooses the first connected display; the visible picture stays until show(). Both
  /// pictures are black. kNotReady if the device does not exist or may not be used, or if no display is
  /// connected; kBusy if another program holds the displays; kBufferTooSmall if the driver has no memory for
  /// the pictures; kUnsupported, with the reason, if it is not a graphics card or arcspan was built without
  /// libdrm.
  Result open(const char* path);

  /// Size of the display in pixels; 0 if not open.
  [[nodiscard]] std::int32_t width() const;
  [[nodiscard]] std::int32_t height() const;
  /// Bits per pixel: 16 for Rgb565, 32 for Xrgb8888; 0 if not open.
  [[nodiscard]] unsigned bits() const;
  /// Names of the driver and of the connector, e.g. "vc4" and "HDMI-A-1"; empty if not open.
  [[nodiscard]] const std::string& driver() const;
  [[nodiscard]] const std::string& connector() const;

  /// The part `area` of the hidden picture as a pixel sink, which can be used until the next show() or
  /// restore(). F is the format that bits() stands for. status() of the window is kInvalidArgument if `area`
  /// does not lie in the picture, kBufferTooSmall for another format.
  template <PixelFormat F>
  [[nodiscard]] hal::FramebufferWindow<F> window(const Rect& area) const {
    const bool inside = area.left >= 0 && area.left <= area.right && area.right <= width() && area.top >= 0 &&
                        area.top <= area.bottom && area.bottom <= height();
    constexpr auto kWord = static_cast<std::int32_t>(sizeof(typename F::Word));
    const Rect held = inside ? Rect{0, 0, area.width(), area.height()} : Rect{0, 0, -1, 0};
    if (!inside || 8 * sizeof(typename F::Word) != bits()) return {{}, held, kWord * stride()};
    const std::span bytes(static_cast<std::byte*>(memory()), memory_words() * sizeof(typename F::Word));
    const auto offset = static_cast<std::size_t>(area.top * stride() + area.left) * sizeof(typename F::Word);
    return {bytes.subspan(offset < bytes.size() ? offset : bytes.size()), held, kWord * stride()};
  }

  /// Shows the hidden picture and hides the visible one, which can then be drawn. Waits until this is done,
  /// on most drivers for the next refresh. kNotReady if not open, kTimeout if the display does not answer
  /// within a second; kTransferFailed from the kernel.
  Result show();

  /// Restores the mode and the picture from before open() and closes the device. kOk if not open.
  Result restore();

 private:
  struct State;

  [[nodiscard]] void* memory() const;
  [[nodiscard]] std::size_t memory_words() const;
  [[nodiscard]] std::int32_t stride() const;

  std::unique_ptr<State> state_;
};

/// Whether `path` is a device of DRM, such as /dev/dri/card0.
[[nodiscard]] bool is_drm_device(const char* path);

}  // namespace arcspan::linux_host
