// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A scalar of a small triangle a, b, c: the surface of a patch (patch.hpp) in barycentric coordinates,
///
///     f = I_a + l_b (to_b - ab l_b + twist l_c) + l_c (to_c - ac l_c),
///     to_b = I_b - I_a + ab,   to_c = I_c - I_a + ac,   twist = bc - ab - ac,
///
/// where ab, bc and ac are the quadruple sagittas of the edges.
struct SmallPatchScalar {
  Cosine a;  ///< value at vertex a
  /// The factors have the fraction bits of the coordinates.
  std::int32_t to_b;
  std::int32_t to_c;
  std::int32_t ab;
  std::int32_t ac;
  std::int32_t twist;
  Cosine second_difference;  ///< per pixel
};

/// The scalars of a small triangle as quadratic surfaces. `Bits` are the fraction bits of coordinates: 16
/// where values differ by less than a half; 15 for a surface without a highlight, up to 60 degrees wide.
template <class Lighting, std::size_t Used, int Bits>
class SmallPatch {
 public:
  using Run = PatchRun<Lighting, Used>;

  /// Prepares the first `Used` scalars of three vertices with these squared chords (28 fraction bits).
  template <class Scalars>
  constexpr void prepare(const Scalars& a, const Scalars& b, const Scalars& c, const TriangleChords& chords,
                         const SmallTriangle& triangle) {
    db_ = triangle.d_middle >> kDropped;
    dc_ = triangle.d_bottom >> kDropped;
    const std::int32_t of_ab = factor_of(chords.top_middle);
    const std::int32_t of_bc = factor_of(chords.middle_bottom);
    const std::int32_t of_ca = factor_of(chords.top_bottom);
    const auto rounded = [](std::int32_t raw) { return round_shift(raw, Cosine::kFraction - Bits); };
    const auto sagitta = [](Cosine p, Cosine q, std::int32_t factor) {
      // The mean has 15 fraction bits.
      const std::int32_t mean = wrap_add(p.raw() >> 1, q.raw() >> 1) >> 15;
      return round_shift(wrap_mul(mean, factor), 15 + kFactorBits - Bits);
    };
    for (std::size_t i = 0; i < Used; ++i) {
      SmallPatchScalar& scalar = scalars_[i];
      scalar.a = a[i];
      scalar.ab = sagitta(a[i], b[i], of_ab);
      scalar.ac = sagitta(a[i], c[i], of_ca);
      scalar.twist = sagitta(b[i], c[i], of_bc) - scalar.ab - scalar.ac;
      scalar.to_b = rounded(wrap_sub(b[i].raw(), a[i].raw())) + scalar.ab;
      scalar.to_c = rounded(wrap_sub(c[i].raw(), a[i].raw())) + scalar.ac;
      // Rounded, because their errors grow with the square of a run's length.
      const std::int32_t along_b =
          round_shift(wrap_sub(wrap_mul(scalar.twist, dc_), wrap_mul(scalar.ab, db_)), Bits);
      const std::int32_t along_c = round_shift(wrap_mul(scalar.ac, dc_), Bits);
      scalar.second_difference = product(wrap_sub(wrap_mul(along_b, db_), wrap_mul(along_c, dc_)), -1);
    }
  }

  /// Returns the run that begins at the barycentric coordinates l_b and l_c, 16 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(std::int32_t, std::int32_t b16, std::int32_t c16) const {
    const std::int32_t b = b16 >> kDropped;
    const std::int32_t c = c16 >> kDropped;
    Run run;
    unrolled<Used>([&](auto i) {
      const SmallPatchScalar& scalar = scalars_[i];
      const std::int32_t bend_b = times(scalar.ab, b);
      const std::int32_t bend_c = times(scalar.ac, c);
      // The surface is I_a + b along_b + c along_c; its derivatives by b and by c follow.
      const std::int32_t along_b = scalar.to_b - bend_b + times(scalar.twist, c);
      const std::int32_t along_c = scalar.to_c - bend_c;
      const std::int32_t by_c = along_c - bend_c + times(scalar.twist, b);
      const Cosine slope = product(wrap_add(wrap_mul(along_b - bend_b, db_), wrap_mul(by_c, dc_)));
      run.start_at(i,
                   {scalar.a + product(wrap_add(wrap_mul(along_b, b), wrap_mul(along_c, c))),
                    slope + Cosine::from_raw(scalar.second_difference.raw() >> 1), scalar.second_difference});
    });
    return run;
  }

 private:
  static constexpr int kDropped = 16 - Bits;
  static constexpr bool kIsWide = Bits < 16;
  static constexpr int kFactorBits = kIsWide ? 16 : SagittaFactor::kFraction;

  [[nodiscard]] ARCSPAN_INLINE static constexpr std::int32_t factor_of(std::uint32_t chord) {
    if constexpr (kIsWide) return balanced_sagitta_factor(chord);
    return sagitta_factor(chord).raw();
  }

  /// Returns a factor times a coordinate as a factor.
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::int32_t times(std::int32_t factor,
                                                                   std::int32_t coordinate) {
    return wrap_mul(factor, coordinate) >> Bits;
  }
  /// Returns the value of a product of a factor and a coordinate, divided by 2^down.
  [[nodiscard]] ARCSPAN_INLINE static constexpr Cosine product(std::int32_t raw, int down = 0) {
    const int drop = 2 * Bits - Cosine::kFraction + down;
    return Cosine::from_raw(drop < 0 ? wrap_shl(raw, -drop) : raw >> drop);
  }

  std::int32_t db_;
  std::int32_t dc_;
  std::array<SmallPatchScalar, Used> scalars_;
};

}  // namespace arcspan
