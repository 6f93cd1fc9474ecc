// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/little_endian.hpp>
#include <arcspan/status.hpp>
#include <arcspan/texture/texel_formats.hpp>
#include <arcspan/texture/texture.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// How the texels of a texture binary lie in memory. Each is a texel format of texel_formats.hpp; the number
/// of alpha bits says which colour it stores.
enum class TexelLayout : std::uint8_t { kDirect, kPalette8, kPalette4, kGray };

/// The layout of a texture binary (docs/texture-binary.md): little-endian, offsets in bytes.
namespace texture_binary {
inline constexpr std::uint32_t kMagic = 0x54435241;  ///< "ARCT"
inline constexpr std::uint16_t kVersion = 2;

inline constexpr std::size_t kMagicAt = 0;       ///< u32
inline constexpr std::size_t kVersionAt = 4;     ///< u16
inline constexpr std::size_t kLayoutAt = 6;      ///< u8, TexelLayout
inline constexpr std::size_t kAlphaBitsAt = 7;   ///< u8: 0, 1 or 4
inline constexpr std::size_t kSizeAt = 8;        ///< u32, bytes of the whole binary
inline constexpr std::size_t kWidthBitsAt = 12;  ///< u8, TextureSize::width_bits
inline constexpr std::size_t kHeightBitsAt = 13;
inline constexpr std::size_t kLevelsAt = 14;   ///< u8, TextureSize::levels
inline constexpr std::size_t kSamplerAt = 15;  ///< u8, sampler_byte()
inline constexpr std::size_t kHeaderBytes = 16;
inline constexpr std::size_t kChecksumBytes = 4;  ///< u32, crc32() of all bytes before it

/// A sampler in a byte: the wrap of u in bits 0 and 1, that of v in bits 2 and 3, the filter in bit 4.
[[nodiscard]] constexpr std::uint8_t sampler_byte(const TextureSampler& sampler) {
  const auto u = static_cast<unsigned>(sampler.u);
  const auto v = static_cast<unsigned>(sampler.v);
  return static_cast<std::uint8_t>(u | v << 2 | static_cast<unsigned>(sampler.filter) << 4);
}
/// The number of colours of a palette.
[[nodiscard]] constexpr std::uint32_t palette_size(TexelLayout layout) {
  if (layout == TexelLayout::kPalette8) return 256;
  return layout == TexelLayout::kPalette4 ? 16 : 0;
}
/// The bytes of all levels.
[[nodiscard]] constexpr std::uint32_t texel_bytes(TexelLayout layout, const TextureSize& size) {
  const std::uint32_t texels = size.texels(size.levels);
  if (layout == TexelLayout::kDirect) return 2 * texels;
  return layout == TexelLayout::kPalette4 ? (texels + 1) / 2 : texels;
}
/// Size of a whole binary in bytes, for a size that is valid().
[[nodiscard]] constexpr std::uint32_t bytes(TexelLayout layout, const TextureSize& size) {
  constexpr std::uint32_t kAround = kHeaderBytes + kChecksumBytes;
  return ((2 * palette_size(layout) + texel_bytes(layout, size) + 3) & ~std::uint32_t{3}) + kAround;
}
}  // namespace texture_binary

/// A texture in a binary, whose format is known when the program runs.
struct StoredTexture {
  TexelLayout layout = TexelLayout::kDirect;
  std::uint8_t alpha_bits = 0;
  TextureSize size{};
  TextureSampler sampler{};
  std::span<const std::uint8_t> texels;    ///< at an even address; empty if there is no texture
  std::span<const std::uint16_t> palette;  ///< as many colours as the layout has
};

/// Finds the texture in a binary that `arcspan texture -o NAME.bin` has written. Nothing is copied, so
/// `bytes` must outlive the texture. `bytes` may be longer than the binary. The whole binary is checked once,
/// in time linear in its size. Returns:
///
///   kOk                `texture` is set; otherwise it is not changed
///   kInvalidArgument   `bytes` does not begin at an even address
///   kUnsupported       the magic number or the version is another, or this machine is big-endian
///   kTruncated         there are fewer bytes than a header has, or than the header states
///   kCorrupted         the checksum is wrong, the sampler unknown, or format, sides, levels and size
///                      contradict each other
[[nodiscard]] Status view_texture_binary(std::span<const std::uint8_t> bytes, StoredTexture& texture);

namespace detail {

template <class Texels>
inline constexpr int kLayoutOf = -1;
template <TexelColour C>
inline constexpr int kLayoutOf<DirectTexels<C>> = static_cast<int>(TexelLayout::kDirect);
template <TexelColour C>
inline constexpr int kLayoutOf<Palette8Texels<C>> = static_cast<int>(TexelLayout::kPalette8);
template <TexelColour C>
inline constexpr int kLayoutOf<Palette4Texels<C>> = static_cast<int>(TexelLayout::kPalette4);
template <>
inline constexpr int kLayoutOf<GrayTexels> = static_cast<int>(TexelLayout::kGray);

}  // namespace detail

/// True if `texture` has the format Texels.
template <TexelFormat Texels>
[[nodiscard]] constexpr bool has_format(const StoredTexture& texture) {
  static_assert(detail::kLayoutOf<Texels> >= 0, "texture binaries have the formats of texel_formats.hpp");
  return static_cast<int>(texture.layout) == detail::kLayoutOf<Texels> &&
         texture.alpha_bits == Texels::ColourFormat::kAlphaBits;
}

/// Makes a texture of the format Texels. Returns kUnsupported, and changes nothing, if `stored` has another
/// format, otherwise the status of Texture::make().
template <TexelFormat Texels>
[[nodiscard]] Status view_texture(const StoredTexture& stored, Texture<Texels>& texture) {
  using Word = typename Texels::Word;
  if (!has_format<Texels>(stored)) return Status::kUnsupported;
  const Word* const words = detail::elements_at<Word>(stored.texels.data());
  const Status status = Texture<Texels>::make(std::span(words, stored.texels.size() / sizeof(Word)),
                                              stored.size, texture, stored.palette);
  if (ok(status)) texture = texture.with(stored.sampler);
  return status;
}

/// Finds the texture in a binary and makes a texture of it. Returns kUnsupported also if the binary has
/// another format.
template <TexelFormat Texels>
[[nodiscard]] Status view_texture_binary(std::span<const std::uint8_t> bytes, Texture<Texels>& texture) {
  StoredTexture stored;
  const Status status = view_texture_binary(bytes, stored);
  return ok(status) ? view_texture(stored, texture) : status;
}

}  // namespace arcspan
