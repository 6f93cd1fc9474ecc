// SPDX-License-Identifier: MIT
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/console.hpp>

namespace arcspan::bare {

void print(const char* text) { write(text); }

void print(std::uint64_t value) {
  char digits[21];
  char* first = digits + 20;
  *first = '\0';
  do {
    *--first = static_cast<char>('0' + static_cast<int>(value % 10u));
    value /= 10u;
  } while (value != 0);
  write(first);
}

void print(Hex hex) {
  char digits[9];
  for (unsigned i = 0; i < 8; ++i) digits[i] = "0123456789abcdef"[(hex.value >> (28u - 4u * i)) & 15u];
  digits[8] = '\0';
  write(digits);
}

}  // namespace arcspan::bare
