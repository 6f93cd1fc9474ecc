// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>
#include <arcspan_tools/image/rgba_image.hpp>

#include <cstdint>
#include <filesystem>
#include <string>

namespace arcspan::tools {

/// The file formats that pictures are written in, by the extension of the name: .ppm (P6), .pgm (P5, luma),
/// .png (8-bit RGB). On standard output (`-`) a picture is a PNG; `ppm:-` and `pgm:-` are the others.
enum class ImageFormat : std::uint8_t { kPpm, kPgm, kPng };

/// The format that a file name asks for. Throws Failure for any other extension.
[[nodiscard]] ImageFormat image_format(const std::filesystem::path& path);

/// The whole file.
[[nodiscard]] std::string encode_image(const Image& image, ImageFormat format);

/// Writes `image` in the format of the path's extension, as write_results() does. Throws Failure.
void write_image(const Image& image, const std::filesystem::path& path, const std::string& summary = {});

/// read_rgba() without the opacity.
[[nodiscard]] Image read_image(const std::filesystem::path& path);

/// Reads a picture file of any kind that decode_rgba() knows, with its opacity. Throws Failure.
[[nodiscard]] RgbaImage read_rgba(const std::filesystem::path& path);

}  // namespace arcspan::tools
