// SPDX-License-Identifier: MIT
// The part of namespace std that pipeline/ uses, with integers that count. The pipeline's own text is
// compiled against it once more (counted_method.cpp.in, counted_source.cpp.in): there `std` is this namespace
// and `arcspan` is arcspan_counted. What is not declared here is the real std's.
#pragma once

#include <arcspan_tools/counting/counted_integer.hpp>

// Everything that a file of the pipeline may include: included under another name they would not compile.
#include <array>
#include <bit>
#include <climits>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

namespace arcspan_counted_std {

using namespace ::std;
using ::arcspan_counting::Counted;
// 8-bit integers stay plain: they are the types of enumerations, and finished colours.
using int16_t = Counted<::std::int16_t>;
using int32_t = Counted<::std::int32_t>;
using int64_t = Counted<::std::int64_t>;
using uint16_t = Counted<::std::uint16_t>;
using uint32_t = Counted<::std::uint32_t>;
using uint64_t = Counted<::std::uint64_t>;

template <class T>
inline constexpr bool kCountedSigned = false;
template <class T>
inline constexpr bool kCountedSigned<Counted<T>> = ::std::is_signed_v<T>;

template <class T>
concept signed_integral = kCountedSigned<T> || ::std::signed_integral<T>;

template <class T>
[[nodiscard]] constexpr int countl_zero(Counted<T> v) {
  if (!::std::is_constant_evaluated()) ::arcspan_counting::count_one(::arcspan_counting::Operation::kLogic);
  return static_cast<int>(::std::countl_zero(v.plain()));
}
template <class T>
[[nodiscard]] constexpr int bit_width(Counted<T> v) {
  if (!::std::is_constant_evaluated()) ::arcspan_counting::count_one(::arcspan_counting::Operation::kLogic);
  return static_cast<int>(::std::bit_width(v.plain()));
}

/// std::array; reading one of more than 16 entries is a look-up, a smaller one is a handful of registers.
template <class T, ::std::size_t N>
struct array {
  T elements[N == 0 ? 1 : N];

  template <class Index>
  [[nodiscard]] constexpr T& operator[](Index i) {
    return elements[static_cast<::std::size_t>(i)];
  }
  template <class Index>
  [[nodiscard]] constexpr const T& operator[](Index i) const {
    if (N > 16 && !::std::is_constant_evaluated()) {
      ::arcspan_counting::count_one(::arcspan_counting::Operation::kLookUp);
    }
    return elements[static_cast<::std::size_t>(i)];
  }
  [[nodiscard]] static constexpr ::std::size_t size() { return N; }
  [[nodiscard]] constexpr T* data() { return elements; }
  [[nodiscard]] constexpr const T* data() const { return elements; }
  [[nodiscard]] constexpr T* begin() { return elements; }
  [[nodiscard]] constexpr T* end() { return elements + N; }
  [[nodiscard]] constexpr const T* begin() const { return elements; }
  [[nodiscard]] constexpr const T* end() const { return elements + N; }
};

}  // namespace arcspan_counted_std
