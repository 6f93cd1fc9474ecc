// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/result.hpp>
#include <arcspan/pixel/colour.hpp>

#include <linux/fb.h>

#include <cstddef>
#include <cstdint>

namespace arcspan::linux_host {

/// Pixel layout of a framebuffer, from fb_var_screeninfo and fb_fix_screeninfo of linux/fb.h.
///
/// Words are in the host's byte order, as in the kernel's own drawing.
struct PixelLayout {
  enum class Kind : std::uint8_t {
    kColour,   ///< 16, 24 or 32 bits with three bit fields
    kPalette,  ///< 8 bits, an index into a palette set to Palette::rgb332()
    kGray,     ///< 8 bits, luma
    kMono,     ///< 1 bit, the leftmost pixel in the lowest bit of its byte
  };
  /// A bit field of `length` bits, 1 ... 8, whose lowest bit is bit `offset` of the word.
  struct Channel {
    std::uint8_t offset = 0;
    std::uint8_t length = 0;
  };

  Kind kind = Kind::kColour;
  std::uint8_t bits = 16;
  Channel red;
  Channel green;
  Channel blue;
  /// Bits that are set in every colour word: full opacity, if there is an alpha channel.
  std::uint32_t always = 0;
  /// kMono: a set bit is black.
  bool inverted = false;

  /// Derives the layout from the kernel's report. kUnsupported, with the reason, if it is not supported.
  static Result from_kernel(const fb_fix_screeninfo& fixed, const fb_var_screeninfo& variable,
                            PixelLayout& layout);

  /// The smallest pipeline format that this layout shows without loss: "rgb565", "rgb888", "gray8" or "mono".
  [[nodiscard]] const char* pipeline_format() const;

  [[nodiscard]] std::size_t bytes_per_row(std::size_t width) const { return (width * bits + 7) / 8; }

  /// Word for `colour`; channels are truncated to their lengths.
  [[nodiscard]] std::uint32_t encode(Rgb8 colour) const;
  /// Colour of a word; short channels are expanded so that the maximum becomes 255.
  [[nodiscard]] Rgb8 decode(std::uint32_t word) const;

  /// Store and load pixel `x` of the row at `row`.
  void store(std::uint8_t* row, std::size_t x, Rgb8 colour) const;
  [[nodiscard]] Rgb8 load(const std::uint8_t* row, std::size_t x) const;
};

}  // namespace arcspan::linux_host
