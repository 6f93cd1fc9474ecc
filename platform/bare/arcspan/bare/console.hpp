// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace arcspan::bare {

/// Writes `text`, which must end in zero.
void print(const char* text);

/// Writes `value` in decimal.
void print(std::uint64_t value);
inline void print(std::uint32_t value) { print(static_cast<std::uint64_t>(value)); }
inline void print(std::int32_t) = delete;  // no signed figures so far: convert on purpose

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
