// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/linux_host/result.hpp>
#include <arcspan/pixel/colour.hpp>

#include <linux/fb.h>

#include <cstddef>
#include <cstdint>

namespace arcspan::linux_host {

/// How the kernel says that a framebuffer stores a pixel (fb_var_screeninfo, fb_fix_screeninfo of
/// linux/fb.h).
///
/// Words are in the machine's byte order, as the kernel's own drawing has them.
struct PixelLayout {
  enum class Kind : std::uint8_t {
    kColour,   ///< 16, 24 or 32 bits with three bit fields
    kPalette,  ///< 8 bits, an index into a palette that the owner sets to rrrgggbb
    kGray,     ///< 8 bits, luma
    kMono,     ///< 1 bit, the leftmost pixel lowest in its byte
  };
  /// A bit field: `length` 1 ... 8 bits, the lowest of which is bit `offset` of the word.
  struct Channel {
    std::uint8_t offset = 0;
    std::uint8_t length = 0;
  };

  Kind kind = Kind::kColour;
  std::uint8_t bits = 16;
  Channel red;
  Channel green;
  Channel blue;
  /// Bits that are set in every colour word: full alpha, where there is one.
  std::uint32_t always = 0;
  /// kMono: a set bit is dark.
  bool inverted = false;

  /// Takes the layout from what the kernel reports. kUnsupported, with the reason, for what cannot be drawn.
  static Result from_kernel(const fb_fix_screeninfo& fixed, const fb_var_screeninfo& variable,
                            PixelLayout& layout);

  /// The format of the pipeline whose pixels this layout holds without loss and without waste: "rgb565",
  /// "rgb888", "gray8" or "mono".
  [[nodiscard]] const char* pipeline_format() const;

  [[nodiscard]] std::size_t bytes_per_row(std::size_t width) const { return (width * bits + 7) / 8; }

  /// The word for `colour`; channels are cut to their lengths.
  [[nodiscard]] std::uint32_t encode(Rgb8 colour) const;
  /// The colour of a word, short channels widened so that full stays full.
  [[nodiscard]] Rgb8 decode(std::uint32_t word) const;

  /// Stores and reads pixel `x` of a row that begins at `row`.
  void store(std::uint8_t* row, std::size_t x, Rgb8 colour) const;
  [[nodiscard]] Rgb8 load(const std::uint8_t* row, std::size_t x) const;
};

}  // namespace arcspan::linux_host
