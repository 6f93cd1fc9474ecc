// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

namespace arcspan {

/// Whether code is to be small rather than fast; ARCSPAN_APART_IF_SMALL is for a function that is inlined for
/// speed, and apart where code is to be small: its stack is then not below what comes after it.
#ifdef __OPTIMIZE_SIZE__
inline constexpr bool kSmall = true;
#define ARCSPAN_APART_IF_SMALL [[gnu::noinline]]
#else
inline constexpr bool kSmall = false;
#define ARCSPAN_APART_IF_SMALL
#endif

}  // namespace arcspan

// Empty statements that compilers cannot see through, where their choice of registers was measured to be the
// dearer one. They change no value.
namespace arcspan {

/// Armv6-M reaches 8 registers in most instructions: what saves others a load costs it one.
#if defined(__ARM_ARCH_6M__) || defined(__AVR__)
inline constexpr bool kManyRegisters = false;
#else
inline constexpr bool kManyRegisters = true;
#endif

/// Has the compiler take `value` from memory where it is next used. Otherwise gcc carries what is stepped
/// from row to row by way of copies on the stack: 12 instructions a row on a Cortex-M3.
template <class T>
[[gnu::always_inline]] constexpr void keep_in_memory(T& value) {
#if defined(__AVR__)
  // 8-bit words live in memory anyway, and clang 19 would misjudge how far a branch has to reach.
  (void)value;
#else
  if (!std::is_constant_evaluated()) asm("" : "+m"(value));
#endif
}

/// Hides a value's origin. Otherwise two rows of memory get a pointer each in place of one index: an addition
/// a pixel more.
template <class T>
[[gnu::always_inline]] constexpr void keep_as_is(T& value) {
  if constexpr (kManyRegisters && std::is_scalar_v<T>) {
    if (!std::is_constant_evaluated()) asm("" : "+r"(value));
  }
}

}  // namespace arcspan
