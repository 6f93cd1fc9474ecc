// SPDX-License-Identifier: MIT
#pragma once

#if __cplusplus < 202002L
#error "arcspan needs C++20: compile with -std=c++20 or newer"
#endif

#include <cstdint>
#include <type_traits>

/// Everything in pipeline/ that depends on the compiler, on the processor core or on the optimisation level:
/// feature tests, inlining policies and hints for register allocation. None of it changes a pixel. The
/// measured gain of each policy is in docs/decisions/0016-target-policies.md.

// ---- Inlining policies
//
// The end of a name is the condition under which the policy applies:
//
//   AT_OS              the program is optimised for size (-Os)
//   EXCEPT_AT_OS       it is not; a function of its own at -Os
//   IF_TIGHT           -Os, or a core with few registers
//   IF_MANY_REGISTERS  kHasManyRegisters
//   IF_WIDE            kHasWideRegisters, but not -Os

/// For the code of one pixel or one row: always part of its caller, because the call would cost as much as
/// the work. Not without optimisation, where copies in every caller only take time to compile; define it
/// empty to compile faster with optimisation, too.
#ifndef ARCSPAN_INLINE
#ifdef __OPTIMIZE__
#define ARCSPAN_INLINE [[gnu::always_inline]]
#else
#define ARCSPAN_INLINE
#endif
#endif

/// For a stage of a triangle: a function of its own, so that its registers are allocated independently of its
/// caller's, and its code exists once.
#define ARCSPAN_OUTLINE [[gnu::noinline]]

/// ARCSPAN_INLINE on cores with many registers only. Where registers are few, a colour computed in a function
/// of its own leaves them to the loop over the pixels.
#if defined(__ARM_ARCH_6M__) || defined(__AVR__)
#define ARCSPAN_INLINE_IF_MANY_REGISTERS
#else
#define ARCSPAN_INLINE_IF_MANY_REGISTERS ARCSPAN_INLINE
#endif

/// For paths that few triangles take: optimised for size and placed apart from the hot code.
#define ARCSPAN_COLD [[gnu::cold]]
#define ARCSPAN_COLD_OUTLINE [[gnu::noinline, gnu::cold]]

/// ARCSPAN_OUTLINE at -Os and on cores with few registers: its stack frame is then released before the next
/// stage begins. Elsewhere inlining is faster.
#if defined(__OPTIMIZE_SIZE__) || defined(__ARM_ARCH_6M__) || defined(__AVR__)
#define ARCSPAN_OUTLINE_IF_TIGHT [[gnu::noinline]]
#else
#define ARCSPAN_OUTLINE_IF_TIGHT
#endif

/// ARCSPAN_INLINE, but a function of its own at -Os, where it is called from several places.
#ifdef __OPTIMIZE_SIZE__
#define ARCSPAN_INLINE_EXCEPT_AT_OS [[gnu::noinline]]
#else
#define ARCSPAN_INLINE_EXCEPT_AT_OS ARCSPAN_INLINE
#endif

/// ARCSPAN_INLINE at -Os, where compilers call even a sum of a few words for every row. Elsewhere they choose
/// better themselves. Not on AVR, where such a sum is longer than a call.
#if defined(__OPTIMIZE_SIZE__) && !defined(__AVR__)
#define ARCSPAN_INLINE_AT_OS ARCSPAN_INLINE
#else
#define ARCSPAN_INLINE_AT_OS
#endif

/// ARCSPAN_INLINE on machines with wide registers (kHasWideRegisters) except at -Os, for stages of a triangle
/// that are called in one or two places: there a call saves up to six registers one by one. Elsewhere
/// compilers choose.
#if defined(__SIZEOF_POINTER__) && __SIZEOF_POINTER__ >= 8 && !defined(__OPTIMIZE_SIZE__)
#define ARCSPAN_INLINE_IF_WIDE ARCSPAN_INLINE
#else
#define ARCSPAN_INLINE_IF_WIDE
#endif

// ---- Configuration

/// Number of entries in the table of encoded colours that a draw call keeps on its stack
/// (EncodedColourTable): 0, 256 (512 bytes) or 1024 (2 KB). Pixels are the same with each. Define it, equally
/// for the whole program, to override: the default is 1024 on hosts with 128-bit vectors, which fill it
/// quickly, 0 on AVR, and 256 elsewhere.
#ifndef ARCSPAN_ENCODED_COLOURS
#if defined(__SSE2__) || (defined(__aarch64__) && defined(__ARM_NEON))
#define ARCSPAN_ENCODED_COLOURS 1024
#elif defined(__AVR__)
#define ARCSPAN_ENCODED_COLOURS 0
#else
#define ARCSPAN_ENCODED_COLOURS 256
#endif
#endif

/// 1 if one instruction inserts a bit field into a register (Thumb-2: BFI) and bit fields start at bit 0.
#if defined(__thumb2__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define ARCSPAN_HAS_BIT_INSERT 1
#else
#define ARCSPAN_HAS_BIT_INSERT 0
#endif

namespace arcspan {

// ---- Features of the core

/// True if the program is optimised for size (-Os).
#ifdef __OPTIMIZE_SIZE__
inline constexpr bool kOptimisedForSize = true;
#else
inline constexpr bool kOptimisedForSize = false;
#endif

/// True if the core has a 32x32->64 multiply and a divide instruction. Armv6-M and AVR have neither;
/// integer.hpp, quotient.hpp, edge.hpp and small_triangle.hpp (SettledColumn) compute the same bits from
/// 32-bit products there.
#if defined(__ARM_ARCH_6M__) || defined(__AVR__)
inline constexpr bool kHasLongMultiply = false;
#else
inline constexpr bool kHasLongMultiply = true;
#endif

/// True if a 64-bit sum of 32-bit products is cheaper than two sums of 32 bits (Armv7-M: SMLAL). arcspan
/// simulate defines ARCSPAN_LONG_SUMS, because it counts the operations of such a core.
#if defined(__thumb2__) || defined(ARCSPAN_LONG_SUMS) || \
    (defined(__SIZEOF_POINTER__) && __SIZEOF_POINTER__ >= 8)
inline constexpr bool kHasLongSums = true;
#else
inline constexpr bool kHasLongSums = false;
#endif

/// True if 64 bits fit one register. Where they need two, two 32-bit products are cheaper than one 64-bit
/// product.
#if defined(__SIZEOF_POINTER__) && __SIZEOF_POINTER__ >= 8
inline constexpr bool kHasWideRegisters = true;
#else
inline constexpr bool kHasWideRegisters = false;
#endif

/// True if programs have room for loops that only save time. AVR's flash has 128 KB at most.
#if defined(__AVR__)
inline constexpr bool kHasRoomForLoops = false;
#else
inline constexpr bool kHasRoomForLoops = true;
#endif

/// True if most instructions reach more than 8 registers. On Armv6-M (8) a value kept in a register displaces
/// another.
#if defined(__ARM_ARCH_6M__) || defined(__AVR__)
inline constexpr bool kHasManyRegisters = false;
#else
inline constexpr bool kHasManyRegisters = true;
#endif

/// A copy of a loop's parameter where registers are few: gcc would load the members of a reference again for
/// every pixel. Elsewhere it keeps them in registers anyway, and a copy gets other spills.
template <class T>
using CopyIfFewRegisters = std::conditional_t<kHasManyRegisters, const T&, const T>;

/// True if loads and stores scale an index by the size of an element, and if one instruction clears the upper
/// half of a word (Arm: UXTH). Neither on RISC-V, where no extension is looked for.
#if defined(__riscv)
inline constexpr bool kScalesIndices = false;
inline constexpr bool kExtendsHalfwords = false;
#else
inline constexpr bool kScalesIndices = true;
inline constexpr bool kExtendsHalfwords = true;
#endif

/// True if one instruction saves several registers of a function. x86-64 and RISC-V save them one by one,
/// which takes 25 instructions more per call of a large function on RISC-V.
#if defined(__riscv) || defined(__x86_64__)
inline constexpr bool kSavesRegistersAtOnce = false;
#else
inline constexpr bool kSavesRegistersAtOnce = true;
#endif

/// True if one instruction loads two words into any two registers (Armv7-M: LDRD).
#if defined(__thumb2__)
inline constexpr bool kLoadsPairs = true;
#else
inline constexpr bool kLoadsPairs = false;
#endif

/// True if a rare call in a loop's function gets a copy of the loop's variable of type T, because compilers
/// keep those in memory whose addresses a call has. Copies take code; on Armv6-M they are calls of memcpy.
template <class T>
inline constexpr bool kCopiesForCalls =
    !kOptimisedForSize && kHasLongMultiply && std::is_trivially_copyable_v<T>;

/// True if leading zeros are counted by one instruction or by a short routine (Armv6-M). False on RISC-V
/// without Zbb, where it is a call of a long routine.
#if defined(__riscv) && !defined(__riscv_zbb)
inline constexpr bool kCountsLeadingZeros = false;
#else
inline constexpr bool kCountsLeadingZeros = true;
#endif

/// True if one instruction saturates to a range (Arm: USAT).
#if defined(__ARM_FEATURE_SAT)
inline constexpr bool kHasSaturate = true;
#else
inline constexpr bool kHasSaturate = false;
#endif

/// A 32-bit word that may be stored over objects of other types.
using AliasingWord [[gnu::may_alias]] = __UINT32_TYPE__;

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
template <class T>
ARCSPAN_INLINE constexpr void hide_value(T& value) {
  if constexpr (kHasManyRegisters && std::is_scalar_v<T>) {
    if (!std::is_constant_evaluated()) asm("" : "+r"(value));
  }
}

/// Returns `value` as hide_value() leaves it; members that are hidden in place stay in memory with gcc.
template <class T>
[[nodiscard]] ARCSPAN_INLINE constexpr T hidden(T value) {
  hide_value(value);
  return value;
}

/// Returns `v` clamped to the range of signed integers of `Bits` bits; only if kHasSaturate. gcc finds the
/// instruction itself, but not in a loop, where it keeps the limits in registers.
template <int Bits>
[[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t saturated(std::int32_t v) {
  constexpr std::int32_t kMost = (std::int32_t{1} << (Bits - 1)) - 1;
#if defined(__ARM_FEATURE_SAT)
  if (!std::is_constant_evaluated()) {
    std::int32_t result;
    asm("ssat %0, %1, %2" : "=r"(result) : "I"(Bits), "r"(v));
    return result;
  }
#endif
  return v < -kMost - 1 ? -kMost - 1 : v > kMost ? kMost : v;
}

/// Returns v >> Shift clamped to the range of unsigned integers of `Bits` bits; only if kHasSaturate. Up to 8
/// bits, whose limit fits an instruction, gcc finds the instruction itself, even in a loop.
template <int Bits, int Shift>
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t saturated_unsigned(std::int32_t v) {
  constexpr auto kMost = static_cast<std::int32_t>((std::uint32_t{1} << Bits) - 1);
#if defined(__ARM_FEATURE_SAT)
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

}  // namespace arcspan
