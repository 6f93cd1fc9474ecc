// SPDX-License-Identifier: MIT
// Arbitrary bytes as a picture file of any kind that is read: the checks and what decodes. A Failure is a
// right answer; a crash, a sanitizer's report, much memory or a picture that breaks its promises is not.
#include <arcspan/mesh/crc32.hpp>

#include <arcspan_tools/image/netpbm.hpp>
#include <arcspan_tools/image/picture_checks.hpp>
#include <arcspan_tools/image/rgba_image.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <cstdint>
#include <cstdlib>
#include <string>

using namespace arcspan::tools;

namespace {

/// Bytes that hardly ever have the right checksums of a PNG get them.
void repair(std::string& bytes) {
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n")) return;
  const auto byte = [&bytes](std::size_t at) { return std::size_t{static_cast<std::uint8_t>(bytes[at])}; };
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t size = byte(at) << 24u | byte(at + 1) << 16u | byte(at + 2) << 8u | byte(at + 3);
    if (size > bytes.size() - at - 12) return;
    const auto* checked = reinterpret_cast<const std::uint8_t*>(bytes.data()) + at + 4;
    const std::uint32_t sum = arcspan::crc32({checked, size + 4});
    for (unsigned i = 0; i < 4; ++i) bytes[at + 8 + size + i] = static_cast<char>(sum >> (24 - 8 * i));
    at += 12 + size;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  repair(bytes);
  constexpr std::int64_t kMost = 1 << 20;  // larger ones only take longer
  try {
    if (!is_netpbm(bytes)) {
      const PictureHeader header = checked_picture(bytes, "fuzz.tga");
      if (header.width * header.height > kMost) return 0;
    }
    const RgbaImage image = decode_rgba(bytes, "fuzz.tga");
    const auto pixels = std::int64_t{image.width} * image.height;
    if (pixels <= 0 || pixels > kMostPicturePixels ||
        image.pixels.size() != static_cast<std::size_t>(pixels)) {
      std::abort();
    }
  } catch (const Failure&) {
  }
  return 0;
}
