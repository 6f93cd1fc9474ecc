// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>

namespace arcspan::bare {

/// Writes zero-terminated `text`.
void print(const char* text);

/// Write `value` in decimal. The 64-bit overload needs a 64-bit division, 0.7 KB on small cores.
void print(std::uint32_t value);
void print(std::uint64_t value);

/// Forwards other unsigned types. Signed ones do not compile; convert them explicitly.
template <std::unsigned_integral T>
void print(T value) {
  if constexpr (sizeof(T) <= sizeof(std::uint32_t)) {
    print(static_cast<std::uint32_t>(value));
  } else {
    print(static_cast<std::uint64_t>(value));
  }
}

/// Makes print() write a 32-bit value as eight hexadecimal digits.
struct Hex {
  std::uint32_t value;
};
void print(Hex hex);

/// Writes all arguments and a line break.
template <class... Parts>
void print_line(Parts... parts) {
  (print(parts), ...);
  print("\n");
}

}  // namespace arcspan::bare
