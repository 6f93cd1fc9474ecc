// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>

namespace arcspan::bare {

/// Writes `text`, which must end in zero.
void print(const char* text);

/// Write `value` in decimal. The longer one needs a 64-bit division, 0.7 KB on small cores.
void print(std::uint32_t value);
void print(std::uint64_t value);

/// The same for other unsigned types; signed ones must be converted on purpose.
template <std::unsigned_integral T>
void print(T value) {
  if constexpr (sizeof(T) <= sizeof(std::uint32_t)) {
    print(static_cast<std::uint32_t>(value));
  } else {
    print(static_cast<std::uint64_t>(value));
  }
}

/// A 32-bit value to be written as eight hexadecimal digits.
struct Hex {
  std::uint32_t value;
};
void print(Hex hex);

/// Writes all arguments, then ends the line.
template <class... Parts>
void print_line(Parts... parts) {
  (print(parts), ...);
  print("\n");
}

}  // namespace arcspan::bare
