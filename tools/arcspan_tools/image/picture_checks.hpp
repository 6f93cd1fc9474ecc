// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace arcspan::tools {

/// The largest picture file that is read.
inline constexpr std::size_t kMostPictureBytes = std::size_t{1} << 30;
/// The largest width or height of a picture, and its most pixels.
inline constexpr std::int64_t kMostPictureSide = 16384;
inline constexpr std::int64_t kMostPicturePixels = std::int64_t{1} << 26;

/// What the header of a picture says.
struct PictureHeader {
  const char* kind = "";  ///< PNG, JPEG, BMP or TGA
  std::int64_t width = 0;
  std::int64_t height = 0;
};

/// Checks the bytes of a picture file before the library stb decodes them: it divides by a width of 0, copies
/// tables of JPEG whatever their size, takes damaged chunks of PNG for good ones, and draws what a truncated
/// file lacks in some colour. Throws a Failure about `subject` for a kind that is not read (a TGA has no mark
/// of its own: `subject` must end in .tga), a file that is truncated, a checksum that is wrong, a table that
/// is too large, and for a picture without pixels or with too many. Whatever else is wrong is left to the
/// library.
[[nodiscard]] PictureHeader checked_picture(std::string_view bytes, const std::string& subject);

/// Throws a Failure for a picture without pixels, or with more than are read.
void check_picture_size(const PictureHeader& header, const std::string& subject);

}  // namespace arcspan::tools
