// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/counting/operation_counts.hpp>

#include <compare>
#include <concepts>
#include <type_traits>

namespace arcspan_counting {

template <class T>
concept PlainNumber = std::is_arithmetic_v<T>;

/// An integer of type T that counts what is done to it. It has T's size, range, promotions and wrap-around;
/// it converts to a plain number only explicitly, so that nothing escapes the counting by accident.
template <std::integral T>
class Counted {
 public:
  using Plain = T;

  constexpr Counted() = default;
  template <PlainNumber U>
  constexpr Counted(U value) : value_(static_cast<T>(value)) {}
  /// Implicit where C++ widens, explicit where it would narrow.
  template <std::integral U>
  requires(!std::same_as<T, U>) explicit(!std::same_as<std::common_type_t<T, U>, T>) constexpr Counted(
      Counted<U> other)
      : value_(static_cast<T>(other.plain())) {}

  [[nodiscard]] constexpr T plain() const { return value_; }
  /// Implicit only to exactly what memory is indexed by.
  template <PlainNumber U>
  [[nodiscard]] explicit(!std::same_as<U, std::size_t> && !std::same_as<U, std::ptrdiff_t>) constexpr
  operator U() const {
    return static_cast<U>(value_);
  }

#ifndef __clang__
  /// gcc needs a conversion that is no template for `memory[vertex number]`. clang does not need it, and
  /// would try every built-in operator for each operation because of it, which takes a fifth of its time.
  [[nodiscard]] constexpr operator std::ptrdiff_t() const requires std::same_as<T, std::uint16_t> {
    return value_;
  }
#endif

  constexpr Counted& operator++() { return *this = Counted(*this + T{1}); }
  constexpr Counted& operator--() { return *this = Counted(*this - T{1}); }
  constexpr Counted operator++(int) {
    const Counted before = *this;
    ++*this;
    return before;
  }
  constexpr Counted operator--(int) {
    const Counted before = *this;
    --*this;
    return before;
  }

 private:
  T value_;  // like T itself not set by default, so that it may be part of a union
};

namespace detail {

template <class T>
struct PlainOf {
  using Type = T;
};
template <class T>
struct PlainOf<Counted<T>> {
  using Type = T;
};
template <class T>
using Plain = typename PlainOf<T>::Type;

template <class T>
inline constexpr bool kIsCounted = !std::same_as<T, Plain<T>>;

/// At least one of them counts, both are integers.
template <class A, class B>
concept CountedPair = (kIsCounted<A> || kIsCounted<B>)&&std::integral<Plain<A>>&& std::integral<Plain<B>>;

template <class T>
[[nodiscard]] constexpr Plain<T> plain(T v) {
  if constexpr (kIsCounted<T>) {
    return v.plain();
  } else {
    return v;
  }
}

template <class R>
[[nodiscard]] constexpr Counted<R> counted(Operation kind, R value) {
  if (!std::is_constant_evaluated()) count_one(kind);
  return Counted<R>(value);
}

}  // namespace detail

// Each operator has the result type that C++ gives it for the plain types.
#define ARCSPAN_COUNTED_OPERATOR(op, kind)                                                                  \
  template <class A, class B>                                                                               \
  requires detail::CountedPair<A, B>                                                                        \
  constexpr auto operator op(A a, B b) {                                                                    \
    using Common = std::common_type_t<detail::Plain<A>, detail::Plain<B>>;                                  \
    return detail::counted(kind,                                                                            \
                           static_cast<Common>(detail::plain(a)) op static_cast<Common>(detail::plain(b))); \
  }                                                                                                         \
  template <class A, class B>                                                                               \
  requires detail::CountedPair<Counted<A>, B>                                                               \
  constexpr Counted<A>& operator op##=(Counted<A>& a, B b) { return a = static_cast<Counted<A>>(a op b); }
ARCSPAN_COUNTED_OPERATOR(+, Operation::kAdd)
ARCSPAN_COUNTED_OPERATOR(-, Operation::kAdd)
ARCSPAN_COUNTED_OPERATOR(*, Operation::kMultiply)
ARCSPAN_COUNTED_OPERATOR(/, Operation::kDivide)
ARCSPAN_COUNTED_OPERATOR(%, Operation::kDivide)
ARCSPAN_COUNTED_OPERATOR(&, Operation::kLogic)
ARCSPAN_COUNTED_OPERATOR(|, Operation::kLogic)
ARCSPAN_COUNTED_OPERATOR(^, Operation::kLogic)
#undef ARCSPAN_COUNTED_OPERATOR

template <class A, class B>
requires detail::CountedPair<A, B>
constexpr auto operator>>(A a, B b) {
  return detail::counted(Operation::kShift, detail::plain(a) >> detail::plain(b));
}
template <class A, class B>
requires detail::CountedPair<Counted<A>, B>
constexpr Counted<A>& operator>>=(Counted<A>& a, B b) { return a = static_cast<Counted<A>>(a >> b); }
template <class A, class B>
requires detail::CountedPair<A, B>
constexpr auto operator<<(A a, B b) {
  const auto shifted = detail::plain(a) << detail::plain(b);
  if (detail::plain(a) == 1) return Counted<std::remove_const_t<decltype(shifted)>>(shifted);
  return detail::counted(Operation::kShift, shifted);
}
template <class A, class B>
requires detail::CountedPair<Counted<A>, B>
constexpr Counted<A>& operator<<=(Counted<A>& a, B b) { return a = static_cast<Counted<A>>(a << b); }

template <class A>
constexpr auto operator-(Counted<A> a) {
  return detail::counted(Operation::kAdd, -a.plain());
}
template <class A>
constexpr auto operator+(Counted<A> a) {
  return Counted<decltype(+a.plain())>(+a.plain());
}
template <class A>
constexpr auto operator~(Counted<A> a) {
  return detail::counted(Operation::kLogic, ~a.plain());
}

template <class A, class B>
requires detail::CountedPair<A, B>
constexpr bool operator==(A a, B b) {
  using Common = std::common_type_t<detail::Plain<A>, detail::Plain<B>>;
  if (!std::is_constant_evaluated()) count_one(Operation::kCompare);
  return static_cast<Common>(detail::plain(a)) == static_cast<Common>(detail::plain(b));
}
template <class A, class B>
requires detail::CountedPair<A, B>
constexpr std::strong_ordering operator<=>(A a, B b) {
  using Common = std::common_type_t<detail::Plain<A>, detail::Plain<B>>;
  if (!std::is_constant_evaluated()) count_one(Operation::kCompare);
  return static_cast<Common>(detail::plain(a)) <=> static_cast<Common>(detail::plain(b));
}

/// Memory is addressed, not counted: a step along a row is none of the shading's work.
template <class P, class T>
constexpr P* operator+(P* at, Counted<T> steps) {
  return at + steps.plain();
}

}  // namespace arcspan_counting
