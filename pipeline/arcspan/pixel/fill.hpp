// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unroll.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

namespace detail {

/// Fills all whole blocks of words from `at` on, which must be aligned for a word. Advances `at` and reduces
/// `count` by the elements written.
template <class Element>
ARCSPAN_INLINE inline void fill_words(Element*& at, std::size_t& count, Element value) {
  constexpr std::size_t kBlock = 8;  // words per turn: one store each, and three instructions for the loop
  constexpr std::size_t kElements = kBlock * sizeof(AliasingWord) / sizeof(Element);
  AliasingWord pattern = value;
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
  if constexpr (std::is_integral_v<Element> && sizeof(void*) >= sizeof(AliasingWord)) {
    if (!std::is_constant_evaluated()) {
      for (; count != 0 && (reinterpret_cast<std::uintptr_t>(at) & 3u) != 0; --count) *at++ = value;
      detail::fill_words(at, count, value);
    }
  }
  for (; count != 0; --count) *at++ = value;
}

}  // namespace arcspan
