// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>

#include <string>
#include <string_view>

namespace arcspan::tools {

/// `image` as a binary PPM (P6).
[[nodiscard]] std::string ppm(const Image& image);

/// The luma of `image` as a binary PGM (P5).
[[nodiscard]] std::string pgm(const Image& image);

/// Whether `bytes` begin as a binary PPM or PGM.
[[nodiscard]] bool is_netpbm(std::string_view bytes);

/// The first picture of a binary PPM or PGM. Values are scaled from the file's maximum (1...65,535) to 255.
/// Throws a Failure about `subject` for a header that is not as the formats ask, a side of 0 or more than
/// 16,384 pixels, a value above the maximum, and a file that ends too early.
[[nodiscard]] Image read_netpbm(std::string_view bytes, const std::string& subject);

}  // namespace arcspan::tools
