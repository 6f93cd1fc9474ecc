// SPDX-License-Identifier: MIT
// Frames are compressed by the same library as single pictures; only the chunks around them are put together
// here. PNG's third edition: https://www.w3.org/TR/png-3/#apng-chunks.
#include <arcspan/mesh/crc32.hpp>

#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/output/animation.hpp>

#include <string_view>

namespace arcspan::tools {
namespace {

constexpr std::size_t kSignatureBytes = 8;

std::string big_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text.push_back(static_cast<char>((value >> (8 * i)) & 0xFFu));
  return text;
}

std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = (value << 8) | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

std::string chunk(std::string_view type, std::string_view data) {
  const std::string body = std::string(type) + std::string(data);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(body.data());
  return big_endian(static_cast<std::uint32_t>(data.size()), 4) + body +
         big_endian(crc32({bytes, body.size()}), 4);
}

/// The data of all chunks of one type of a PNG that was just encoded.
std::string data_of(std::string_view png, std::string_view type) {
  std::string data;
  for (std::size_t at = kSignatureBytes; at + 12 <= png.size();) {
    const std::size_t size = u32_at(png, at);
    if (png.substr(at + 4, 4) == type) data += png.substr(at + 8, size);
    at += 12 + size;
  }
  return data;
}

/// Shown whole, for `milliseconds`, over whatever was there.
std::string frame_control(std::uint32_t sequence, const Image& frame, std::int32_t milliseconds) {
  return chunk("fcTL", big_endian(sequence, 4) + big_endian(static_cast<std::uint32_t>(frame.width), 4) +
                           big_endian(static_cast<std::uint32_t>(frame.height), 4) + std::string(8, '\0') +
                           big_endian(static_cast<std::uint32_t>(milliseconds), 2) + big_endian(1000, 2) +
                           std::string(2, '\0'));
}

}  // namespace

std::string encode_apng(std::span<const Image> frames, std::int32_t milliseconds) {
  std::string out;
  std::uint32_t sequence = 0;
  for (const Image& frame : frames) {
    const std::string png = encode_image(frame, ImageFormat::kPng);
    if (out.empty()) {
      // The signature, the header, then how many frames there are, and that they repeat for ever.
      out = png.substr(0, kSignatureBytes) + chunk("IHDR", data_of(png, "IHDR")) +
            chunk("acTL", big_endian(static_cast<std::uint32_t>(frames.size()), 4) + big_endian(0, 4)) +
            frame_control(sequence++, frame, milliseconds) + chunk("IDAT", data_of(png, "IDAT"));
      continue;
    }
    out += frame_control(sequence++, frame, milliseconds);
    out += chunk("fdAT", big_endian(sequence++, 4) + data_of(png, "IDAT"));
  }
  return out + chunk("IEND", "");
}

}  // namespace arcspan::tools
