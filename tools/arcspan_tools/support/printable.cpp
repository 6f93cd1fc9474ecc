// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/printable.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace arcspan::tools {
namespace {

/// The least code points of sequences of two to four bytes; shorter forms of a character are not UTF-8.
constexpr std::uint32_t kLeastCodePoints[] = {0, 0, 0x80, 0x800, 0x10000};

/// Bytes of the sequence that a first byte announces; 0 for a byte that starts none.
std::size_t announced(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

bool is_shown(std::uint32_t character) {
  const bool control = character < 0x20 || (character >= 0x7F && character < 0xA0);
  const bool surrogate = character >= 0xD800 && character < 0xE000;
  return !control && !surrogate && character < 0x110000;
}

/// Bytes of the character at the start of `text` if a terminal may get it; else 0.
std::size_t shown_bytes(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t bytes = announced(first);
  if (bytes == 0 || bytes > text.size()) return 0;
  std::uint32_t character = bytes == 1 ? first : first & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0u) != 0x80u) return 0;
    character = (character << 6) | (next & 0x3Fu);
  }
  return character >= kLeastCodePoints[bytes] && is_shown(character) ? bytes : 0;
}

std::string escape(char byte) {
  constexpr const char* kDigits = "0123456789abcdef";
  if (byte == '\n') return "\\n";
  if (byte == '\t') return "\\t";
  if (byte == '\r') return "\\r";
  const auto value = static_cast<unsigned char>(byte);
  return {'\\', 'x', kDigits[value >> 4], kDigits[value & 15u]};
}

}  // namespace

std::string printable(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::size_t shown = shown_bytes(text);
    if (shown == 0) {
      line += escape(text[0]);
    } else {
      line += text.substr(0, shown);
    }
    text.remove_prefix(shown == 0 ? 1 : shown);
  }
  return line;
}

void print_message(std::string_view text) {
  constexpr std::size_t kMost = 300;
  constexpr std::string_view kGap = " ... ";
  std::string line = "arcspan: " + printable(text);
  if (line.size() > kMost) {
    // Characters of several bytes are kept whole.
    const auto is_inner = [&line](std::size_t at) {
      return (static_cast<unsigned char>(line[at]) & 0xC0u) == 0x80u;
    };
    std::size_t begin = (kMost - kGap.size()) / 2;
    std::size_t end = line.size() - begin;
    while (is_inner(begin)) --begin;
    while (is_inner(end)) ++end;
    line.replace(begin, end - begin, kGap);
  }
  std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace arcspan::tools
