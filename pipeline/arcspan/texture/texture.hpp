// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/status.hpp>
#include <arcspan/texture/texel_formats.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// The size of a texture: width and height as powers of two, and how many mip levels it has. Level i is 2^-i
/// times as wide and high as level 0, which is the picture itself.
struct TextureSize {
  static constexpr unsigned kLeastBits = 3;  ///< 8 texels
  static constexpr unsigned kMostBits = 10;  ///< 1024 texels

  std::uint8_t width_bits = 0;
  std::uint8_t height_bits = 0;
  std::uint8_t levels = 1;

  friend constexpr bool operator==(const TextureSize&, const TextureSize&) = default;

  /// True if both sides have 8...1024 texels and no level has a side below one texel.
  [[nodiscard]] constexpr bool valid() const {
    const unsigned less = width_bits < height_bits ? width_bits : height_bits;
    const unsigned more = width_bits < height_bits ? height_bits : width_bits;
    return less >= kLeastBits && more <= kMostBits && levels >= 1 && levels <= less + 1;
  }
  /// The number of texels of levels 0 ... count - 1.
  [[nodiscard]] constexpr std::uint32_t texels(unsigned count) const {
    std::uint32_t sum = 0;
    for (unsigned i = 0; i < count; ++i) sum += std::uint32_t{1} << (width_bits + height_bits - 2 * i);
    return sum;
  }
};

/// Which texels a pixel shows.
enum class TextureFilter : std::uint8_t {
  kNearest,   ///< the nearest one
  kBilinear,  ///< the four nearest ones, mixed by their distances in 32nds; three times the instructions
};

/// Which texels a texture shows beyond its borders.
enum class TextureWrap : std::uint8_t {
  kRepeat,  ///< the texture again
  kClamp,   ///< the texels along the border
  kMirror,  ///< the texture again, every second time turned over
};

/// How a picture is meant to be shown, in one byte. The filter is for the program, which chooses a method by
/// it: `Textured` names its filter.
struct TextureSampler {
  TextureWrap u : 2 = TextureWrap::kRepeat;  ///< to the left and to the right
  TextureWrap v : 2 = TextureWrap::kRepeat;  ///< above and below
  TextureFilter filter : 1 = TextureFilter::kNearest;

  constexpr TextureSampler() = default;
  constexpr TextureSampler(TextureWrap along_u, TextureWrap along_v,
                           TextureFilter shown_by = TextureFilter::kNearest)
      : u(along_u), v(along_v), filter(shown_by) {}
  friend constexpr bool operator==(const TextureSampler&, const TextureSampler&) = default;

  /// True if both axes repeat.
  [[nodiscard]] constexpr bool repeats() const {
    return u == TextureWrap::kRepeat && v == TextureWrap::kRepeat;
  }
};

/// The code that a method has for what lies beyond the borders of a texture.
enum class TextureBorders : std::uint8_t {
  kRepeat,     ///< none: every texture repeats
  kOfTexture,  ///< that of the texture's sampler; about 15 instructions more per pixel on a Cortex-M3
};

namespace detail::refused {  // the reasons of Texture::of()
void texture_size_not_valid();
void words_fewer_than_the_texture_has();
void palette_smaller_than_the_format_has();
void palette_for_a_format_without();
}  // namespace detail::refused

/// A picture that is mapped onto triangles, in the caller's memory, usually flash, which must outlive it.
/// Nothing is copied. The levels follow each other, each row by row from the top left texel on.
template <TexelFormat Texels>
class Texture {
 public:
  using Format = Texels;
  using Word = typename Texels::Word;

  /// Black, 8×8 texels. A place for make().
  constexpr Texture() = default;

  /// The words that the levels of a texture take.
  [[nodiscard]] static constexpr std::uint32_t words(const TextureSize& size) {
    constexpr std::uint32_t kWordBits = 8 * sizeof(Word);
    return (size.texels(size.levels) * Texels::kBits + kWordBits - 1) / kWordBits;
  }

  /// Makes a texture of `words`, and of a palette if the format has one, that repeats. Returns:
  ///
  ///   kOk                `texture` is set; otherwise it is not changed
  ///   kInvalidArgument   the size is not valid(), or a palette is given that has no use
  ///   kBufferTooSmall    there are fewer words than words(size), or fewer colours than kPaletteSize
  static constexpr Status make(std::span<const Word> words, const TextureSize& size, Texture& texture,
                               std::span<const std::uint16_t> palette = {}) {
    if (!size.valid() || (Texels::kPaletteSize == 0 && !palette.empty())) return Status::kInvalidArgument;
    if (words.size() < Texture::words(size) || palette.size() < Texels::kPaletteSize) {
      return Status::kBufferTooSmall;
    }
    texture.words_ = words.data();
    texture.palette_ = palette.data();
    texture.size_ = size;
    texture.sampler_ = {};
    return Status::kOk;
  }

  /// make() as a constant. Arguments that make() rejects do not compile.
  [[nodiscard]] static consteval Texture of(std::span<const Word> words, const TextureSize& size,
                                            std::span<const std::uint16_t> palette = {}) {
    Texture texture;
    const Status status = make(words, size, texture, palette);
    if (status == Status::kBufferTooSmall) {
      if (words.size() < Texture::words(size)) {
        detail::refused::words_fewer_than_the_texture_has();
      } else {
        detail::refused::palette_smaller_than_the_format_has();
      }
    } else if (!ok(status)) {
      if (!size.valid())
        detail::refused::texture_size_not_valid();
      else
        detail::refused::palette_for_a_format_without();
    }
    return texture;
  }

  /// The texture with another sampler.
  [[nodiscard]] constexpr Texture with(const TextureSampler& sampler) const {
    Texture texture = *this;
    texture.sampler_ = sampler;
    return texture;
  }

  [[nodiscard]] constexpr const TextureSize& size() const { return size_; }
  [[nodiscard]] constexpr const TextureSampler& sampler() const { return sampler_; }
  /// The words that begin with texel `first`, an even number in formats of 4 bits.
  [[nodiscard]] constexpr const Word* at(std::uint32_t first) const {
    constexpr std::uint32_t kTexelsPerWord = 8 * sizeof(Word) / Texels::kBits;
    return words_ + first / kTexelsPerWord;
  }
  [[nodiscard]] constexpr const std::uint16_t* palette() const { return palette_; }
  /// False for a texture that make() has not set.
  [[nodiscard]] constexpr bool is_made() const { return words_ != kBlack; }

 private:
  static constexpr Word kBlack[64] = {};
  static constexpr std::uint16_t kBlackPalette[Texels::kPaletteSize == 0 ? 1 : Texels::kPaletteSize] = {};

  const Word* words_ = kBlack;
  const std::uint16_t* palette_ = kBlackPalette;
  TextureSize size_{3, 3, 1};
  TextureSampler sampler_{};
};

}  // namespace arcspan
