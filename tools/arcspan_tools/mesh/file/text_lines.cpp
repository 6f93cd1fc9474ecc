// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {
namespace {

char line_end_of(std::string_view text) {
  const std::size_t first = text.find_first_of("\r\n");
  if (first == std::string_view::npos || text[first] == '\n') return '\n';
  return first + 1 < text.size() && text[first + 1] == '\n' ? '\n' : '\r';
}

/// Where a comment starts in a word. Some libraries print numbers that are not finite with a '#'.
std::size_t comment_in(std::string_view word) {
  const std::size_t at = word.find('#');
  if (at == std::string_view::npos) return at;
  const std::string_view rest = word.substr(at + 1);
  for (const std::string_view number : {"IND", "INF", "QNAN", "SNAN"}) {
    if (at > 0 && same_letters(rest.substr(0, number.size()), number)) return std::string_view::npos;
  }
  return at;
}

bool has_digit(std::string_view word) { return word.find_first_of("0123456789") != std::string_view::npos; }

}  // namespace

TextLines::TextLines(std::string_view text, std::string subject, Joining joining)
    : rest_(text), subject_(std::move(subject)), joining_(joining), line_end_(line_end_of(text)) {}

bool TextLines::next() {
  words_.clear();
  written_.clear();
  if (rest_.empty()) return false;
  number_ = next_number_;
  for (bool continues = true; continues && !rest_.empty();) {
    const std::size_t end = std::min(rest_.find(line_end_), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++next_number_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    continues = joining_ == Joining::kBackslash && !line.empty() && line.back() == '\\';
    if (continues) line.remove_suffix(1);
    split(line);
  }
  return true;
}

void TextLines::next_words(const std::string& expected) {
  while (next()) {
    if (!words_.empty()) return;
  }
  fail("the file ends before " + expected);
}

void TextLines::split(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r\n\f\v";
  for (bool comment = false;;) {
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return;
    line.remove_prefix(begin);
    const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
    line.remove_prefix(word.size());
    written_.push_back(word);
    if (comment) continue;
    const std::string_view own = word.substr(0, comment_in(word));
    comment = own.size() < word.size();
    if (!own.empty()) words_.push_back(own);
  }
}

Readings TextLines::name(std::size_t first) const {
  Readings readings;
  std::string name;
  for (std::size_t i = first; i < written_.size(); ++i) {
    if (written_[i].starts_with('#')) readings.insert(readings.begin(), name);
    name += (name.empty() ? "" : " ") + std::string(written_[i]);
  }
  readings.insert(readings.begin(), name);
  return readings;
}

double TextLines::number_at(std::size_t i) const {
  if (i >= words_.size()) fail("a number is missing");
  const std::optional<double> value = parse_number(words_[i]);
  if (!value) fail(in_quotes(words_[i]) + " is not a number");
  if (std::isnan(*value) || (std::isinf(*value) && !has_digit(words_[i]))) {
    fail(in_quotes(words_[i]) + " is not a finite number");
  }
  if (std::fabs(*value) > kMostCoordinate) fail(in_quotes(words_[i]) + " is too large (the limit is 1e30)");
  return *value;
}

std::int64_t TextLines::integer_at(std::size_t i, std::int64_t least, std::int64_t most,
                                   const char* what) const {
  if (i >= words_.size()) fail(std::string(what) + " is missing");
  const std::optional<std::int64_t> value = parse_integer(words_[i]);
  if (!value) fail(in_quotes(words_[i]) + " is not an integer (" + what + ")");
  if (most < least)
    fail(std::string(what) + " out of range (" + std::to_string(*value) + "; there are none)");
  if (*value < least || *value > most) {
    fail(std::string(what) + " out of range (" + std::to_string(*value) + "; allowed are " +
         std::to_string(least) + " to " + std::to_string(most) + ")");
  }
  return *value;
}

void TextLines::fail(const std::string& what) const {
  throw Failure(subject_, "line " + std::to_string(number_) + ": " + what);
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kMost = 24;
  std::string text(word.substr(0, kMost));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + text + (word.size() > kMost ? "...'" : "'");
}

std::string plain_text(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) return std::string(text.substr(3));
  const bool big = text.starts_with("\xFE\xFF");
  if (!big && !text.starts_with("\xFF\xFE")) return std::string(text);
  std::string plain;
  for (std::size_t i = 2; i + 1 < text.size(); i += 2) {
    const char high = text[big ? i : i + 1];
    const char low = text[big ? i + 1 : i];
    plain.push_back(high == 0 && low > 0 ? low : '?');
  }
  return plain;
}

bool same_letters(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

void require_text(std::string_view text, const std::string& subject) {
  const auto is_binary = [](char c) {
    return (c >= 0 && c < ' ' && c != '\n' && c != '\r' && c != '\t' && c != '\f' && c != '\v') || c == 0x7F;
  };
  const auto at = std::find_if(text.begin(), text.end(), is_binary);
  if (at == text.end()) return;
  throw Failure(subject, "not a text file (byte " + std::to_string(static_cast<unsigned char>(*at)) +
                             " at offset " + std::to_string(at - text.begin()) + ")");
}

}  // namespace arcspan::tools
