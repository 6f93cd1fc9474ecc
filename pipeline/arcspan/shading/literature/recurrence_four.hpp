// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/literature/recurrence_method.hpp>

#include <array>
#include <bit>
#include <cstdint>

namespace arcspan {

/// A factor in block floating point, mantissa * 2^-(16 + shift); below 2.2.
struct BlockFactor {
  std::int32_t mantissa;  ///< at most 2^16, or below 2^18 if shift is 0
  std::int32_t shift;     ///< 0...31

  /// Returns factor * v with 30 fraction bits, rounded to nearest; v has 14 fraction bits.
  [[nodiscard]] constexpr Cosine times(std::int32_t v) const {
    return Cosine::from_raw(wrap_add(wrap_mul(mantissa, v), (std::int32_t{1} << shift) >> 1) >> shift);
  }
};

/// The factors by which four pixels follow from two (S0 eq. 7, 9, 10 and 11, the last two corrected). With
/// D = N(t) - N(t-1) and k = 2 - 2 cos(phi) they are
///
///     N(t+1) = N(t) +   D - k N(t)
///     N(t+2) = N(t) + 2 D - k (3 - k) N(t)                       - k D
///     N(t+3) = N(t) + 3 D - k (6 - 5 k + k^2) N(t)               - k (4 - k) D
///     N(t+4) = N(t) + 4 D - k (10 - 15 k + 7 k^2 - k^3) N(t)     - k (10 - 6 k + k^2) D
///
/// which is eq. 9 with 1 + 2 cos(2 phi) = 3 - k (4 - k) and so on. In the printed form the factors are near
/// 2, 3 and 4, and short words lose the angle.
struct FourSteps {
  std::array<BlockFactor, 4> of_normal;      ///< of N(t), for N(t+1)...N(t+4)
  std::array<BlockFactor, 3> of_difference;  ///< of D, for N(t+2)...N(t+4)

  /// Makes the factors of a k without fine bits. Their relative error is at most 2^-14.
  [[nodiscard]] static constexpr FourSteps of(const RecurrenceStep& k) {
    const auto mantissa = static_cast<std::uint32_t>(k.mantissa < 0 ? 0 : k.mantissa);
    // k and its powers with 20 fraction bits, below 1/4.
    const std::uint32_t k1 = k.shift < 4 ? mantissa << (4 - k.shift) : mantissa >> (k.shift - 4);
    const std::uint32_t k2 = ((k1 >> 4) * (k1 >> 4)) >> 12;
    const std::uint32_t k3 = ((k2 >> 4) * (k1 >> 4)) >> 12;
    const auto k_times = [&](std::uint32_t factor) {  // 20 fraction bits, at most 10
      const std::uint32_t product = mantissa * ((factor + (1u << 6)) >> 7);
      const std::int32_t most = k.shift + 13;
      const std::int32_t wanted = 16 - std::countl_zero(product);
      const std::int32_t drop = wanted < 0 ? 0 : wanted > most ? most : wanted;
      if (most - drop > 31) return BlockFactor{0, 31};
      const std::uint32_t half = (std::uint32_t{1} << drop) >> 1;
      return BlockFactor{static_cast<std::int32_t>((product + half) >> drop), most - drop};
    };
    constexpr std::uint32_t kOne = std::uint32_t{1} << 20;
    return {{{k_times(kOne), k_times(3 * kOne - k1), k_times(6 * kOne - 5 * k1 + k2),
              k_times(10 * kOne - 15 * k1 + 7 * k2 - k3)}},
            {{k_times(kOne), k_times(4 * kOne - k1), k_times(10 * kOne - 6 * k1 + k2)}}};
  }

  /// Returns N(t-1)...N(t+2) and steps `scalar` by four pixels: it holds N(t-1) and D, afterwards N(t+3) and
  /// N(t+4) - N(t+3). None of the new values depends on another one, so that four multipliers can make them
  /// at once.
  [[nodiscard]] constexpr std::array<Cosine, 4> step(RecurrenceScalar& scalar) const {
    const Cosine before = scalar.x;
    const Cosine d = scalar.d;
    const Cosine n = before + d;
    const std::int32_t n14 = round_shift(n.raw(), 16);
    const std::int32_t d14 = round_shift(d.raw(), 16);
    const Cosine d2 = d + d;
    const Cosine ahead1 = n + d - of_normal[0].times(n14);
    const Cosine ahead2 = n + d2 - of_normal[1].times(n14) - of_difference[0].times(d14);
    const Cosine ahead3 = n + d2 + d - of_normal[2].times(n14) - of_difference[1].times(d14);
    const Cosine ahead4 = n + d2 + d2 - of_normal[3].times(n14) - of_difference[2].times(d14);
    scalar.x = ahead3;
    scalar.d = ahead4 - ahead3;
    return {before, n, ahead1, ahead2};
  }
};

/// Recurrence with four pixels at a time (S0 eq. 9 to 11), for comparison: seven multiplies for four pixels
/// of a scalar, where the single step takes four, but independent of one another. Each row makes its factors
/// by ten multiplies.
///
/// Rounding: N(t) and D enter the products rounded to 14 fraction bits, every product is rounded to nearest
/// with 30 fraction bits, and the factors are rounded to 16 bits. So the pixels are not those of the single
/// step: over rows of 256 pixels and 60 degrees a scalar differs by up to 3.6e-5 from it and by up to 2.6e-5
/// from the exact cosine (the single step: 2.3e-5).
template <class Illumination>
struct RecurrenceFour : Recurrence<Illumination> {
  using Base = Recurrence<Illumination>;
  using typename Base::Lighting;
  using typename Base::Prepared;

  /// The pixels of a row (PixelRun).
  class Run {
   public:
    constexpr explicit Run(const RecurrenceRun<Illumination>& first) : steps_(FourSteps::of(first.factor())) {
      unrolled<Base::kScalars>([&](auto i) { scalars_[i] = first.scalar(i); });
      make_four();
    }
    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
      return lighting.colour(four_[at_]);
    }
    [[nodiscard]] static constexpr std::int32_t length() { return RecurrenceRun<Illumination>::length(); }
    constexpr void next() {
      at_ = (at_ + 1) & 3;
      if (at_ == 0) make_four();
    }

   private:
    constexpr void make_four() {
      unrolled<Base::kScalars>([this](auto i) {
        const std::array<Cosine, 4> values = steps_.step(scalars_[i]);
        unrolled<4>([&](auto pixel) { four_[pixel][i] = values[pixel]; });
      });
    }

    FourSteps steps_;
    std::array<RecurrenceScalar, Base::kScalars> scalars_;
    std::array<typename Illumination::Scalars, 4> four_;
    std::size_t at_ = 0;
  };

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if (prepared.is_wide) return Base::walk(prepared, draw);
    return draw(RecurrenceWalkerWith<Illumination, Run>(prepared.narrow));
  }
};

}  // namespace arcspan
