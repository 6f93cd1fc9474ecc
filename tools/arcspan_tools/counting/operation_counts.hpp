// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace arcspan_counting {

/// The operations of an integer machine by kind.
enum class Operation : std::uint8_t {
  kMultiply,
  kShift,   ///< not of the literal 1: 1 << k is the constant half of a rounding
  kAdd,     ///< sums, differences, changes of sign, increments
  kDivide,  ///< divisions, and reciprocals from the table
  kRoot,    ///< calls of integer_root() and reciprocal_root(), whatever they are made of
  kLookUp,  ///< reads of a table: a std::array of more than 16 entries
  kCompare,
  kLogic,  ///< and, or, exclusive or, not
};
inline constexpr std::size_t kOperationKinds = 8;
inline constexpr std::array<std::string_view, kOperationKinds> kOperationNames = {
    "multiply", "shift", "add", "divide", "root", "look-up", "compare", "logic"};

struct OperationCounts {
  std::array<std::uint64_t, kOperationKinds> of{};

  void add(Operation kind) { ++of[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] std::uint64_t operator[](Operation kind) const { return of[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] std::uint64_t sum() const {
    std::uint64_t all = 0;
    for (const std::uint64_t n : of) all += n;
    return all;
  }
};

/// Where the counted operations go: null, nowhere. One thread counts at a time.
inline OperationCounts* operation_target = nullptr;
/// Above zero inside something that counts as one operation.
inline int operation_nesting = 0;

inline void count_one(Operation kind) {
  if (operation_target != nullptr && operation_nesting == 0) operation_target->add(kind);
}

/// `call` as one operation of `kind`, whatever it is made of.
template <class Call>
constexpr auto count_as_one(Operation kind, const Call& call) {
  if (__builtin_is_constant_evaluated()) return call();
  count_one(kind);
  ++operation_nesting;
  const auto result = call();
  --operation_nesting;
  return result;
}

}  // namespace arcspan_counting
