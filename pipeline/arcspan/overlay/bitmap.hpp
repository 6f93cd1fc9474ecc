// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/overlay/area.hpp>
#include <arcspan/pixel/mixed_pixels.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>
#include <arcspan/texture/texel_formats.hpp>
#include <arcspan/texture/texture.hpp>

#include <cstdint>
#include <span>

namespace arcspan::overlay {

/// A picture of any size in the caller's memory, usually flash, which must outlive it. Its pixels are those
/// of textures, with 0, 1 or 4 bits of opacity: `Palette4Texels<Alpha1Colour>` for most icons. They follow
/// each other row by row from the upper left one on, also from the middle of a byte.
template <TexelFormat Texels>
class Bitmap {
 public:
  using Format = Texels;
  using Word = typename Texels::Word;
  static constexpr std::int32_t kMostSide = 8192;

  /// A bitmap without pixels. A place for make().
  constexpr Bitmap() = default;
  /// The picture of a texture: its level 0.
  explicit constexpr Bitmap(const Texture<Texels>& texture)
      : words_(texture.at(0)),
        palette_(texture.palette()),
        width_(std::int32_t{1} << texture.size().width_bits),
        height_(std::int32_t{1} << texture.size().height_bits) {}

  /// The words of a bitmap; sides are 1...kMostSide.
  [[nodiscard]] static constexpr std::uint32_t words(std::int32_t width, std::int32_t height) {
    constexpr std::uint32_t kWordBits = 8 * sizeof(Word);
    const std::uint32_t pixels = static_cast<std::uint32_t>(width) * static_cast<std::uint32_t>(height);
    return (pixels * Texels::kBits + kWordBits - 1) / kWordBits;
  }

  /// Makes a bitmap of `words`, and of a palette if the format has one. Returns:
  ///
  ///   kOk                `bitmap` is set; otherwise it is not changed
  ///   kInvalidArgument   a side is not in 1...kMostSide, or a palette is given that has no use
  ///   kBufferTooSmall    there are fewer words than words(width, height), or fewer colours than kPaletteSize
  static constexpr Status make(std::span<const Word> words, std::int32_t width, std::int32_t height,
                               Bitmap& bitmap, std::span<const std::uint16_t> palette = {}) {
    if (width < 1 || height < 1 || width > kMostSide || height > kMostSide ||
        (Texels::kPaletteSize == 0 && !palette.empty()))
      return Status::kInvalidArgument;
    if (words.size() < Bitmap::words(width, height) || palette.size() < Texels::kPaletteSize)
      return Status::kBufferTooSmall;
    bitmap.words_ = words.data();
    bitmap.palette_ = palette.data();
    bitmap.width_ = width;
    bitmap.height_ = height;
    return Status::kOk;
  }

  /// make() as a constant. Arguments that make() rejects do not compile.
  [[nodiscard]] static consteval Bitmap of(std::span<const Word> words, std::int32_t width,
                                           std::int32_t height, std::span<const std::uint16_t> palette = {}) {
    Bitmap bitmap;
    const Status status = make(words, width, height, bitmap, palette);
    if (!ok(status)) arcspan::detail::refuse(status);
    return bitmap;
  }

  [[nodiscard]] constexpr std::int32_t width() const { return width_; }
  [[nodiscard]] constexpr std::int32_t height() const { return height_; }
  /// The pixel of this number as its ColourFormat stores it.
  [[nodiscard]] constexpr std::uint16_t stored(std::uint32_t index) const {
    return Texels::stored(words_, palette_, index);
  }

 private:
  const Word* words_ = nullptr;
  const std::uint16_t* palette_ = nullptr;
  std::int32_t width_ = 0;
  std::int32_t height_ = 0;
};

namespace detail {

/// Writes or mixes one pixel of a bitmap.
template <TexelColour Colour, PixelFormat F>
constexpr void put_texel(typename F::Cursor& cursor, std::uint16_t stored) {
  const std::uint16_t colour = Colour::rgb565(stored);
  typename F::Encoded encoded{};
  if constexpr (arcspan::detail::Rgb565Words<F>)
    encoded = F::word565(colour);
  else
    encoded = F::encode(Rgb565::decode(colour));
  if constexpr (Colour::kAlphaBits > 1) {
    const std::uint32_t alpha = Colour::alpha(stored);
    if (alpha < 16) encoded = arcspan::detail::mixed_pixels<F>(cursor.read(), encoded, 2 * alpha);
  }
  cursor.write(encoded);
}

/// The number of pixels from `index` on, at most `most`, that are transparent, or that are not.
template <TexelFormat Texels>
[[nodiscard]] constexpr std::int32_t run_length(const Bitmap<Texels>& bitmap, std::uint32_t index,
                                                std::int32_t most, bool transparent) {
  using Colour = typename Texels::ColourFormat;
  if constexpr (Colour::kAlphaBits == 0) return transparent ? 0 : most;
  std::int32_t count = 0;
  while (count < most &&
         (Colour::alpha(bitmap.stored(index + static_cast<std::uint32_t>(count))) == 0) == transparent)
    ++count;
  return count;
}

}  // namespace detail

/// Draws a bitmap whose upper left pixel is `at`. Pixels of opacity 0 are left alone, those between are mixed
/// with the picture. Returns the first status of the sink that is not kOk, else kOk.
template <PixelSink Sink, TexelFormat Texels>
constexpr Status draw_bitmap(Sink& sink, Point at, const Bitmap<Texels>& bitmap) {
  using Format = typename Sink::Format;
  if (const Status status = detail::status_of(sink); !ok(status)) return status;
  const Rect visible =
      detail::intersection(detail::rect_at(at, bitmap.width(), bitmap.height()), sink.bounds());
  if (visible.empty()) return Status::kOk;
  for (std::int32_t y = visible.top; y < visible.bottom; ++y) {
    const auto row = static_cast<std::uint32_t>(y - at.y) * static_cast<std::uint32_t>(bitmap.width());
    for (std::int32_t x = visible.left; x < visible.right;) {
      std::uint32_t index = row + static_cast<std::uint32_t>(x - at.x);
      const std::int32_t skipped = detail::run_length(bitmap, index, visible.right - x, true);
      x += skipped;
      index += static_cast<std::uint32_t>(skipped);
      const Span run{y, x, detail::run_length(bitmap, index, visible.right - x, false)};
      if (run.count == 0) continue;
      typename Format::Cursor cursor = sink.open(run);
      for (std::int32_t left = run.count; left > 0; --left, cursor.next())
        detail::put_texel<typename Texels::ColourFormat, Format>(cursor, bitmap.stored(index++));
      if (const Status status = sink.close(run); !ok(status)) return status;
      x += run.count;
    }
  }
  return Status::kOk;
}

}  // namespace arcspan::overlay
