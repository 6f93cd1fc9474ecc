// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/framebuffer/pixel_layout.hpp>

#include <bit>
#include <cstring>

namespace arcspan::linux_host {
namespace {

using Channel = PixelLayout::Channel;
using Kind = PixelLayout::Kind;

constexpr Channel kPaletteRed{5, 3};
constexpr Channel kPaletteGreen{2, 3};
constexpr Channel kPaletteBlue{0, 2};

bool read_channel(const fb_bitfield& field, std::uint32_t bits, Channel& channel) {
  if (field.msb_right != 0 || field.length == 0 || field.length > 8 || field.offset > bits - field.length) {
    return false;
  }
  channel = {static_cast<std::uint8_t>(field.offset), static_cast<std::uint8_t>(field.length)};
  return true;
}

constexpr std::uint32_t mask(unsigned length) { return length >= 32 ? ~0U : (1U << length) - 1; }

Result read_colour(const fb_var_screeninfo& variable, PixelLayout& layout) {
  const std::uint32_t bits = variable.bits_per_pixel;
  if (bits != 16 && bits != 24 && bits != 32) {
    return Result::refused("colour pixels are neither 16, 24 nor 32 bits");
  }
  if (!read_channel(variable.red, bits, layout.red) || !read_channel(variable.green, bits, layout.green) ||
      !read_channel(variable.blue, bits, layout.blue)) {
    return Result::refused("colour channels are not 1 to 8 bits inside the pixel");
  }
  const fb_bitfield& alpha = variable.transp;
  if (alpha.length != 0 && alpha.offset < bits)
    layout.always = mask(alpha.length) << alpha.offset & mask(bits);
  return {};
}

std::uint32_t put(std::uint8_t level, Channel channel) {
  return static_cast<std::uint32_t>(level >> (8 - channel.length)) << channel.offset;
}

// Repeats the bits of a short channel until the byte is full.
std::uint8_t get(std::uint32_t word, Channel channel) {
  const std::uint32_t level = word >> channel.offset & mask(channel.length);
  std::uint32_t wide = 0;
  int filled = 0;
  for (; filled < 8; filled += channel.length) wide = wide << channel.length | level;
  return static_cast<std::uint8_t>(wide >> (filled - 8));
}

// 24 bits are the low three bytes of a word: its first ones in memory on little-endian hosts, else its last
// ones.
constexpr std::size_t kLow24 = std::endian::native == std::endian::little ? 0 : 1;

}  // namespace

Result PixelLayout::from_kernel(const fb_fix_screeninfo& fixed, const fb_var_screeninfo& variable,
                                PixelLayout& layout) {
  layout = {};
  if (fixed.type != FB_TYPE_PACKED_PIXELS) return Result::refused("pixels do not lie packed, row by row");
  if (variable.nonstd != 0 || variable.grayscale > 1)
    return Result::refused("the pixel format is not standard");
  layout.bits = static_cast<std::uint8_t>(variable.bits_per_pixel);
  if (variable.bits_per_pixel == 1 &&
      (fixed.visual == FB_VISUAL_MONO01 || fixed.visual == FB_VISUAL_MONO10)) {
    layout.kind = Kind::kMono;
    layout.inverted = fixed.visual == FB_VISUAL_MONO01;  // "1 = black"
    return {};
  }
  if (variable.bits_per_pixel == 8 && variable.grayscale == 1) {
    layout.kind = Kind::kGray;
    return {};
  }
  if (variable.bits_per_pixel == 8 && fixed.visual == FB_VISUAL_PSEUDOCOLOR) {
    layout.kind = Kind::kPalette;
    layout.red = kPaletteRed;
    layout.green = kPaletteGreen;
    layout.blue = kPaletteBlue;
    return {};
  }
  if (fixed.visual == FB_VISUAL_TRUECOLOR && variable.grayscale == 0) return read_colour(variable, layout);
  return Result::refused("the visual is none of true colour, 8-bit palette, 8-bit gray and mono");
}

const char* PixelLayout::pipeline_format() const {
  switch (kind) {
    case Kind::kMono:
      return "mono";
    case Kind::kGray:
      return "gray8";
    case Kind::kPalette:
      return "rgb888";
    case Kind::kColour:
      break;
  }
  return red.length == 5 && green.length == 6 && blue.length == 5 ? "rgb565" : "rgb888";
}

std::uint32_t PixelLayout::encode(Rgb8 colour) const {
  switch (kind) {
    case Kind::kMono:
      return (luma(colour) >= 128) != inverted ? 1 : 0;
    case Kind::kGray:
      return luma(colour);
    case Kind::kPalette:
    case Kind::kColour:
      break;
  }
  return put(colour.r, red) | put(colour.g, green) | put(colour.b, blue) | always;
}

Rgb8 PixelLayout::decode(std::uint32_t word) const {
  switch (kind) {
    case Kind::kMono: {
      const std::uint8_t level = ((word & 1) != 0) != inverted ? 255 : 0;
      return {level, level, level};
    }
    case Kind::kGray: {
      const auto level = static_cast<std::uint8_t>(word);
      return {level, level, level};
    }
    case Kind::kPalette:
    case Kind::kColour:
      break;
  }
  return {get(word, red), get(word, green), get(word, blue)};
}

void PixelLayout::store(std::uint8_t* row, std::size_t x, Rgb8 colour) const {
  const std::uint32_t word = encode(colour);
  if (bits == 1) {
    const unsigned bit = 1U << (x % 8);
    row[x / 8] = static_cast<std::uint8_t>(word != 0 ? row[x / 8] | bit : row[x / 8] & ~bit);
  } else if (bits == 8) {
    row[x] = static_cast<std::uint8_t>(word);
  } else if (bits == 16) {
    const auto half = static_cast<std::uint16_t>(word);
    std::memcpy(row + x * 2, &half, 2);
  } else if (bits == 24) {
    std::memcpy(row + x * 3, reinterpret_cast<const std::uint8_t*>(&word) + kLow24, 3);
  } else {
    std::memcpy(row + x * 4, &word, 4);
  }
}

Rgb8 PixelLayout::load(const std::uint8_t* row, std::size_t x) const {
  std::uint32_t word = 0;
  if (bits == 1) {
    word = row[x / 8] >> (x % 8) & 1U;
  } else if (bits == 8) {
    word = row[x];
  } else if (bits == 16) {
    std::uint16_t half = 0;
    std::memcpy(&half, row + x * 2, 2);
    word = half;
  } else if (bits == 24) {
    std::memcpy(reinterpret_cast<std::uint8_t*>(&word) + kLow24, row + x * 3, 3);
  } else {
    std::memcpy(&word, row + x * 4, 4);
  }
  return decode(word);
}

}  // namespace arcspan::linux_host
