// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>

namespace arcspan::bare {

/// Writes `text`, which must end in zero.
void print(const char* text);

/// Writes `value` in decimal.
void print(std::uint64_t value);

/// The same for the shorter unsigned types; signed ones must be converted on purpose.
template <std::unsigned_integral T>
void print(T value) {
  print(static_cast<std::uint64_t>(value));
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
