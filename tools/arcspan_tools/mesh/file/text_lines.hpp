// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace arcspan::tools {

/// The largest number in a mesh file, for which products of three still fit a double.
inline constexpr double kMostCoordinate = 1e30;

/// The lines of a text file, split into words; the words of the current line can be taken as numbers. Throws
/// a Failure that names the line for what is not as it should be.
class TextLines {
 public:
  enum class Joining : std::uint8_t { kNo, kBackslash };

  /// Lines end as the first one does: with LF (or CR LF), or with CR alone, as on old Macs. With kBackslash a
  /// backslash at a line's end continues it on the next.
  TextLines(std::string_view text, std::string subject, Joining joining = Joining::kNo);

  /// Goes to the next line and splits it, without what follows a '#'. False at the end of the text.
  bool next();
  /// Goes to the next line that has words; a Failure ("ends before ...") if there is none.
  void next_words(const std::string& expected);

  [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Everything after the current line.
  [[nodiscard]] std::string_view rest() const { return rest_; }

  /// Word i as a finite number of at most 1e30: the loader library computes with floats, in which products of
  /// larger ones are infinite.
  [[nodiscard]] double number_at(std::size_t i) const;
  /// Word i as an integer from `least` to `most`; `what` names it in the message.
  [[nodiscard]] std::int64_t integer_at(std::size_t i, std::int64_t least, std::int64_t most,
                                        const char* what) const;

  /// Throws `subject: line N: what`.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void split(std::string_view line);

  std::string_view rest_;
  std::string subject_;
  Joining joining_;
  char line_end_;
  std::vector<std::string_view> words_;
  std::size_t number_ = 0;
  std::size_t next_number_ = 1;
};

/// `word` in quotes for a message: shortened, with bytes that no terminal should get replaced.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// The words of the current line after the first one, with single blanks between them: a name that may have
/// blanks.
[[nodiscard]] std::string rest_of_line(const TextLines& lines);

/// `text` as it is, or turned from UTF-16 (either order, by its byte order mark) into bytes in which every
/// character beyond ASCII is a '?'. An UTF-8 mark is removed.
[[nodiscard]] std::string plain_text(std::string_view text);

/// Whether both are the same letters, A-Z as a-z.
[[nodiscard]] bool same_letters(std::string_view a, std::string_view b);

/// Throws a Failure if `text` has bytes that no text file has.
void require_text(std::string_view text, const std::string& subject);

}  // namespace arcspan::tools
