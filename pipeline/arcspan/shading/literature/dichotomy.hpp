// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/root.hpp>
#include <arcspan/shading/literature/linear_scalars.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace detail {

/// A coefficient of the polynomials below, 18 fraction bits.
consteval std::uint32_t polynomial_coefficient(double value) {
  const double rounded = value * 0x1p18 + 0.5;
  return static_cast<std::uint32_t>(rounded);
}
/// value * s with the fraction bits of value; s has 16.
[[nodiscard]] constexpr std::uint32_t times_chord(std::uint32_t value, std::uint32_t s) {
  return (value * s + (1u << 15)) >> 16;
}

}  // namespace detail

/// What an arc's middle needs, 1/sqrt(2 + z) with z = 2 cos(psi) (S3), as a polynomial in s = 2 - z less 1/2:
/// s with 16 fraction bits, 0...1, result with 18. Zero at s = 0, so that flat spans are left exactly alone;
/// S3's own polynomials in z do not (docs/claims.md). Minimax fits of the relative error of 1/2 + result over
/// psi <= 45 degrees, which is 1.6e-3, 4.7e-5 and 1.6e-6.
struct LinearPolynomial {
  [[nodiscard]] static constexpr std::uint32_t above_half(std::uint32_t s) {
    return detail::times_chord(detail::polynomial_coefficient(0.0688625867), s);
  }
};
/// The second of the three: two multiplies.
struct QuadraticPolynomial {
  [[nodiscard]] static constexpr std::uint32_t above_half(std::uint32_t s) {
    const std::uint32_t second_difference =
        detail::times_chord(detail::polynomial_coefficient(0.0140394938), s);
    return detail::times_chord(detail::polynomial_coefficient(0.0620584825) + second_difference, s);
  }
};
/// The third: three multiplies.
struct CubicPolynomial {
  [[nodiscard]] static constexpr std::uint32_t above_half(std::uint32_t s) {
    const std::uint32_t twist = detail::times_chord(detail::polynomial_coefficient(0.0031711712), s);
    const std::uint32_t second_difference =
        detail::times_chord(detail::polynomial_coefficient(0.0114552316) + twist, s);
    return detail::times_chord(detail::polynomial_coefficient(0.0625262157) + second_difference, s);
  }
};

/// The squared chord of half an arc from that of the whole, 16 fraction bits: z' = (2 + z) p, so with
/// p = 1/2 + q   s' = s/2 - (4 - s) q.  `q` has 18 fraction bits.
[[nodiscard]] constexpr std::uint32_t halved_chord(std::uint32_t s, std::uint32_t q) {
  const std::uint32_t half = s >> 1;
  const std::uint32_t less = ((((std::uint32_t{4} << 16) - s) >> 3) * q + (1u << 14)) >> 15;
  return less < half ? half - less : 0;
}

/// The middle of an arc whose ends have the scalars a and b: (a + b) (1/2 + q).
[[nodiscard]] constexpr Cosine arc_middle(Cosine a, Cosine b, std::uint32_t q) {
  const std::int32_t mean = wrap_add(a.raw() >> 1, b.raw() >> 1);
  return Cosine::from_raw(
      wrap_add(mean, round_shift(wrap_mul(round_shift(mean, 15), static_cast<std::int32_t>(q)), 2)));
}

/// Shading by dichotomy (S3): a row is cut into segments of 2^SegmentBits pixels. At a segment's two ends the
/// normal is Phong's, linear on the screen and divided by its length; every pixel between them is the middle
/// of an arc, I = (I_left + I_right) / sqrt(2 + z), found by halving. All arcs of a halving are as long as
/// one another, so one polynomial serves them all, and a pixel takes an addition and a multiply a scalar.
///
/// Two things S3 leaves open. The last segment is the shortest power of two that reaches the row's last
/// pixel: S3's full length would, on short rows, ask for normals far outside of the triangle. A segment of
/// more than 45 degrees is Phong's at every pixel, for the polynomials go no further.
///
/// `Polynomial` is one of those above or any type with such a function. No division, one root a segment.
template <class Illumination, class Polynomial, int SegmentBits = 3>
struct Dichotomy : LinearScalars<Illumination, RootAndDivision> {
  static_assert(SegmentBits >= 1 && SegmentBits <= 4);
  using Base = LinearScalars<Illumination, RootAndDivision>;
  using typename Base::Lighting;
  using typename Base::Prepared;
  using typename Base::Vertex;
  using Scalars = std::array<Cosine, Base::kScalars>;
  static constexpr std::int32_t kSegment = 1 << SegmentBits;

  /// Squared chord of 45 degrees, 28 fraction bits.
  static constexpr std::uint32_t kWidestChord = 157245849u;

  class Run {
   public:
    /// `behind` pixels follow the one that `normal` and `scalars` stand on in this row; `inside` of them have
    /// been cut off.
    constexpr Run(const Prepared& prepared, const RowStart& start, std::int32_t behind, std::int32_t inside)
        : prepared_(&prepared), normal_(prepared.normal.at(start)), unit_{}, behind_(behind), at_(inside) {
      unrolled<Base::kScalars>([&](auto i) { scalars_[i] = linear_at(prepared.scalars[i], start); });
      const std::int32_t inverse = inverse_length();
      make_node(nodes_[0], inverse);
      (void)turn(inverse);
      fill_segment();
    }

    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
      return lighting.colour(nodes_[static_cast<std::size_t>(at_)]);
    }
    constexpr void next() {
      if (++at_ < kSegment || behind_ <= kSegment - 1) return;
      behind_ -= kSegment;
      at_ = 0;
      unrolled<Base::kScalars>([this](auto i) { nodes_[0][i] = nodes_[kSegment][i]; });
      fill_segment();
    }

   private:
    /// 1 / |N| of the linear normal, 15 fraction bits.
    [[nodiscard]] constexpr std::int32_t inverse_length() const {
      const auto squared = [](Linear c) {
        const std::int32_t fine = wrap_shl(c.raw(), 2);  // 29 fraction bits, below 4
        return static_cast<std::uint32_t>(multiply_high(fine, fine));
      };
      const std::uint32_t square = squared(normal_.x) + squared(normal_.y) + squared(normal_.z);
      // 26 fraction bits. Only between opposite normals is one shorter than 1/32; it counts as that long.
      constexpr std::uint32_t kLeast = std::uint32_t{1} << 16;
      const ReciprocalRoot root = reciprocal_root(square < kLeast ? kLeast : square);
      return static_cast<std::int32_t>((root.mantissa << 4) >> (root.exponent - 24));
    }
    [[nodiscard]] static constexpr Cosine scaled_to_unit(Linear value, std::int32_t inverse_length) {
      return Cosine::from_raw(wrap_mul(round_shift(value.raw(), Linear::kFraction), inverse_length));
    }

    /// The scalars of Phong's normal where the linear one stands.
    constexpr void make_node(Scalars& node, std::int32_t inverse_length) const {
      unrolled<Base::kScalars>([&](auto i) { node[i] = scaled_to_unit(scalars_[i], inverse_length); });
    }

    /// Takes Phong's normal where the linear one stands for `unit_`; returns the squared chord between the
    /// two.
    constexpr std::uint32_t turn(std::int32_t inverse_length) {
      const auto component = [inverse_length](Linear c) {
        return NormalComponent::from_raw(
            static_cast<std::int16_t>(round_shift(scaled_to_unit(c, inverse_length).raw(), 16)));
      };
      const Normal unit{component(normal_.x), component(normal_.y), component(normal_.z)};
      const std::uint32_t chord = squared_chord(unit_, unit);
      unit_.x = unit.x;  // member by member: small cores would call memcpy
      unit_.y = unit.y;
      unit_.z = unit.z;
      return chord;
    }

    /// From the end that it stands on to the next one, and what is between them.
    constexpr void fill_segment() {
      std::int32_t length = kSegment;
      int bits = SegmentBits;
      while ((length >> 1) >= behind_ && length != 0) {
        length >>= 1;
        --bits;
      }
      if (length == 0) return;
      advance(bits);
      const std::int32_t inverse = inverse_length();
      make_node(nodes_[static_cast<std::size_t>(length)], inverse);
      const std::uint32_t chord = turn(inverse);
      if (chord > kWidestChord) {
        make_every_node(length);
      } else if (behind_ >= kSegment) {
        halve_whole(chord >> 12);
      } else {
        halve(length, chord >> 12);
      }
    }

    /// By 2^bits pixels.
    constexpr void advance(int bits) {
      normal_.advance(scaled(prepared_->normal.step(), bits));
      unrolled<Base::kScalars>([&](auto i) { scalars_[i] += scaled(prepared_->scalars[i].dx, bits); });
    }

    /// Phong's normals at the pixels of a segment that has been gone over already, but for its ends.
    constexpr void make_every_node(std::int32_t length) {
      const LinearNormal step = prepared_->normal.step();
      for (std::int32_t i = length - 1; i > 0; --i) {
        normal_.advance({-step.x, -step.y, -step.z});
        unrolled<Base::kScalars>([this](auto k) { scalars_[k] -= prepared_->scalars[k].dx; });
        make_node(nodes_[static_cast<std::size_t>(i)], inverse_length());
      }
      for (std::int32_t i = 1; i < length; ++i) advance(0);
    }

    /// The nodes of a whole segment whose squared chord is `s`, 16 fraction bits.
    constexpr void halve_whole(std::uint32_t s) {
      unrolled<SegmentBits>([&](auto level) {
        constexpr std::size_t kHalf = std::size_t{1} << (SegmentBits - 1 - decltype(level)::value);
        const std::uint32_t q = Polynomial::above_half(s);
        unrolled<(std::size_t{1} << decltype(level)::value)>(
            [&](auto arc) { make_middle(kHalf + 2 * kHalf * decltype(arc)::value, kHalf, q); });
        s = halved_chord(s, q);
      });
    }

    /// The same of `length` pixels, without the nodes that no pixel of the row depends on.
    constexpr void halve(std::int32_t length, std::uint32_t s) {
      for (std::int32_t half = length >> 1; half != 0; half >>= 1) {
        const std::uint32_t q = Polynomial::above_half(s);
        for (std::int32_t i = half; i < length && i - half < behind_; i += half << 1) {
          make_middle(static_cast<std::size_t>(i), static_cast<std::size_t>(half), q);
        }
        s = halved_chord(s, q);
      }
    }

    constexpr void make_middle(std::size_t at, std::size_t half, std::uint32_t q) {
      unrolled<Base::kScalars>(
          [&](auto i) { nodes_[at][i] = arc_middle(nodes_[at - half][i], nodes_[at + half][i], q); });
    }

    [[nodiscard]] static constexpr Linear scaled(Linear step, int bits) {
      return Linear::from_raw(wrap_shl(step.raw(), bits));
    }
    [[nodiscard]] static constexpr LinearNormal scaled(const LinearNormal& step, int bits) {
      return {scaled(step.x, bits), scaled(step.y, bits), scaled(step.z, bits)};
    }

    const Prepared* prepared_;
    LinearNormal normal_;  ///< linear, where the segment ends
    std::array<Linear, Base::kScalars> scalars_;
    Normal unit_;  ///< of unit length, there
    std::array<Scalars, (std::size_t{1} << SegmentBits) + 1>
        nodes_;            ///< of the segment's pixels and of the next one's first
    std::int32_t behind_;  ///< pixels of the row after the segment's first
    std::int32_t at_;
  };

  class Walker {
   public:
    using Run = Dichotomy::Run;
    static constexpr std::int32_t kLongestRun = 2 * kGuardBand;
    constexpr explicit Walker(Prepared& prepared) : p_(&prepared) {}

    /// Segments begin at the row's first column wherever it is cut, so that cutting changes no pixel.
    [[nodiscard]] constexpr Run row(const RowStart& start) const {
      const std::int32_t skipped = start.skipped & ~(kSegment - 1);
      const RowStart first{start.fraction, skipped, start.inside, start.width, start.bits};
      // Columns after the first whose centres are left of the row's end; one too many does no harm.
      const std::int32_t behind =
          start.bits == 16 ? static_cast<std::int32_t>((start.width + 1 - start.fraction) >> 16) : 0;
      return Run(*p_, first, behind - skipped, start.skipped - skipped);
    }
    constexpr void next_row() {
      p_->normal.next_row();
      unrolled<Base::kScalars>([this](auto i) { p_->scalars[i].next_row(); });
    }
    constexpr void enter_lower() {
      p_->normal.enter_lower(p_->middle_left);
      unrolled<Base::kScalars>([this](auto i) { p_->scalars[i].enter_lower(p_->middle_left); });
    }

   private:
    Prepared* p_;
  };

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return draw(Walker(prepared));
  }
};

template <class Illumination>
using DichotomyLinear = Dichotomy<Illumination, LinearPolynomial>;
template <class Illumination>
using DichotomyQuadratic = Dichotomy<Illumination, QuadraticPolynomial>;
template <class Illumination>
using DichotomyCubic = Dichotomy<Illumination, CubicPolynomial>;

}  // namespace arcspan
