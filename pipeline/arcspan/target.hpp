// SPDX-License-Identifier: MIT
#pragma once

#if __cplusplus < 202002L
#error "arcspan needs C++20: compile with -std=c++20 or newer"
// No such file: it ends the compilation here, where thousands of errors would follow.
#include "add -std=gnu++20 to the compiler flags"
#endif

#include <cstdint>
#include <type_traits>

/// Everything in pipeline/ that depends on the compiler, on the processor core or on the optimisation level:
/// feature tests, inlining policies and hints for register allocation. None of it changes a pixel. The
/// measured gain of each policy is in docs/decisions/0016-target-policies.md.

// ---- Inlining policies

/// Always part of the caller: for the code of one pixel or one row, where a call would cost as much as the
/// work. Not without optimisation, where copies in every caller only take time to compile; define it empty to
/// compile faster with optimisation, too.
#ifndef ARCSPAN_INLINE
#ifdef __OPTIMIZE__
#define ARCSPAN_INLINE [[gnu::always_inline]]
#else
#define ARCSPAN_INLINE
#endif
#endif

/// Always a function of its own: for a stage of a triangle, whose registers are then allocated independently
/// of its caller's, and whose code exists once.
#define ARCSPAN_OUTLINE [[gnu::noinline]]

/// ARCSPAN_OUTLINE at -Os and on cores with few registers, where the stack frame of a stage is then released
/// before the next stage begins. Elsewhere the compiler chooses, which usually inlines.
#if defined(__OPTIMIZE_SIZE__) || defined(__ARM_ARCH_6M__) || defined(__AVR__)
#define ARCSPAN_OUTLINE_IF_TIGHT [[gnu::noinline]]
#else
#define ARCSPAN_OUTLINE_IF_TIGHT
#endif

/// No policy of inlining: paths that few triangles take are optimised for size and placed apart from the hot
/// code.
#define ARCSPAN_COLD [[gnu::cold]]

/// A function that a program may define itself, in place of the library's.
#define ARCSPAN_REPLACEABLE [[gnu::weak]]

namespace arcspan {

// ---- Features of the core

/// True if the program is optimised for size (-Os).
#ifdef __OPTIMIZE_SIZE__
inline constexpr bool kOptimisedForSize = true;
#else
inline constexpr bool kOptimisedForSize = false;
#endif

/// True if the core has a 32x32->64 multiply and a divide instruction. Armv6-M and AVR have neither; code
/// that asks for it computes the same bits from 32-bit products there.
#if defined(__ARM_ARCH_6M__) || defined(__AVR__)
inline constexpr bool kHasLongMultiply = false;
#else
inline constexpr bool kHasLongMultiply = true;
#endif

/// True if most instructions reach more than 8 registers. On Armv6-M (8) a value kept in a register displaces
/// another.
#if defined(__ARM_ARCH_6M__) || defined(__AVR__)
inline constexpr bool kHasManyRegisters = false;
#else
inline constexpr bool kHasManyRegisters = true;
#endif

/// True if loads and stores scale an index by the size of an element, and if one instruction clears the upper
/// half of a word (Arm: UXTH). Neither on RISC-V, where no extension is looked for.
#if defined(__riscv)
inline constexpr bool kScalesIndices = false;
inline constexpr bool kExtendsHalfwords = false;
#else
inline constexpr bool kScalesIndices = true;
inline constexpr bool kExtendsHalfwords = true;
#endif

/// True if leading zeros are counted, or the bytes of a word reversed, by one instruction or by a short
/// routine (Armv6-M). False on RISC-V without Zbb, where both are calls of long routines.
#if defined(__riscv) && !defined(__riscv_zbb)
inline constexpr bool kCountsLeadingZeros = false;
inline constexpr bool kReversesBytes = false;
#else
inline constexpr bool kCountsLeadingZeros = true;
inline constexpr bool kReversesBytes = true;
#endif

/// True if one instruction saturates to an unsigned range (Arm: USAT). In Thumb-1 code (Cortex-M23) there is
/// none, whatever clang's __ARM_FEATURE_SAT says.
#if defined(__ARM_FEATURE_SAT) && (defined(__thumb2__) || !defined(__thumb__))
#define ARCSPAN_HAS_USAT
#endif
#ifdef ARCSPAN_HAS_USAT
inline constexpr bool kHasSaturate = true;
#else
inline constexpr bool kHasSaturate = false;
#endif

/// A 32-bit word that may be stored over objects of other types.
using AliasingWord [[gnu::may_alias]] = __UINT32_TYPE__;
/// True if the machine loads and stores such words by one instruction each.
inline constexpr bool kHasWords = sizeof(void*) >= sizeof(AliasingWord);

// ---- Hints for register allocation

/// Makes the compiler store `value` and load it again at its next use. Without this, gcc copies values that
/// are stepped once per row through extra stack slots: 12 instructions per row on a Cortex-M3.
template <class T>
ARCSPAN_INLINE constexpr void reload_from_memory(T& value) {
#if defined(__AVR__)
  (void)value;  // An 8-bit core keeps words in memory anyway, and clang 19 miscalculates branch distances
                // around asm.
#else
  if (!std::is_constant_evaluated()) asm("" : "+m"(value));
#endif
}

/// Hides how `value` was computed: gcc replaces one shared index into two arrays by two pointers otherwise.
/// Where registers are few, only if `Always`.
template <bool Always = false, class T>
ARCSPAN_INLINE constexpr void hide_value(T& value) {
#if defined(__AVR__)
  (void)value;  // as above
#else
  if constexpr ((Always || kHasManyRegisters) && std::is_scalar_v<T>) {
    if (!std::is_constant_evaluated()) asm("" : "+r"(value));
  }
#endif
}

/// Returns `value` as hide_value() leaves it; members that are hidden in place stay in memory with gcc.
template <class T>
[[nodiscard]] ARCSPAN_INLINE constexpr T hidden(T value) {
  hide_value(value);
  return value;
}

/// Returns sum + a * b modulo 2^32. On Armv7-M, where that is one instruction, gcc would add up products
/// first and the sum last.
[[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t plus_product(std::int32_t sum, std::int32_t a,
                                                                 std::int32_t b) {
  auto result = static_cast<std::int32_t>(static_cast<std::uint32_t>(sum) +
                                          static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b));
#if defined(__thumb2__)
  hide_value(result);
#endif
  return result;
}

/// Returns v >> Shift clamped to the range of unsigned integers of `Bits` bits; only if kHasSaturate. Up to 8
/// bits, whose limit fits an instruction, gcc finds the instruction itself, even in a loop.
template <int Bits, int Shift>
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t saturated_unsigned(std::int32_t v) {
  constexpr auto kMost = static_cast<std::int32_t>((std::uint32_t{1} << Bits) - 1);
#ifdef ARCSPAN_HAS_USAT
  if (!std::is_constant_evaluated()) {
    std::uint32_t result;
    if constexpr (Shift == 0) {
      asm("usat %0, %1, %2" : "=r"(result) : "I"(Bits), "r"(v));
    } else {
      asm("usat %0, %1, %2, asr %3" : "=r"(result) : "I"(Bits), "r"(v), "I"(Shift));
    }
    return result;
  }
#endif
  const std::int32_t shifted = v >> Shift;
  return static_cast<std::uint32_t>(shifted < 0 ? 0 : shifted > kMost ? kMost : shifted);
}

#undef ARCSPAN_HAS_USAT

}  // namespace arcspan
