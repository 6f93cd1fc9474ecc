// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The squared chord of 60 degrees, 28 fraction bits: the widest arc for which ArcShape holds. Wider arcs are
/// halved first.
inline constexpr std::uint32_t kWidestArc = std::uint32_t{1} << 28;

/// How an arc of the angle psi differs from its chord. At the fraction t of the arc from a to b, with the
/// chord's point X = a + t (b - a) and its middle H = (a + b) / 2, a scalar is (S0 eq. 2)
///
///     f = H cos(c psi) / cos(psi/2) + (X - H) sin(c psi) / (2 c sin(psi/2)),     c = t - 1/2
///
/// which is, with p = t (1 - t),
///
///     f = X + excess (H + toward (X - H)),     excess = cos(c psi) / cos(psi/2) - 1 = p (rise + bend p).
///
/// The three factors are polynomials that are fitted in the squared chord. The error is at most 4e-6 of the
/// normal's length and 8e-7 along the arc up to 30 degrees, 1e-5 and 2e-5 up to 60, plus rounding.
class ArcShape {
 public:
  ArcShape() = default;  // without values, so that a union may hold one
  /// `chord`: the squared chord, 28 fraction bits, at most kWidestArc.
  ARCSPAN_OUTLINE_IF_TIGHT constexpr explicit ArcShape(std::uint32_t chord) {
    const std::uint32_t s = (chord + (1u << 12)) >> 13;  // 15 fraction bits
    const auto times_s = [s](std::uint32_t factor) { return (s * factor) >> 15; };
    // rise = s (0.5 + 0.0831 s + 0.0159 s^2 + 0.0056 s^3), bend = s^2 (0.0413 + 0.0155 s),
    // toward = 1/3 - s (0.0240 + 0.0033 s)
    rise_ = static_cast<std::uint16_t>(times_s(32768u + times_s(5444u + times_s(1040u + times_s(368u)))));
    bend_ = static_cast<std::uint16_t>(times_s(times_s(2707u + times_s(1016u))));
    toward_ = static_cast<std::uint16_t>(10923u - times_s(786u + times_s(108u)));
  }

  /// Returns the excess at the fraction t, 0...1: at most 0.155, 18 fraction bits.
  [[nodiscard]] ARCSPAN_OUTLINE_IF_TIGHT constexpr std::int32_t excess(Factor t) const {
    const std::int32_t p = wrap_mul(t.raw(), 32768 - t.raw()) >> 13;  // 17 fraction bits
    const std::int32_t rate = std::int32_t{rise_} + (wrap_mul(p, std::int32_t{bend_}) >> 17);
    return wrap_mul(p, rate) >> 15;
  }

  /// Returns H - toward H for the sum of a scalar's values at both ends: 15 fraction bits.
  [[nodiscard]] constexpr std::int16_t base(Cosine a, Cosine b) const {
    const std::int32_t half = wrap_add(a.raw() >> 1, b.raw() >> 1) >> 15;
    return static_cast<std::int16_t>(wrap_mul(half, 32768 - std::int32_t{toward_}) >> 15);
  }
  /// Returns the scalar on the arc, of its value `on_chord` on the chord.
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine on_arc(Cosine on_chord, std::int16_t base,
                                                       std::int32_t excess) const {
    const std::int32_t height = wrap_add(base, wrap_mul(on_chord.raw() >> 15, std::int32_t{toward_}) >> 15);
    return on_chord + Cosine::from_raw(wrap_mul(excess, height) >> 3);
  }

  /// Returns the scalar at the fraction t of the arc from a to b; `excess` is excess(t).
  [[nodiscard]] ARCSPAN_OUTLINE_IF_TIGHT constexpr Cosine between(Cosine a, Cosine b, Factor t,
                                                                  std::int32_t excess) const {
    const std::int32_t along =
        scaled_down(wrap_sub(b.raw(), a.raw()), static_cast<std::uint32_t>(t.raw()), 15);
    return on_arc(a + Cosine::from_raw(along), base(a, b), excess);
  }

 private:
  std::uint16_t rise_;    ///< 16 fraction bits
  std::uint16_t bend_;    ///< 16 fraction bits
  std::uint16_t toward_;  ///< 15 fraction bits
};

}  // namespace arcspan
