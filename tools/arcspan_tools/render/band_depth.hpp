// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/span/depth.hpp>

#include <arcspan_tools/image/image.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace arcspan::tools {

/// A depth buffer with its memory.
class BandDepth {
 public:
  BandDepth(std::int32_t width, std::int32_t rows)
      : memory_(DepthBuffer::words(width, rows), DepthBuffer::kFarthest), buffer_(memory_, width, rows) {}

  [[nodiscard]] const DepthBuffer& buffer() const { return buffer_; }
  void start(std::int32_t first_row) {
    buffer_.move_to(first_row);
    buffer_.clear();
  }
  [[nodiscard]] std::size_t bytes() const { return memory_.size() * sizeof(std::uint16_t); }

 private:
  std::vector<std::uint16_t> memory_;
  DepthBuffer buffer_;
};

/// Decodes row y of a framebuffer.
template <class Frame>
void decode_row(const Frame& frame, std::int32_t y, std::span<Rgb8> row) {
  std::int32_t x = 0;
  for (Rgb8& pixel : row) pixel = frame.pixel(x++, y);
}

/// Copies the rows of a band into the picture.
template <class Band>
void copy_rows(const Band& band, std::int32_t first, std::int32_t rows, Image& image) {
  const std::int32_t end = std::min(first + rows, image.height);
  for (std::int32_t y = first; y < end; ++y) band.read_row(y, image.row(y));
}

}  // namespace arcspan::tools
