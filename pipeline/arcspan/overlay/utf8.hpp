// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace arcspan::overlay {

/// Text in UTF-8, which is not copied and must outlive this view. It is made of a literal or another string
/// that ends with a zero byte (a null pointer is no text), or of anything that has data() and size(), such as
/// std::string_view.
class Utf8Text {
 public:
  constexpr Utf8Text() = default;
  constexpr Utf8Text(const char* text) : begin_(text), end_(text) {  // NOLINT: a literal is a text
    if (end_ == nullptr) return;
    while (*end_ != '\0') ++end_;
  }
  Utf8Text(const char8_t* text)  // NOLINT
      : Utf8Text(static_cast<const char*>(static_cast<const void*>(text))) {}
  template <class Chars>
  requires requires(const Chars& chars) {
    { chars.data() } -> std::convertible_to<const char*>;
    { chars.size() } -> std::convertible_to<std::size_t>;
  }
  constexpr Utf8Text(const Chars& chars)  // NOLINT
      : begin_(chars.data()), end_(chars.data() + chars.size()) {}
  constexpr Utf8Text(const char* begin, const char* end) : begin_(begin), end_(end) {}

  [[nodiscard]] constexpr const char* begin() const { return begin_; }
  [[nodiscard]] constexpr const char* end() const { return end_; }
  [[nodiscard]] constexpr bool empty() const { return begin_ == end_; }

  /// Removes the first code point and returns it; the text must not be empty(). Bytes that are no code point
  /// give U+FFFD: overlong forms, surrogates, values above U+10FFFF and sequences that end too early, one for
  /// each maximal part of a sequence (The Unicode Standard 15.0, section 3.9, "U+FFFD Substitution of Maximal
  /// Subparts").
  constexpr std::uint32_t take() {
    constexpr std::uint32_t kReplacement = 0xFFFD;
    const std::uint32_t lead = static_cast<unsigned char>(*begin_++);
    if (lead < 0x80) return lead;
    if (lead < 0xC2 || lead > 0xF4) return kReplacement;
    int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
    std::uint32_t code = lead & (0x3Fu >> more);
    // The range of the second byte leaves out the rest of what is no code point (table 3-7 there).
    const std::uint32_t border = more == 3 ? 0x90 : 0xA0;
    std::uint32_t low = lead == 0xE0 || lead == 0xF0 ? border : 0x80;
    std::uint32_t end = lead == 0xED || lead == 0xF4 ? border : 0xC0;
    for (; more != 0; --more) {
      const std::uint32_t byte = empty() ? 0u : static_cast<unsigned char>(*begin_);
      if (byte < low || byte >= end) return kReplacement;
      code = (code << 6) | (byte & 0x3Fu);
      low = 0x80;
      end = 0xC0;
      ++begin_;
    }
    return code;
  }

 private:
  const char* begin_ = nullptr;
  const char* end_ = nullptr;
};

}  // namespace arcspan::overlay
