// SPDX-License-Identifier: MIT
// A span stage that divides, by a function of libgcc: image_test.py must find it.
#include <cstdint>

namespace arcspan {

template <class Number>
[[gnu::noinline]] Number draw_command(Number a, Number b) {
  return a / b;
}
template std::int64_t draw_command(std::int64_t, std::int64_t);

}  // namespace arcspan

int main() { return 0; }
