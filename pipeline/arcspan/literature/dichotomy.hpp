// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/linear_scalars.hpp>
#include <arcspan/literature/row_pixel.hpp>
#include <arcspan/literature/segment.hpp>
#include <arcspan/numbers/root.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace detail {

/// `value` with 18 fraction bits.
consteval std::int32_t polynomial_coefficient(double value) {
  const double rounded = value * 0x1p18 + (value < 0 ? -0.5 : 0.5);
  return static_cast<std::int32_t>(rounded);
}
/// value * s, rounded, with the fraction bits of `value`; s has 16.
[[nodiscard]] constexpr std::int32_t times_chord(std::int32_t value, std::uint32_t s) {
  return round_shift(wrap_mul(value, static_cast<std::int32_t>(s)), 16);
}

}  // namespace detail

/// The factor of an arc's middle, 1/sqrt(2 + z) with z = 2 cos(psi) (S3), as a polynomial of first degree.
///
/// above_half(s) returns 1/sqrt(2 + z) - 1/2 with 18 fraction bits, for s = 2 - z in 0...1 with 16 fraction
/// bits. It is 0 at s = 0, so that flat spans stay exactly flat. A minimax fit: for psi <= 45
/// degrees the relative error of 1/2 + above_half(s) is at most 1.6e-3.
struct LinearPolynomial {
  [[nodiscard]] static constexpr std::int32_t above_half(std::uint32_t s) {
    return detail::times_chord(detail::polynomial_coefficient(0.0688625867), s);
  }
};
/// Like LinearPolynomial, of second degree: two multiplies, relative error at most 4.7e-5.
struct QuadraticPolynomial {
  [[nodiscard]] static constexpr std::int32_t above_half(std::uint32_t s) {
    const std::int32_t inner = detail::times_chord(detail::polynomial_coefficient(0.0140394938), s);
    return detail::times_chord(detail::polynomial_coefficient(0.0620584825) + inner, s);
  }
};
/// Like LinearPolynomial, of third degree: three multiplies, relative error at most 1.6e-6.
struct CubicPolynomial {
  [[nodiscard]] static constexpr std::int32_t above_half(std::uint32_t s) {
    const std::int32_t innermost = detail::times_chord(detail::polynomial_coefficient(0.0031711712), s);
    const std::int32_t inner =
        detail::times_chord(detail::polynomial_coefficient(0.0114552316) + innermost, s);
    return detail::times_chord(detail::polynomial_coefficient(0.0625262157) + inner, s);
  }
};

/// 0.64 - 0.07 z, as S3 prints it: 0.5 + 0.07 s. Relative error at most 2.2e-3 up to 45 degrees.
struct PrintedLinearPolynomial {
  [[nodiscard]] static constexpr std::int32_t above_half(std::uint32_t s) {
    return detail::times_chord(detail::polynomial_coefficient(0.07), s);
  }
};
/// 0.681 - 0.119 z + 0.014 z^2, as S3 prints it: 0.499 + s (0.063 + 0.014 s). Relative error at most 2.0e-3
/// up to 45 degrees. Every halving makes a flat span darker by that much.
struct PrintedQuadraticPolynomial {
  [[nodiscard]] static constexpr std::int32_t above_half(std::uint32_t s) {
    const std::int32_t inner = detail::times_chord(detail::polynomial_coefficient(0.014), s);
    return detail::polynomial_coefficient(-0.001) +
           detail::times_chord(detail::polynomial_coefficient(0.063) + inner, s);
  }
};

/// 1/sqrt(2 + z) itself, by a reciprocal root, as S3 has it before it puts a polynomial there. Relative error
/// at most 2e-5 up to 45 degrees.
struct RootItself {
  [[nodiscard]] static constexpr std::int32_t above_half(std::uint32_t s) {
    const ReciprocalRoot root = reciprocal_root(((4u << 16) - s) << 12);  // 1/sqrt(28 fraction bits)
    const std::uint32_t p = root.mantissa << (32 - root.exponent);
    return p < (1u << 17) ? 0 : static_cast<std::int32_t>(p - (1u << 17));
  }
};

/// The squared chord of half an arc, 16 fraction bits, never negative. `s` is that of the whole arc, `q` the
/// polynomial's above_half(s). From z' = (2 + z) p with p = 1/2 + q follows s' = s/2 - (4 - s) q.
[[nodiscard]] constexpr std::uint32_t halved_chord(std::uint32_t s, std::int32_t q) {
  const auto half = static_cast<std::int32_t>(s >> 1);
  const auto eighth = static_cast<std::int32_t>(((std::uint32_t{4} << 16) - s) >> 3);  // of 4 - s
  const std::int32_t less = round_shift(wrap_mul(eighth, q), 15);
  return less < half ? static_cast<std::uint32_t>(half - less) : 0;
}

/// The scalar in the middle of an arc whose ends have the scalars a and b: (a + b) (1/2 + q), q with 18
/// fraction bits.
[[nodiscard]] constexpr Cosine arc_middle(Cosine a, Cosine b, std::int32_t q) {
  const std::int32_t mean = wrap_add(a.raw() >> 1, b.raw() >> 1);
  return Cosine::from_raw(wrap_add(mean, round_shift(wrap_mul(round_shift(mean, 15), q), 2)));
}

/// Shading by dichotomy (S3). A row is cut into segments of 2^k pixels (SegmentedIllumination, 8 by default;
/// adaptive ones turn by up to 45 degrees). At a segment's two ends the
/// normal is Phong's, linear on the screen and divided by its length. Every pixel between them is the middle
/// of an arc, I = (I_left + I_right) / sqrt(2 + z), found by repeated halving. The arcs of one halving have
/// equal lengths and share one value of the polynomial, so a pixel takes one addition and one multiply per
/// scalar, and a segment one root. There is no division. RootItself takes one more root per halving.
///
/// With `FullLast` the last segment has full length and is drawn up to the row's end, as S3 prescribes; its
/// right end may then be outside of the triangle. Without, it has the least power of two pixels that reaches
/// the row's last pixel. In a segment wider than 45 degrees, where the polynomials end, every pixel's normal
/// is Phong's; S3 leaves this case open.
///
/// `Polynomial` has above_half(), as LinearPolynomial.
template <class Illumination, class Polynomial, bool FullLast = false>
struct Dichotomy : LinearScalars<SegmentedIllumination<Illumination, 3>, RootAndDivision> {
  using Base = LinearScalars<SegmentedIllumination<Illumination, 3>, RootAndDivision>;
  using typename Base::Face;
  using typename Base::Lighting;
  using typename Base::Vertex;
  using Scalars = std::array<Cosine, Base::kScalars>;
  struct Prepared : Base::Prepared {
    int bits;  ///< segments have 2^bits pixels
  };

  /// The squared chord of 45 degrees, 28 fraction bits.
  static constexpr std::uint32_t kWidestChord = 157245849u;

  template <class Method>
  static constexpr void prepare(const Lighting& lighting, const TriangleFrame<Method>& frame,
                                const Face& face, Prepared& prepared) {
    Base::prepare(lighting, frame, face, prepared);
    prepared.bits = lighting.bits;
    if (lighting.widest == 0) return;
    prepared.bits = literature::adaptive_segment_bits(
        kWidestChord, prepared.normal.step(), to_normal(frame.top->shade.normal),
        to_normal(frame.middle->shade.normal), to_normal(frame.bottom->shade.normal));
  }

  class Run {
   public:
    /// Segments begin at the row's first column wherever the row is cut, so that cutting changes no pixel.
    [[nodiscard]] static constexpr Run of_row(const Prepared& prepared, const RowStart& start) {
      const std::int32_t skipped = (start.skipped >> prepared.bits) << prepared.bits;
      RowStart first = start;
      first.skipped = skipped;
      // Columns after the first whose centres are left of the row's end; one too many does no harm.
      const literature::RowPixel row = literature::row_pixel(start);
      const std::int32_t following =
          row.bits == 16 ? static_cast<std::int32_t>((row.width + 1 - start.fraction) >> 16) : 0;
      return Run(prepared, first, following - skipped, start.skipped - skipped);
    }

    /// `start` is at the first pixel of a segment. `following` pixels of the row come after it; the run
    /// begins at the segment's pixel `first`.
    constexpr Run(const Prepared& prepared, const RowStart& start, std::int32_t following, std::int32_t first)
        : prepared_(&prepared),
          normal_(prepared.normal.at(start)),
          unit_{},
          following_(following),
          at_(first) {
      unrolled<Base::kScalars>([&](auto i) { scalars_[i] = linear_at(prepared.scalars[i], start); });
      const std::int32_t inverse = inverse_length();
      make_node(nodes_[0], inverse);
      (void)replace_unit(inverse);
      fill_segment();
    }

    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
      return lighting.colour(nodes_[static_cast<std::size_t>(at_)]);
    }
    constexpr void next() {
      const std::int32_t segment = 1 << prepared_->bits;
      if (++at_ < segment || following_ <= segment - 1) return;
      following_ -= segment;
      at_ = 0;
      const Scalars& last = nodes_[static_cast<std::size_t>(segment)];
      unrolled<Base::kScalars>([&](auto i) { nodes_[0][i] = last[i]; });
      fill_segment();
    }

   private:
    /// 1 / |normal_|, 15 fraction bits. A normal shorter than 1/32, which only occurs between opposite
    /// normals, counts as that long.
    [[nodiscard]] constexpr std::int32_t inverse_length() const {
      // Squares have 26 fraction bits. Outside of the triangle components may reach 9, and 22 must do.
      const int more = FullLast && exceeds(normal_, 28) ? 0 : 2;
      const auto squared = [&](Linear c) {
        const std::int32_t fine = wrap_shl(c.raw(), more);  // 27 fraction bits and those
        return static_cast<std::uint32_t>(multiply_high(fine, fine));
      };
      const std::uint32_t square = squared(normal_.x) + squared(normal_.y) + squared(normal_.z);
      constexpr std::uint32_t kLeast = std::uint32_t{1} << 16;  // 1/32 squared, 26 fraction bits
      const ReciprocalRoot root = reciprocal_root(square < kLeast ? kLeast : square);
      return static_cast<std::int32_t>((root.mantissa << 4) >> (root.exponent - 22 - more));
    }
    /// True if the magnitude of a component's raw value is 2^bits or more.
    [[nodiscard]] static constexpr bool exceeds(const LinearNormal& n, int bits) {
      const auto large = [bits](Linear c) { return (c.raw() >> bits) != 0 && (c.raw() >> bits) != -1; };
      return large(n.x) || large(n.y) || large(n.z);
    }
    [[nodiscard]] static constexpr Cosine scaled_to_unit(Linear value, std::int32_t inverse_length) {
      return Cosine::from_raw(wrap_mul(round_shift(value.raw(), Linear::kFraction), inverse_length));
    }

    /// Sets `node` to the scalars of Phong's normal at the present position.
    constexpr void make_node(Scalars& node, std::int32_t inverse_length) const {
      unrolled<Base::kScalars>([&](auto i) { node[i] = scaled_to_unit(scalars_[i], inverse_length); });
    }

    /// Replaces `unit_` by Phong's normal at the present position. Returns the squared chord between the old
    /// and the new one, 28 fraction bits.
    constexpr std::uint32_t replace_unit(std::int32_t inverse_length) {
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

    /// Goes from the segment's first pixel to its end and fills in the nodes up to there.
    constexpr void fill_segment() {
      if (following_ <= 0) return;
      int bits = prepared_->bits;
      std::int32_t length = 1 << bits;
      while (!FullLast && (length >> 1) >= following_) {
        length >>= 1;
        --bits;
      }
      advance(bits);
      const std::int32_t inverse = inverse_length();
      make_node(nodes_[static_cast<std::size_t>(length)], inverse);
      const std::uint32_t chord = replace_unit(inverse);
      // A change of 8 per segment, in rows of few pixels, would not fit a Linear.
      const bool steep = FullLast && exceeds(prepared_->normal.step(), 30 - bits);
      if (chord > kWidestChord || steep) {
        make_every_node(length);
      } else if (following_ < 1 << prepared_->bits) {
        halve(length, chord >> 12);
      } else if (bits == 2) {
        halve_whole<2>(chord >> 12);
      } else if (bits == 3) {
        halve_whole<3>(chord >> 12);
      } else {
        halve(length, chord >> 12);
      }
    }

    /// Goes 2^bits pixels to the right.
    constexpr void advance(int bits) {
      normal_.advance(scaled(prepared_->normal.step(), bits));
      unrolled<Base::kScalars>([&](auto i) { scalars_[i] += scaled(prepared_->scalars[i].dx, bits); });
    }

    /// Fills in the nodes between the ends of a segment with Phong's normals. Begins and ends at the
    /// segment's right end.
    constexpr void make_every_node(std::int32_t length) {
      const LinearNormal step = prepared_->normal.step();
      for (std::int32_t i = length - 1; i > 0; --i) {
        normal_.advance({-step.x, -step.y, -step.z});
        unrolled<Base::kScalars>([this](auto k) { scalars_[k] -= prepared_->scalars[k].dx; });
        make_node(nodes_[static_cast<std::size_t>(i)], inverse_length());
      }
      for (std::int32_t i = 1; i < length; ++i) advance(0);
    }

    /// Fills in the nodes of a whole segment of 2^SegmentBits pixels by halving; `s` is its squared chord, 16
    /// fraction bits. Unrolled for the lengths that S3 has figures for.
    template <int SegmentBits>
    constexpr void halve_whole(std::uint32_t s) {
      unrolled<SegmentBits>([&](auto level) {
        constexpr std::size_t kHalf = std::size_t{1} << (SegmentBits - 1 - decltype(level)::value);
        const std::int32_t q = Polynomial::above_half(s);
        unrolled<(std::size_t{1} << decltype(level)::value)>(
            [&](auto arc) { make_middle(kHalf + 2 * kHalf * decltype(arc)::value, kHalf, q); });
        s = halved_chord(s, q);
      });
    }

    /// Like halve_whole(), for any segment of `length` pixels and only those nodes that the row's pixels
    /// need.
    constexpr void halve(std::int32_t length, std::uint32_t s) {
      for (std::int32_t half = length >> 1; half != 0; half >>= 1) {
        const std::int32_t q = Polynomial::above_half(s);
        for (std::int32_t i = half; i < length && i - half < following_; i += half << 1) {
          make_middle(static_cast<std::size_t>(i), static_cast<std::size_t>(half), q);
        }
        s = halved_chord(s, q);
      }
    }

    constexpr void make_middle(std::size_t at, std::size_t half, std::int32_t q) {
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
    LinearNormal normal_;                         ///< linear, at the segment's right end
    std::array<Linear, Base::kScalars> scalars_;  ///< linear, at the segment's right end
    Normal unit_;                                 ///< normal_ divided by its length
    /// Scalars at the segment's pixels and at the first pixel of the next segment.
    std::array<Scalars, (std::size_t{1} << kMostSegmentBits) + 1> nodes_;
    std::int32_t following_;  ///< pixels of the row after the segment's first
    std::int32_t at_;         ///< present pixel of the segment
  };

  using Walker = PreparedWalker<Prepared, Run>;

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
/// S3's own root and polynomials, and its last segments of full length.
template <class Illumination>
using DichotomyRoot = Dichotomy<Illumination, RootItself, true>;
template <class Illumination>
using DichotomyPrintedLinear = Dichotomy<Illumination, PrintedLinearPolynomial, true>;
template <class Illumination>
using DichotomyPrintedQuadratic = Dichotomy<Illumination, PrintedQuadraticPolynomial, true>;

}  // namespace arcspan
