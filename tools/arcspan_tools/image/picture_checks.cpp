// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>

#include <arcspan_tools/image/picture_checks.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <cctype>
#include <utility>

namespace arcspan::tools {
namespace {

/// The bytes of a file, of which those that are read must be there.
class PictureBytes {
 public:
  PictureBytes(std::string_view bytes, const char* kind, const std::string& subject)
      : bytes_(bytes), kind_(kind), subject_(subject) {}

  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] std::string_view part(std::size_t at, std::size_t count) const {
    require(std::uint64_t{at} + count);
    return bytes_.substr(at, count);
  }
  [[nodiscard]] std::uint32_t big(std::size_t at, std::size_t count) const {
    std::uint32_t value = 0;
    for (const char c : part(at, count)) value = (value << 8) | static_cast<unsigned char>(c);
    return value;
  }
  [[nodiscard]] std::uint32_t little(std::size_t at, std::size_t count) const {
    std::uint32_t value = 0;
    for (std::size_t i = count; i > 0; --i) value = (value << 8) | big(at + i - 1, 1);
    return value;
  }

  void require(std::uint64_t bytes) const {
    if (bytes_.size() < bytes) throw Failure(subject_, std::string("a truncated ") + kind_ + " picture");
  }
  [[noreturn]] void damaged(const std::string& what) const {
    throw Failure(subject_, std::string("a damaged ") + kind_ + " picture (" + what + ")");
  }
  [[noreturn]] void unreadable(const std::string& what) const {
    throw Failure(subject_, std::string("a ") + kind_ + " picture with " + what + ", which cannot be read");
  }
  [[nodiscard]] PictureHeader header(std::int64_t width, std::int64_t height) const {
    const PictureHeader header{kind_, width, height};
    check_picture_size(header, subject_);
    return header;
  }

 private:
  std::string_view bytes_;
  const char* kind_;
  const std::string& subject_;
};

// Chunks of a length, a type, data and a checksum.
PictureHeader check_png(const PictureBytes& bytes) {
  PictureHeader header;
  std::string_view type;
  for (std::size_t at = 8; type != "IEND";) {
    const std::size_t size = bytes.big(at, 4);
    type = bytes.part(at + 4, 4);
    const std::string_view checked = bytes.part(at + 4, size + 4);
    if (crc32({reinterpret_cast<const std::uint8_t*>(checked.data()), checked.size()}) !=
        bytes.big(at + 8 + size, 4)) {
      bytes.damaged("the checksum at byte " + std::to_string(at + 8 + size) + " is wrong");
    }
    if (type == "IHDR") header = bytes.header(bytes.big(at + 8, 4), bytes.big(at + 12, 4));
    at += 12 + size;
  }
  if (header.width == 0) bytes.damaged("it has no header");
  return header;
}

/// The tables of a segment of Huffman codes: a byte of its number, 16 of how many codes have each length, and
/// a byte for each code.
void check_huffman_tables(const PictureBytes& bytes, std::size_t at, std::size_t end) {
  while (at < end) {
    std::size_t codes = 0;
    for (const char c : bytes.part(at + 1, 16)) codes += static_cast<unsigned char>(c);
    if (codes > 256)
      bytes.damaged("a Huffman table of " + std::to_string(codes) + " codes; the limit is 256");
    at += 17 + codes;
  }
}

// Segments of a marker, a length and data. After those that start a scan there are coded bytes up to the next
// marker; a whole file has an end.
PictureHeader check_jpeg(const PictureBytes& bytes) {
  PictureHeader header;
  std::size_t at = 2;
  for (;;) {
    const std::uint32_t marker = bytes.big(at, 2);
    const bool is_coded = marker < 0xFF01 || marker == 0xFFFF || (marker >= 0xFFD0 && marker <= 0xFFD7);
    if (is_coded || marker == 0xFF01) {
      ++at;
      continue;
    }
    if (marker == 0xFFD9) break;
    const std::size_t size = bytes.big(at + 2, 2);
    const std::size_t end = at + 2 + size;
    bytes.require(end);
    if (marker == 0xFFC4) check_huffman_tables(bytes, at + 4, end);
    const bool is_frame = marker >= 0xFFC0 && marker <= 0xFFCF && marker % 4 != 0;
    if (is_frame || marker == 0xFFC0) header = bytes.header(bytes.big(at + 7, 2), bytes.big(at + 5, 2));
    at = end;
  }
  if (header.width == 0) bytes.damaged("it has no frame");
  return header;
}

PictureHeader check_bmp(const PictureBytes& bytes) {
  const std::uint32_t header_bytes = bytes.little(14, 4);
  const bool is_old = header_bytes == 12;
  const auto side = [&](std::size_t i) {  // a negative height is that of rows from top to bottom
    const std::uint32_t value = is_old ? bytes.little(18 + 2 * i, 2) : bytes.little(18 + 4 * i, 4);
    return std::int64_t{static_cast<std::int32_t>(value)};
  };
  if (!is_old && header_bytes != 40 && header_bytes != 56 && header_bytes != 108 && header_bytes != 124) {
    bytes.damaged("a header of " + std::to_string(header_bytes) + " bytes");
  }
  const PictureHeader header = bytes.header(side(0), side(1) < 0 ? -side(1) : side(1));
  const std::uint32_t packing = is_old ? 0 : bytes.little(30, 4);
  if (packing == 1 || packing == 2) return header;  // run lengths, which the library refuses
  const std::uint32_t bits = is_old ? bytes.little(24, 2) : bytes.little(28, 2);
  const auto row = (static_cast<std::uint64_t>(header.width) * bits + 31) / 32 * 4;
  bytes.require(bytes.little(10, 4) + row * static_cast<std::uint64_t>(header.height));
  return header;
}

PictureHeader check_tga(const PictureBytes& bytes) {
  constexpr std::size_t kHeaderBytes = 18;
  constexpr std::uint32_t kRunLengths = 8;  // bit of the type
  constexpr std::uint32_t kFromRight = 16;  // bit of the descriptor, which the library ignores
  const PictureHeader header = bytes.header(bytes.little(12, 2), bytes.little(14, 2));
  if (bytes.big(1, 1) > 1) bytes.damaged("its palette is of an unknown type");  // or it is another format
  if ((bytes.big(17, 1) & kFromRight) != 0) bytes.unreadable("rows from right to left");
  const std::uint32_t map_bytes = bytes.little(5, 2) * ((bytes.big(7, 1) + 7) / 8);
  const std::uint32_t pixel_bytes = (bytes.big(16, 1) + 7) / 8;
  auto left = static_cast<std::uint64_t>(header.width * header.height);
  std::uint64_t at = kHeaderBytes + bytes.big(0, 1) + map_bytes;
  if ((bytes.big(2, 1) & kRunLengths) == 0) at += std::exchange(left, 0) * pixel_bytes;
  while (left > 0 && at < bytes.size()) {
    const std::uint32_t packet = bytes.big(static_cast<std::size_t>(at), 1);
    const std::uint32_t pixels = packet % 128 + 1;
    at += 1 + std::uint64_t{packet < 128 ? pixels : 1} * pixel_bytes;
    left -= std::min<std::uint64_t>(left, pixels);
  }
  bytes.require(left > 0 ? at + 1 : at);
  return header;
}

/// TGA has no magic number.
bool is_named_tga(const std::string& name) {
  std::string end = name.size() < 4 ? std::string() : name.substr(name.size() - 4);
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return end == ".tga";
}

}  // namespace

PictureHeader checked_picture(std::string_view bytes, const std::string& subject) {
  const auto of_kind = [&](const char* kind) { return PictureBytes(bytes, kind, subject); };
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return check_png(of_kind("PNG"));
  if (bytes.starts_with("\xFF\xD8")) return check_jpeg(of_kind("JPEG"));
  if (bytes.starts_with("BM")) return check_bmp(of_kind("BMP"));
  if (is_named_tga(subject)) return check_tga(of_kind("TGA"));
  throw Failure(subject, "not a PNG, JPEG, BMP, TGA, PPM (P6) or PGM (P5) picture");
}

void check_picture_size(const PictureHeader& header, const std::string& subject) {
  const std::string what = std::string("a ") + header.kind + " picture of ";
  if (header.width <= 0 || header.height <= 0) {
    const bool wide = header.width > 0;
    throw Failure(subject,
                  what + (wide ? "height " : "width ") + std::to_string(wide ? header.height : header.width));
  }
  if (header.width <= kMostPictureSide && header.height <= kMostPictureSide &&
      header.width * header.height <= kMostPicturePixels) {
    return;
  }
  throw Failure(subject, what + std::to_string(header.width) + "x" + std::to_string(header.height) +
                             " pixels, which is too large (the limits are " +
                             std::to_string(kMostPictureSide) + " in each direction and " +
                             std::to_string(kMostPicturePixels) + " in all)");
}

}  // namespace arcspan::tools
