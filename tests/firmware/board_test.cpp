// SPDX-License-Identifier: MIT
// What every board layer must deliver: initialised memory, a console, a counter that runs, a stack that can
// be measured, and the arithmetic that the pipeline stands on.
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/stack.hpp>

#include <cstdint>

using namespace arcspan::bare;

namespace {

constexpr std::int32_t kStart = std::int32_t{1} << 29;
constexpr std::int32_t kSlope = std::int32_t{1} << 20;

volatile std::uint32_t initialised = 0x12345678;
volatile std::uint32_t zeroed;
int failures = 0;

void check(bool held, const char* what) {
  if (held) return;
  ++failures;
  print_line("failed: ", what);
}

/// Sum of `count` values of x <- x - d, d <- d + k x / 2^30, the recurrence of the span stage.
constexpr std::int32_t recurrence(std::int32_t x, std::int32_t d, std::int32_t k, std::uint32_t count) {
  std::uint32_t sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    x -= d;
    d += static_cast<std::int32_t>((static_cast<std::int64_t>(k) * x) >> 30);
    sum += static_cast<std::uint32_t>(x);
  }
  return static_cast<std::int32_t>(sum);
}

[[gnu::noipa, gnu::noinline]] std::int32_t recurrence_at_run_time(std::int32_t x, std::int32_t d,
                                                                  std::int32_t k, std::uint32_t count) {
  return recurrence(x, d, k, count);
}

void check_arithmetic() {
  constexpr std::int32_t kByTheCompiler = recurrence(kStart, kSlope, 81777, 300);
  check(recurrence_at_run_time(kStart, kSlope, 81777, 300) == kByTheCompiler,
        "recurrence as in the compiler");
}

void check_counter() {
  const std::uint64_t start = ticks();
  const std::int32_t once = recurrence_at_run_time(kStart, kSlope, 81777, 1000);
  const std::uint64_t middle = ticks();
  const std::int32_t twice = recurrence_at_run_time(kStart, kSlope, 81777, 2000);
  const std::uint64_t end = ticks();
  const std::uint64_t first = middle - start;
  const std::uint64_t second = end - middle;
  check(once != twice, "recurrence runs on");
  check(first > 0 && second > first + first / 2 && second < 3 * first, "counter runs evenly");
  print_line("1000 steps: ", first, " ticks, 2000 steps: ", second, " ticks");
}

constexpr std::uint32_t kDepth = 1024;

[[gnu::noipa, gnu::noinline]] std::uint8_t use_stack() {
  volatile std::uint8_t frame[kDepth];
  for (volatile std::uint8_t& byte : frame) byte = 1;  // all of it, or the compiler would leave out the rest
  return frame[0];
}

void check_stack() {
  paint_stack();
  const std::uint32_t before = deepest_stack();
  check(use_stack() == 1, "stack holds a value");
  const std::uint32_t after = deepest_stack();
  check(before < stack_size() - kDepth, "stack is painted");
  check(after > kDepth && after < before + kDepth + 128, "deepest stack is measured");
  print_line("stack: ", before, " bytes before, ", after, " after a frame of ", kDepth);
}

}  // namespace

int main() {
  check(initialised == 0x12345678, "data is initialised");
  check(zeroed == 0, "bss is zeroed");
  check_arithmetic();
  check_counter();
  check_stack();
  print_line(failures == 0 ? "board: ok" : "board: failed");
  return failures == 0 ? 0 : 1;
}
