// SPDX-License-Identifier: MIT
#include <arcspan/bare/memory_map.hpp>
#include <arcspan/bare/stack.hpp>

namespace arcspan::bare {
namespace {

constexpr std::uint32_t kPattern = 0x5AFE57ACu;
// Space for the frame of paint_stack() and for that of a caller that it was not inlined into.
constexpr std::uintptr_t kMargin = 64;

}  // namespace

std::uint32_t stack_size() {
  return static_cast<std::uint32_t>(arcspan_stack_top - arcspan_stack_bottom) * sizeof(std::uint32_t);
}

std::uint32_t stack_limit() {
  return static_cast<std::uint32_t>(arcspan_stack_top - arcspan_stack_floor) * sizeof(std::uint32_t);
}

void paint_stack() {
  const volatile std::uint8_t in_frame = 0;
  const auto here = reinterpret_cast<std::uintptr_t>(&in_frame);
  // The volatile store prevents a call of memset, whose own frame would be painted over.
  for (volatile std::uint32_t* word = arcspan_stack_bottom;
       reinterpret_cast<std::uintptr_t>(word) < here - kMargin; ++word) {
    *word = kPattern;
  }
}

std::uint32_t stack_depth() {
  const volatile std::uint32_t in_frame = 0;
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(arcspan_stack_top) -
                                    reinterpret_cast<std::uintptr_t>(&in_frame));
}

std::uint32_t deepest_stack() {
  const volatile std::uint32_t* word = arcspan_stack_bottom;
  while (word < arcspan_stack_top && *word == kPattern) ++word;
  return static_cast<std::uint32_t>(arcspan_stack_top - word) * sizeof(std::uint32_t);
}

}  // namespace arcspan::bare
