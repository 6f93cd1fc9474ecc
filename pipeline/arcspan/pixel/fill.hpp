// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unroll.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

namespace detail {

/// Fills what whole blocks of words there are from `at` on, which must be aligned for them; goes on to the
/// rest.
template <class Code>
ARCSPAN_INLINE inline void fill_words(Code*& at, std::size_t& count, Code value) {
  constexpr std::size_t kBlock = 8;  // words of a turn: a store each, and three instructions for all
  constexpr std::size_t kCodes = kBlock * sizeof(AliasingWord) / sizeof(Code);
  AliasingWord pattern = value;
  for (std::size_t bits = 8 * sizeof(Code); bits < 8 * sizeof(AliasingWord); bits *= 2)
    pattern |= pattern << bits;
  hide_value(pattern);  // no call of memset
  for (; count >= kCodes; count -= kCodes, at += kCodes) {
    auto* words = static_cast<AliasingWord*>(static_cast<void*>(at));
    unrolled<kBlock>([=](auto i) { words[i] = pattern; });
  }
}

}  // namespace detail

/// Sets `count` pixel codes or depths to `value`, by words of 32 bits where a machine has them.
template <class Code>
constexpr void fill(Code* at, std::size_t count, Code value) {
  if constexpr (std::is_integral_v<Code> && sizeof(void*) >= sizeof(AliasingWord)) {
    if (!std::is_constant_evaluated()) {
      for (; count != 0 && (reinterpret_cast<std::uintptr_t>(at) & 3u) != 0; --count) *at++ = value;
      detail::fill_words(at, count, value);
    }
  }
  for (; count != 0; --count) *at++ = value;
}

}  // namespace arcspan
