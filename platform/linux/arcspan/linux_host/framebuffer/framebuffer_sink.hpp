// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/framebuffer/framebuffer_device.hpp>
#include <arcspan/pixel/sink.hpp>

#include <cstdint>
#include <vector>

namespace arcspan::linux_host {

/// Pixel format of a Linux framebuffer. Its layout is known at run time only, so every row refers to it.
struct FramebufferFormat {
  struct Row {
    std::uint8_t* bytes = nullptr;
    const PixelLayout* layout = nullptr;
  };
  using Encoded = Rgb8;
  using Word = Row;
  static constexpr unsigned kBitsPerPixel = 32;  // upper bound
  static constexpr bool kDithers = false;

  class Cursor {
   public:
    Cursor(const Row* row, std::int32_t x) : row_(*row), x_(static_cast<std::size_t>(x)) {}
    void write(Encoded encoded) { row_.layout->store(row_.bytes, x_, encoded); }
    [[nodiscard]] Encoded read() const { return row_.layout->load(row_.bytes, x_); }
    void next() { ++x_; }

   private:
    Row row_;
    std::size_t x_;
  };

  [[nodiscard]] static std::size_t words_per_row(std::int32_t) { return 1; }
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) { return c; }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t, std::int32_t) { return c; }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) { return encoded; }
};

/// A pixel sink that holds a picture in the layout and size of a framebuffer. show() displays it as a whole,
/// so that no partial picture is visible.
class FramebufferSink {
 public:
  using Format = FramebufferFormat;

  /// `device` must be open and outlive this object. The picture is black at first.
  explicit FramebufferSink(FramebufferDevice& device);

  [[nodiscard]] Rect bounds() const { return {0, 0, device_->width(), device_->height()}; }
  [[nodiscard]] Format::Cursor open(const Span& run) {
    const Format::Row row = this->row(run.y);
    return {&row, run.x};
  }
  [[nodiscard]] Status close(const Span&) { return Status::kOk; }

  /// Sets every pixel to `colour`.
  void clear(Rgb8 colour);
  /// Colour of pixel (x, y), which must lie inside bounds().
  [[nodiscard]] Rgb8 pixel(std::int32_t x, std::int32_t y) const;
  /// Writes the picture to the device.
  Result show() { return device_->write_rows(0, picture_); }

 private:
  [[nodiscard]] Format::Row row(std::int32_t y);

  FramebufferDevice* device_;
  std::vector<std::uint8_t> picture_;
};

static_assert(PixelSink<FramebufferSink>);

}  // namespace arcspan::linux_host
