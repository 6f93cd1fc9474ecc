// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/support/vec3.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace arcspan::tools {

/// Whether all three are finite numbers of at most kMostCoordinate.
[[nodiscard]] bool is_coordinate(const Vec3& v);

/// The words of a text that is divided into elements (vertices, faces), from the word after the current
/// line's first `used` ones on. An element begins a new line, and what is left of the line before is skipped;
/// or lines break anywhere.
class ElementText {
 public:
  enum class Breaks : std::uint8_t { kAfterElements, kAnywhere };

  ElementText(TextLines& lines, Breaks breaks, std::size_t used = 0)
      : lines_(lines), breaks_(breaks), at_(used) {}

  /// Starts the next element; `what` names it in messages.
  void begin(std::string what);

  [[nodiscard]] bool has_more();
  std::string_view word();
  /// The next word as a number; NaN if it is none.
  double number();
  /// Goes over the next three words.
  void read_triple();
  /// These as coordinates. Throws a Failure if they are none.
  [[nodiscard]] Vec3 triple() const;
  /// The next word, or a Failure, as TextLines::integer_at().
  std::int64_t integer(std::int64_t least, std::int64_t most, const char* what);
  /// A Failure unless the next word is this one, in either case.
  void expect(std::string_view word);

  [[nodiscard]] bool has_own_lines() const { return breaks_ == Breaks::kAfterElements; }
  /// Words that are left on the current line.
  [[nodiscard]] std::size_t left_on_line() const { return lines_.words().size() - at_; }
  /// Goes to the end of the line, or before these two words.
  void skip_to(std::string_view first, std::string_view second);
  /// Numbers that are left over where lines break anywhere mean that others were taken for what they are not.
  void end();

  [[noreturn]] void fail(const std::string& what) const { lines_.fail(what + " in " + what_); }

 private:
  void advance();

  TextLines& lines_;
  Breaks breaks_;
  std::size_t at_;  ///< the next word of the current line
  std::string_view triple_[3];
  std::string what_ = "the file";
};

/// Whether each of the next `count` elements of `lines` has a line of its own with all its words, of which
/// `needed` tells the number from the words of the line.
template <class Needed>
[[nodiscard]] bool has_lines(TextLines& lines, std::int64_t count, const Needed& needed) {
  for (std::int64_t i = 0; i < count; ++i) {
    do {
      if (!lines.next()) return false;
    } while (lines.words().empty());
    if (lines.words().size() < needed(lines.words())) return false;
  }
  return true;
}

}  // namespace arcspan::tools
