// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/support/failure.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// The lines of a font file, without their ends (`\n` or `\r\n`), and the number of the current one for
/// messages.
class FontLines {
 public:
  FontLines(std::string_view text, std::string subject) : rest_(text), subject_(std::move(subject)) {}

  /// Makes `line` the next line. Returns false at the end of the file.
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    ++number_;
    const std::size_t end = rest_.find('\n');
    line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return true;
  }

  [[nodiscard]] const std::string& subject() const { return subject_; }
  /// Throws a Failure that names the current line.
  [[noreturn]] void fail(const std::string& what) const {
    throw Failure(subject_, "line " + std::to_string(number_) + ": " + what);
  }

 private:
  std::string_view rest_;
  std::string subject_;
  std::size_t number_ = 0;
};

/// Appends `width` pixels from the hexadecimal digits of a row, the highest bit first. More digits are left
/// out; fewer are an error, and what is no digit.
inline void append_hex_row(std::string_view digits, std::int32_t width, std::vector<bool>& pixels,
                           const FontLines& lines) {
  for (std::int32_t x = 0; x < width; ++x) {
    const auto at = static_cast<std::size_t>(x / 4);
    if (at >= digits.size()) {
      lines.fail("a row of " + std::to_string(width) + " pixels has " + std::to_string(digits.size()) +
                 " digits only");
    }
    const char c = digits[at];
    const int value = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                             : -1;
    if (value < 0) lines.fail("'" + std::string(digits) + "' is not hexadecimal");
    pixels.push_back(((value >> (3 - x % 4)) & 1) != 0);
  }
}

}  // namespace arcspan::tools
