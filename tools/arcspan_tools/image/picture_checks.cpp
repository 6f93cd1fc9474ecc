// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>

#include <arcspan_tools/image/picture_checks.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace arcspan::tools {
namespace {

std::uint32_t big_u32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = (value << 8) | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

std::uint32_t byte_at(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

std::uint32_t little_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value |= byte_at(bytes, at + i) << (8 * i);
  return value;
}

/// Throws a Failure unless `bytes` has `needed` ones.
void require_bytes(std::string_view bytes, std::uint64_t needed, const char* kind,
                   const std::string& subject) {
  if (bytes.size() < needed) throw Failure(subject, std::string("a truncated ") + kind + " picture");
}

}  // namespace

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }

bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xFF\xD8\xFF"); }

bool is_bmp(std::string_view bytes) { return bytes.starts_with("BM"); }

void check_png(std::string_view bytes, const std::string& subject) {
  constexpr std::size_t kSignatureBytes = 8;
  constexpr std::size_t kAroundData = 12;  // length, type, checksum
  for (std::size_t at = kSignatureBytes; at < bytes.size();) {
    const std::size_t left = bytes.size() - at;
    if (left < kAroundData || big_u32(bytes, at) > left - kAroundData)
      throw Failure(subject, "a truncated PNG picture");
    const std::size_t size = big_u32(bytes, at);
    const auto* checked = reinterpret_cast<const std::uint8_t*>(bytes.data()) + at + 4;
    if (crc32({checked, size + 4}) != big_u32(bytes, at + 8 + size)) {
      throw Failure(subject, "a damaged PNG picture (the checksum at byte " + std::to_string(at + 8 + size) +
                                 " is wrong)");
    }
    if (bytes.substr(at + 4, 4) == "IEND") return;
    at += kAroundData + size;
  }
  throw Failure(subject, "a truncated PNG picture");
}

// A whole file ends its scans with the marker EOI. The markers before them are skipped, because a thumbnail
// in them has an EOI of its own.
void check_jpeg(std::string_view bytes, const std::string& subject) {
  constexpr std::uint32_t kStartOfScan = 0xDA;
  std::size_t at = 2;
  while (at + 4 <= bytes.size() && byte_at(bytes, at) == 0xFF && byte_at(bytes, at + 1) != kStartOfScan) {
    const bool is_fill = byte_at(bytes, at + 1) == 0xFF;
    at += is_fill ? 1u : 2u + big_u32(bytes, at) % 65536;
  }
  const std::size_t end = bytes.rfind("\xFF\xD9");
  if (end == std::string_view::npos || end < at) throw Failure(subject, "a truncated JPEG picture");
}

void check_bmp(std::string_view bytes, const std::string& subject) {
  constexpr std::size_t kHeaderBytes = 34;
  require_bytes(bytes, kHeaderBytes, "BMP", subject);
  const auto width = static_cast<std::int32_t>(little_at(bytes, 18, 4));
  const auto height = static_cast<std::int32_t>(little_at(bytes, 22, 4));
  const bool packed = little_at(bytes, 30, 4) == 1 || little_at(bytes, 30, 4) == 2;  // run lengths
  if (width <= 0 || packed) return;
  const std::uint64_t row = (static_cast<std::uint64_t>(width) * little_at(bytes, 28, 2) + 31) / 32 * 4;
  const std::uint64_t rows =
      height < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(height) : static_cast<std::uint64_t>(height);
  require_bytes(bytes, little_at(bytes, 10, 4) + row * rows, "BMP", subject);
}

void check_tga(std::string_view bytes, const std::string& subject) {
  constexpr std::size_t kHeaderBytes = 18;
  constexpr std::uint32_t kRunLengths = 8;  // bit of the type
  require_bytes(bytes, kHeaderBytes, "TGA", subject);
  const std::uint32_t map_bytes = little_at(bytes, 5, 2) * ((byte_at(bytes, 7) + 7) / 8);
  const std::uint32_t pixel_bytes = (byte_at(bytes, 16) + 7) / 8;
  std::uint64_t left = std::uint64_t{little_at(bytes, 12, 2)} * little_at(bytes, 14, 2);
  std::uint64_t at = kHeaderBytes + byte_at(bytes, 0) + map_bytes;
  if ((byte_at(bytes, 2) & kRunLengths) == 0) at += std::exchange(left, 0) * pixel_bytes;
  while (left > 0 && at < bytes.size()) {
    const std::uint32_t packet = byte_at(bytes, static_cast<std::size_t>(at));
    const std::uint32_t pixels = packet % 128 + 1;
    at += 1 + std::uint64_t{packet < 128 ? pixels : 1} * pixel_bytes;
    left -= std::min<std::uint64_t>(left, pixels);
  }
  require_bytes(bytes, left > 0 ? at + 1 : at, "TGA", subject);
}

}  // namespace arcspan::tools
