// SPDX-License-Identifier: MIT
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/console.hpp>

#include <cstddef>

namespace arcspan::bare {

void print(const char* text) { write(text); }

namespace {

/// `Digits` is the number of digits of the largest value.
template <std::size_t Digits, class Value>
void print_decimal(Value value) {
  char digits[Digits + 1];
  char* first = digits + Digits;
  *first = '\0';
  do {
    *--first = static_cast<char>('0' + static_cast<int>(value % 10u));
    value /= 10u;
  } while (value != 0);
  write(first);
}

}  // namespace

void print(std::uint32_t value) { print_decimal<10>(value); }
void print(std::uint64_t value) { print_decimal<20>(value); }

void print(Hex hex) {
  char digits[9];
  for (unsigned i = 0; i < 8; ++i) digits[i] = "0123456789abcdef"[(hex.value >> (28u - 4u * i)) & 15u];
  digits[8] = '\0';
  write(digits);
}

}  // namespace arcspan::bare
