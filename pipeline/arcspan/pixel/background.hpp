// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/fill.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

/// Backgrounds other than the colour of hal::Framebuffer::clear(). They are functions of the place in the
/// picture, so each band of a picture gets its own part.
namespace arcspan {

/// Colours from the upper row of a picture to the lower one.
struct VerticalGradient {
  Rgb8 top;             ///< colour of row 0
  Rgb8 bottom;          ///< colour of row `height` - 1
  std::int32_t height;  ///< rows of the picture, 1...32767
};

/// A picture in pixels of the sink's format, which may lie in flash.
template <PixelFormat F>
struct BackgroundPicture {
  std::span<const typename F::Word> words;  ///< rows one after another, each F::words_per_row(width) words
  std::int32_t width;                       ///< 1...32767
  std::int32_t height;                      ///< 1...32767
};

namespace detail {

/// The level of a channel in row y of a gradient, 0...1023 as PackedRgb has it. `step` is the change per row
/// with 16 fraction bits.
[[nodiscard]] constexpr std::uint32_t gradient_level(std::uint8_t top, std::int32_t step, std::int32_t y) {
  constexpr std::int32_t kHalf = std::int32_t{1} << 15;
  return static_cast<std::uint32_t>(((std::int32_t{top} << 16) + step * y + kHalf) >> 14);
}

}  // namespace detail

/// Draws one colour, without dither, as Framebuffer::clear() does. Returns the first status of the sink that
/// is not kOk.
template <PixelSink Sink>
[[nodiscard]] constexpr Status draw_background(Sink& sink, Rgb8 colour) {
  const Rect bounds = sink.bounds();
  if (const Status status = detail::status_of(sink); !ok(status) || bounds.empty()) return status;
  return detail::fill_rows(sink, bounds, Sink::Format::encode(colour));
}

/// Draws the rows of the gradient that the sink takes; rows beyond it have its nearest colour. Returns
/// kInvalidArgument and draws nothing if the height is not 1...32767, else the first status of the sink that
/// is not kOk. The levels of a row are rounded to 8 bits, and dithered if the format dithers.
template <PixelSink Sink>
[[nodiscard]] constexpr Status draw_background(Sink& sink, const VerticalGradient& gradient) {
  using Format = typename Sink::Format;
  if (gradient.height < 1 || gradient.height > 32767) return Status::kInvalidArgument;
  const std::int32_t last = gradient.height - 1;
  const auto step = [last](std::uint8_t top, std::uint8_t bottom) {
    return last == 0 ? 0 : ((std::int32_t{bottom} - top) * (std::int32_t{1} << 16)) / last;
  };
  const std::int32_t r = step(gradient.top.r, gradient.bottom.r);
  const std::int32_t g = step(gradient.top.g, gradient.bottom.g);
  const std::int32_t b = step(gradient.top.b, gradient.bottom.b);
  const Rect bounds = sink.bounds();
  if (const Status status = detail::status_of(sink); !ok(status) || bounds.empty()) return status;
  return detail::draw_rows(sink, bounds, [&](auto cursor, const Span& run) {
    const std::int32_t row = run.y < 0 ? 0 : run.y < last ? run.y : last;
    const PackedRgb colour = PackedRgb::of(detail::gradient_level(gradient.top.r, r, row),
                                           detail::gradient_level(gradient.top.g, g, row),
                                           detail::gradient_level(gradient.top.b, b, row));
    if constexpr (Format::kDithers) {
      for (std::int32_t i = 0; i < run.count; ++i, cursor.next())
        cursor.write(encode_at<Format>(colour, run.x + i, run.y));
    } else {
      fill_pixels(cursor, run.count, encode_at<Format>(colour, run.x, run.y));
    }
  });
}

/// Draws the part of the picture that the sink takes, pixel for pixel. Returns kInvalidArgument and draws
/// nothing if a side is not 1...32767 or the sink reaches beyond the picture, kBufferTooSmall if `words` do
/// not hold it, else the first status of the sink that is not kOk.
template <PixelSink Sink>
[[nodiscard]] constexpr Status draw_background(Sink& sink,
                                               const BackgroundPicture<typename Sink::Format>& picture) {
  using Format = typename Sink::Format;
  using Word = typename Format::Word;
  const Rect bounds = sink.bounds();
  if (picture.width < 1 || picture.width > 32767 || picture.height < 1 || picture.height > 32767)
    return Status::kInvalidArgument;
  if (const Status status = detail::status_of(sink); !ok(status) || bounds.empty()) return status;
  if (bounds.left < 0 || bounds.top < 0 || bounds.right > picture.width || bounds.bottom > picture.height)
    return Status::kInvalidArgument;
  const std::size_t per_row = Format::words_per_row(picture.width);
  if (picture.words.size() / per_row < static_cast<std::size_t>(picture.height))
    return Status::kBufferTooSmall;
  return detail::draw_rows(sink, bounds, [&](auto cursor, const Span& run) {
    // A cursor takes memory that can be written, but reading changes nothing.
    auto* row = const_cast<Word*>(picture.words.data()) + static_cast<std::size_t>(run.y) * per_row;
    copy_pixels(typename Format::Cursor(row, run.x), run.count, cursor);
  });
}

}  // namespace arcspan
