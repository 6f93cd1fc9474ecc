// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unroll.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <type_traits>

namespace arcspan {

/// to = from, by 32-bit words where the machine has them. For structures of a kilobyte, which small run-time
/// libraries copy byte by byte.
template <class T>
ARCSPAN_OUTLINE constexpr void copy_words(const T& from, T& to) {
  static_assert(std::is_trivially_copyable_v<T>);
  if constexpr (kHasWords && alignof(T) >= alignof(AliasingWord)) {
    if (!std::is_constant_evaluated()) {
      constexpr std::size_t kBlock = 8;  // words per turn
      constexpr std::size_t kWords = sizeof(T) / sizeof(AliasingWord);
      const auto* source = static_cast<const AliasingWord*>(static_cast<const void*>(&from));
      auto* target = static_cast<AliasingWord*>(static_cast<void*>(&to));
      const auto copy_next = [&] {
        AliasingWord word = *source++;
        hide_value(word);  // otherwise compilers call memcpy
        *target++ = word;
      };
      for (std::size_t left = kWords / kBlock; left != 0; --left)
        unrolled<kBlock>([&](auto) { copy_next(); });
      for (std::size_t left = kWords % kBlock; left != 0; --left) copy_next();
      return;
    }
  }
  to = from;
}

}  // namespace arcspan
