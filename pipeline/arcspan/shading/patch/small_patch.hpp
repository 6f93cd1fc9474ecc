// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A scalar of a small triangle a, b, c: the surface of a patch (patch.hpp) in barycentric coordinates,
///
///     f = I_a + l_b (I_b - I_a + l_a b_ab) + l_c (I_c - I_a + l_a b_ac + l_b b_bc).
struct SmallPatchScalar {
  Cosine a;  ///< value at vertex a
  /// The other two values relative to it, and the quadruple sagittas, with the fraction bits of the
  /// coordinates.
  std::int32_t b;
  std::int32_t c;
  std::int32_t ab;
  std::int32_t ac;
  std::int32_t bc;
};

/// The scalars of a small triangle as quadratic surfaces. `Bits` are the fraction bits of coordinates: 16
/// where values differ by less than a half, 15 for others.
template <class Lighting, std::size_t Used, int Bits>
class SmallPatch {
 public:
  using Run = PatchRun<Lighting, Used>;

  /// Prepares the first `Used` scalars of three vertices with these squared chords (28 fraction bits).
  template <class Scalars>
  constexpr void prepare(const Scalars& a, const Scalars& b, const Scalars& c, std::uint32_t ab,
                         std::uint32_t bc, std::uint32_t ca) {
    const std::int32_t of_ab = sagitta_factor(ab).raw();
    const std::int32_t of_bc = sagitta_factor(bc).raw();
    const std::int32_t of_ca = sagitta_factor(ca).raw();
    const auto rounded = [](std::int32_t raw) { return round_shift(raw, Cosine::kFraction - Bits); };
    const auto sagitta = [](Cosine p, Cosine q, std::int32_t factor) {
      // The mean has 15 fraction bits and the factor 18.
      const std::int32_t mean = wrap_add(p.raw() >> 1, q.raw() >> 1) >> 15;
      return round_shift(wrap_mul(mean, factor), 15 + SagittaFactor::kFraction - Bits);
    };
    for (std::size_t i = 0; i < Used; ++i) {
      SmallPatchScalar& scalar = scalars_[i];
      scalar.a = a[i];
      scalar.b = rounded(wrap_sub(b[i].raw(), a[i].raw()));
      scalar.c = rounded(wrap_sub(c[i].raw(), a[i].raw()));
      scalar.ab = sagitta(a[i], b[i], of_ab);
      scalar.ac = sagitta(a[i], c[i], of_ca);
      scalar.bc = sagitta(b[i], c[i], of_bc);
    }
  }

  /// Rows need nothing of their own.
  [[nodiscard]] constexpr const SmallPatch& row(std::int32_t) const { return *this; }

  /// Returns the pixel at the barycentric coordinates l_b and l_c, 16 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr Run at(std::int32_t b16, std::int32_t c16) const {
    const std::int32_t b = b16 >> (16 - Bits);
    const std::int32_t c = c16 >> (16 - Bits);
    const std::int32_t a = (std::int32_t{1} << Bits) - b - c;
    Run run;
    unrolled<Used>([&](auto i) {
      const SmallPatchScalar& scalar = scalars_[i];
      const std::int32_t along_b = scalar.b + (wrap_mul(scalar.ab, a) >> Bits);
      const std::int32_t along_c =
          scalar.c + (wrap_add(wrap_mul(scalar.ac, a), wrap_mul(scalar.bc, b)) >> Bits);
      const std::int32_t above = wrap_add(wrap_mul(along_b, b), wrap_mul(along_c, c));
      run.start_at(i, {scalar.a + Cosine::from_raw(above >> (2 * Bits - Cosine::kFraction)), {}, {}});
    });
    return run;
  }

 private:
  std::array<SmallPatchScalar, Used> scalars_;
};

}  // namespace arcspan
