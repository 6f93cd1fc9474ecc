// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace arcspan::tools {

/// The largest picture file that is read.
inline constexpr std::size_t kMostPictureBytes = std::size_t{1} << 30;

[[nodiscard]] bool is_png(std::string_view bytes);
[[nodiscard]] bool is_jpeg(std::string_view bytes);
[[nodiscard]] bool is_bmp(std::string_view bytes);

// The library takes damaged chunks of PNG for good ones and draws what a truncated file lacks in some colour.
// These throw a Failure about `subject` for a truncated file, check_png() also for a wrong checksum. Whatever
// else is wrong is left to the library.
void check_png(std::string_view bytes, const std::string& subject);
void check_jpeg(std::string_view bytes, const std::string& subject);
void check_bmp(std::string_view bytes, const std::string& subject);
void check_tga(std::string_view bytes, const std::string& subject);

}  // namespace arcspan::tools
