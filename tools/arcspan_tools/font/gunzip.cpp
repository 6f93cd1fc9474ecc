// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>
#include <arcspan/numbers/little_endian.hpp>

#include <arcspan_tools/font/gunzip.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <stb/stb_image.h>

#include <climits>
#include <cstdint>

namespace arcspan::tools {
namespace {

constexpr std::size_t kHeaderBytes = 10;
constexpr std::size_t kTrailerBytes = 8;

/// The optional parts of a header (RFC 1952, 2.3.1).
enum GzipFlag : unsigned {
  kHasHeaderCrc = 2,
  kHasExtra = 4,
  kHasName = 8,
  kHasComment = 16,
  kReserved = 0xE0
};

unsigned byte_at(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

/// The offset of the compressed data. Throws a Failure if the header does not end.
std::size_t header_end(std::string_view bytes, const std::string& subject) {
  const unsigned flags = byte_at(bytes, 3);
  std::size_t at = kHeaderBytes;
  const auto need = [&](std::size_t count) {
    if (count > bytes.size() || at > bytes.size() - count)
      throw Failure(subject, "the header of the gzip file is cut off");
  };
  if ((flags & kHasExtra) != 0) {
    need(2);
    at += 2 + byte_at(bytes, at) + 256 * byte_at(bytes, at + 1);
  }
  for (const GzipFlag text : {kHasName, kHasComment}) {
    if ((flags & text) == 0) continue;
    need(1);
    const std::size_t zero = bytes.find('\0', at);
    at = zero == std::string_view::npos ? bytes.size() : zero + 1;
  }
  if ((flags & kHasHeaderCrc) != 0) at += 2;
  need(kTrailerBytes);
  return at;
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B"); }

std::string gunzip(std::string_view bytes, std::size_t limit, const std::string& subject) {
  constexpr unsigned kDeflate = 8;
  constexpr std::size_t kMostRatio = 1032;  // of deflate: 258 bytes take at least two bits
  if (bytes.size() < kHeaderBytes + kTrailerBytes || bytes.size() > INT_MAX)
    throw Failure(subject, "the gzip file is cut off");
  if (byte_at(bytes, 2) != kDeflate || (byte_at(bytes, 3) & kReserved) != 0)
    throw Failure(subject, "an unknown kind of gzip file");
  const std::size_t begin = header_end(bytes, subject);
  const auto* trailer = reinterpret_cast<const std::uint8_t*>(bytes.data()) + bytes.size() - kTrailerBytes;
  const std::size_t size = little_u32(trailer + 4);
  const std::string_view packed = bytes.substr(begin, bytes.size() - kTrailerBytes - begin);
  if (size > limit) throw Failure(subject, "holds more than " + std::to_string(limit) + " bytes");
  if (size > packed.size() * kMostRatio) throw Failure(subject, "the gzip file is damaged");
  std::string content(size, '\0');
  // The trailer is given too: stb fails if its input ends with the bits of the last code.
  const int length = stbi_zlib_decode_noheader_buffer(content.data(), static_cast<int>(size), packed.data(),
                                                      static_cast<int>(packed.size() + kTrailerBytes));
  const auto* unpacked = reinterpret_cast<const std::uint8_t*>(content.data());
  if (length < 0 || static_cast<std::size_t>(length) != size ||
      crc32({unpacked, size}) != little_u32(trailer))
    throw Failure(subject, "the gzip file is damaged");
  return content;
}

}  // namespace arcspan::tools
