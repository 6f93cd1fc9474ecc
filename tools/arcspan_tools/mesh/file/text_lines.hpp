// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/mesh_data.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace arcspan::tools {

/// What a name in a text may be, with single blanks between its words: as it is written, or less what follows
/// a word that begins with '#', which may be a comment. The first of these that exists is meant.
using Readings = std::vector<std::string>;

/// The lines of a text file, split into words; the words of the current line can be taken as numbers. Throws
/// a Failure that names the line for what is not as it should be.
class TextLines {
 public:
  enum class Joining : std::uint8_t { kNo, kBackslash };

  /// Lines end as the first one does: with LF (or CR LF), or with CR alone, as on old Macs. With kBackslash a
  /// backslash at a line's end continues it on the next.
  TextLines(std::string_view text, std::string subject, Joining joining = Joining::kNo);

  /// Goes to the next line and splits it, without what follows a '#', unless that is a number such as
  /// `-1.#IND`. False at the end of the text.
  bool next();
  /// Goes to the next line that has words; a Failure ("ends before ...") if there is none.
  void next_words(const std::string& expected);

  [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }
  /// The words from `first` on as a name, the longest reading first.
  [[nodiscard]] Readings name(std::size_t first = 1) const;
  /// Everything after the current line.
  [[nodiscard]] std::string_view rest() const { return rest_; }

  /// Word i as a finite number of at most kMostCoordinate.
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
  std::vector<std::string_view> written_;  ///< with those of a comment
  std::size_t number_ = 0;
  std::size_t next_number_ = 1;
};

/// `word` in quotes for a message: shortened, with bytes that no terminal should get replaced.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// `text` as it is, or turned from UTF-16 (either order, by its byte order mark) into bytes in which every
/// character beyond ASCII is a '?'. An UTF-8 mark is removed.
[[nodiscard]] std::string plain_text(std::string_view text);

/// Whether both are the same letters, A-Z as a-z.
[[nodiscard]] bool same_letters(std::string_view a, std::string_view b);

/// Throws a Failure if `text` has bytes that no text file has.
void require_text(std::string_view text, const std::string& subject);

}  // namespace arcspan::tools
