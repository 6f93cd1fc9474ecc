// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unroll.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

namespace detail {

/// Whether words hold a whole number of these elements.
template <class Element>
inline constexpr bool kFillsWords =
    std::is_integral_v<Element> && !std::is_same_v<Element, bool> && sizeof(Element) <= 4 && kHasWords;

/// Fills all whole blocks of words from `at` on, which must be aligned for a word. Advances `at` and reduces
/// `count` by the elements written.
template <class Element>
ARCSPAN_INLINE inline void fill_words(Element*& at, std::size_t& count, Element value) {
  constexpr std::size_t kBlock = 8;  // words per turn: one store each, and three instructions for the loop
  constexpr std::size_t kElements = kBlock * sizeof(AliasingWord) / sizeof(Element);
  AliasingWord pattern = static_cast<std::make_unsigned_t<Element>>(value);
  for (std::size_t bits = 8 * sizeof(Element); bits < 8 * sizeof(AliasingWord); bits *= 2)
    pattern |= pattern << bits;
  hide_value(pattern);  // otherwise compilers call memset
  for (; count >= kElements; count -= kElements, at += kElements) {
    auto* words = static_cast<AliasingWord*>(static_cast<void*>(at));
    unrolled<kBlock>([=](auto i) { words[i] = pattern; });
  }
}

}  // namespace detail

/// Sets the `count` elements (encoded pixels or depths) from `at` on to `value`, by 32-bit words on machines
/// that have them.
template <class Element>
constexpr void fill(Element* at, std::size_t count, Element value) {
  if constexpr (detail::kFillsWords<Element>) {
    if (!std::is_constant_evaluated()) {
      for (; count != 0 && (reinterpret_cast<std::uintptr_t>(at) & 3u) != 0; --count) *at++ = value;
      detail::fill_words(at, count, value);
    }
  }
  for (; count != 0; --count) *at++ = value;
}

/// Copies `count` elements, by 32-bit words on machines that have them if both addresses lie alike in a word.
template <class Element>
constexpr void copy_elements(const Element* from, std::size_t count, Element* to) {
  if constexpr (detail::kFillsWords<Element>) {
    const auto part = [](const void* at) { return reinterpret_cast<std::uintptr_t>(at) & 3u; };
    if (!std::is_constant_evaluated() && part(from) == part(to)) {
      for (; count != 0 && part(from) != 0; --count) *to++ = *from++;
      constexpr std::size_t kBlock = 8;  // words per turn
      constexpr std::size_t kElements = kBlock * sizeof(AliasingWord) / sizeof(Element);
      for (; count >= kElements; count -= kElements, from += kElements, to += kElements) {
        const auto* source = static_cast<const AliasingWord*>(static_cast<const void*>(from));
        auto* target = static_cast<AliasingWord*>(static_cast<void*>(to));
        unrolled<kBlock>([=](auto i) {
          AliasingWord word = source[i];
          hide_value(word);  // otherwise compilers call memcpy
          target[i] = word;
        });
      }
    }
  }
  for (; count != 0; --count) *to++ = *from++;
}

/// Sets `count` pixels, 0 or more, from that of a cursor on.
template <class Cursor, class Encoded>
constexpr void fill_pixels(Cursor cursor, std::int32_t count, Encoded encoded) {
  if constexpr (requires { cursor.pixels(); }) {
    fill(cursor.pixels(), static_cast<std::size_t>(count), encoded);
  } else {
    for (; count > 0; --count, cursor.next()) cursor.write(encoded);
  }
}

/// Copies `count` pixels, 0 or more, from those of one cursor on to those of another.
template <class Cursor>
constexpr void copy_pixels(Cursor from, std::int32_t count, Cursor to) {
  if constexpr (requires { from.pixels(); }) {
    copy_elements(from.pixels(), static_cast<std::size_t>(count), to.pixels());
  } else {
    for (; count > 0; --count, from.next(), to.next()) to.write(from.read());
  }
}

namespace detail {

/// Calls draw(cursor, run) for each row of a rectangle that lies within the sink's bounds() and is not empty.
template <PixelSink Sink, class Draw>
[[nodiscard]] constexpr Status draw_rows(Sink& sink, const Rect& rect, const Draw& draw) {
  for (std::int32_t y = rect.top; y < rect.bottom; ++y) {
    const Span run{y, rect.left, rect.width()};
    draw(sink.open(run), run);
    if (const Status status = sink.close(run); !ok(status)) return status;
  }
  return Status::kOk;
}

/// Fills such a rectangle.
template <PixelSink Sink>
[[nodiscard]] constexpr Status fill_rows(Sink& sink, const Rect& rect,
                                         typename Sink::Format::Encoded encoded) {
  return draw_rows(sink, rect,
                   [encoded](auto cursor, const Span& run) { fill_pixels(cursor, run.count, encoded); });
}

}  // namespace detail

}  // namespace arcspan
