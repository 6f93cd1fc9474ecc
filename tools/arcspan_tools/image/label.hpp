// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>

#include <string>

namespace arcspan::tools {

/// Height of a line of text at scale 1, in pixels.
inline constexpr std::int32_t kLineHeight = 12;

/// Width of printable ASCII text in pixels.
[[nodiscard]] std::int32_t text_width(std::string text, std::int32_t scale);

/// Writes printable ASCII with its top left corner at (x, y); what lies outside the picture is cut off.
void draw_text(Image& image, std::int32_t x, std::int32_t y, std::string text, std::int32_t scale,
               Rgb8 colour);

/// Fills columns x ... x + width - 1 of rows y ... y + height - 1, as far as they are inside.
void fill(Image& image, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height, Rgb8 colour);

/// Puts `part` with its top left corner at (x, y); it must lie inside.
void paste(Image& image, const Image& part, std::int32_t x, std::int32_t y);

}  // namespace arcspan::tools
