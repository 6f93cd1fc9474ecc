// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/polar.hpp>
#include <arcspan/literature/prepared_walker.hpp>
#include <arcspan/literature/slerp_triangle.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

/// Kuijk's and Blake's angular interpolation (S0 [3]), for comparison. Along the arc of a row every product
/// of the normal is a cosine, N·L = A cos(t phi - alpha). Each row finds A and alpha from its two ends by
/// trigonometry. Each pixel takes one addition, and per scalar a cosine from a table and one product.
template <class Illumination>
struct KuijkBlake : SlerpBase<Illumination, Illumination::kScalars> {
  static constexpr std::size_t kScalars = Illumination::kScalars;
  using Base = SlerpBase<Illumination, kScalars>;
  using typename Base::Lighting;
  using typename Base::Prepared;
  using typename Base::Vertex;

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    Vertex vertex = Base::vertex_of(normal);
    const typename Lighting::Scalars scalars = lighting.scalars(normal);
    for (std::size_t i = 0; i < kScalars; ++i) vertex.scalars[3 + i] = scalars[i];
    return vertex;
  }

  /// A scalar along the row: amplitude * cos(phase), where the phase grows by the same step per pixel.
  struct Wave {
    std::int32_t amplitude;  ///< 15 fraction bits
    Angle32 phase;           ///< t phi - alpha
  };
  struct Run {
    std::array<Wave, kScalars> waves;
    Angle32 step;

    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
      typename Lighting::Scalars values;
      unrolled<kScalars>([&](auto i) {
        values[i] = Cosine::from_raw(wrap_mul(waves[i].amplitude, round_shift(cosine(waves[i].phase), 15)));
      });
      return lighting.colour(values);
    }
    constexpr void next() {
      unrolled<kScalars>([this](auto i) { waves[i].phase += step; });
    }

    [[nodiscard]] static constexpr Run of_row(const SlerpTriangle<Base::kCount>& triangle,
                                              const RowStart& start) {
      const SlerpRow<Base::kCount> row = triangle.row(start);
      Run run;
      run.step = row.step;
      unrolled<kScalars>([&](auto i) { run.waves[i] = wave(row, row.left[3 + i], row.right[3 + i]); });
      return run;
    }

   private:
    /// The wave I(t) = A cos(t phi - alpha) with I(0) = a and I(psi) = b, which means
    /// (A cos alpha, A sin alpha) = (a, (b - a cos psi) / sin psi).
    [[nodiscard]] static constexpr Wave wave(const SlerpRow<Base::kCount>& row, Cosine a, Cosine b) {
      const std::int64_t beside =
          b.raw() - ((std::int64_t{a.raw()} * cosine(row.arc.angle) + (std::int32_t{1} << 29)) >> 30);
      // 1 / sin(psi) = inverse_sine * 2^(zeros - 47) per unit of 2^-30; 29 fraction bits remain.
      const std::int64_t quotient = (beside * row.arc.inverse_sine) >> (18 - row.arc.zeros);
      const std::int64_t kMost = std::int32_t{1} << 29;
      const std::int64_t held = quotient > kMost ? kMost : quotient < -kMost ? -kMost : quotient;
      const Polar polar = to_polar(a.raw() >> 1, static_cast<std::int32_t>(held));
      return {round_shift(polar.size, 14), row.phase - polar.angle};
    }
  };
  using Walker = PreparedWalker<SlerpTriangle<Base::kCount>, Run>;

  /// Returns the colour of the values that a vertex carries.
  [[nodiscard]] static constexpr PackedRgb colour_of(const Lighting& lighting,
                                                     const SlerpValues<Base::kCount>& values) {
    typename Lighting::Scalars scalars;
    for (std::size_t i = 0; i < kScalars; ++i) scalars[i] = values[3 + i];
    return lighting.colour(scalars);
  }

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if (prepared.is_wide) return draw(literature::VeryWideWalker<KuijkBlake, Base::kCount>(prepared.wide));
    return draw(Walker(prepared.narrow));
  }
};

}  // namespace arcspan
