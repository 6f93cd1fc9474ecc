// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/shading/surface/chords.hpp>
#include <arcspan/shading/surface/run.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// Surfaces of small triangles (prepare/small_triangle.hpp) in barycentric coordinates b and c of the middle
/// and the bottom vertex:
///
///     x = x_a + b (x_b - x_a) + c (x_c - x_a)
///     e = b (ab (1 - b) + twist c) + c ac (1 - c),     twist = bc - ab - ac,
///
/// where ab, ac and bc are the squared chords of the edges.
namespace arcspan {

/// Planes of up to `Count` scalars, values with 30 fraction bits.
template <std::size_t Count>
class SmallPlanes {
 public:
  constexpr void prepare(std::size_t i, Cosine a, Cosine b, Cosine c, const SmallTriangle& triangle) {
    at_[i] = a;
    to_b_[i] = (b.raw() >> kDropped) - (a.raw() >> kDropped);
    to_c_[i] = (c.raw() >> kDropped) - (a.raw() >> kDropped);
    slope_[i] = Cosine::from_raw(
        wrap_shl(triangle.per_pixel(to_b_[i], to_c_[i]), kDropped - SmallTriangle::kStepBits));
  }
  /// Starts the steps of a row at the coordinates b and c, 16 fraction bits.
  template <std::size_t Used>
  ARCSPAN_INLINE constexpr void start(std::int32_t b, std::int32_t c, LinearSteps<Used>& steps) const {
    unrolled<Used>([&](auto i) {
      steps.x[i] = at_[i] + sum(i, b >> 1, c >> 1);
      steps.d[i] = slope_[i];
    });
  }

 private:
  /// Differences are at most 2, coordinates at most 1 with 15 fraction bits.
  static constexpr int kDropped = 15;
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine sum(std::size_t i, std::int32_t b, std::int32_t c) const {
    return Cosine::from_raw(wrap_add(wrap_mul(to_b_[i], b), wrap_mul(to_c_[i], c)));
  }

  std::array<Cosine, Count> at_;
  std::array<std::int32_t, Count> to_b_;
  std::array<std::int32_t, Count> to_c_;
  std::array<Cosine, Count> slope_;
};

/// The missing square of the normal's length, of a triangle that is not cut.
class SmallMissing {
 public:
  constexpr void prepare(const NormalChords& chords, const SmallTriangle& triangle) {
    const auto narrowed = [](std::uint32_t chord) {
      const std::uint32_t rounded = (chord + (1u << 15)) >> 16;
      return static_cast<std::int32_t>(rounded < kMostChord ? rounded : kMostChord);
    };
    ab_ = narrowed(chords.top_middle);
    ac_ = narrowed(chords.top_bottom);
    twist_ = narrowed(chords.middle_bottom) - ab_ - ac_;
    // All bits count, because every pixel of a row adds the errors of these again. Sums of products may wrap,
    // unlike the differences of e, which they end in.
    const std::int32_t db = triangle.d_middle();
    const std::int32_t dc = triangle.d_bottom();
    const std::int32_t ab_by_db = fine(wrap_mul(ab_, db));
    const std::int32_t ac_by_dc = fine(wrap_mul(ac_, dc));
    const std::int32_t twist_by_dc = fine(wrap_mul(twist_, dc));
    const std::int32_t bend = wrap_sub(wrap_mul(twist_by_dc - ab_by_db, wrap_add(db, 1) >> 1),
                                       wrap_mul(ac_by_dc, wrap_add(dc, 1) >> 1));
    second_difference_ = Cosine::from_raw(wrap_shl(bend, 1));
    first_ = wrap_add(wrap_shl(wrap_add(wrap_mul(ab_, db), wrap_mul(ac_, dc)), kUp - 1), bend);
    first_by_b_ = twist_by_dc - 2 * ab_by_db;
    first_by_c_ = fine(wrap_mul(twist_, db)) - 2 * ac_by_dc;
  }
  /// Starts the steps of a row at the coordinates b and c, 16 fraction bits.
  ARCSPAN_INLINE constexpr void start(std::int32_t b16, std::int32_t c16, QuadraticSteps<1>& steps) const {
    const std::int32_t b = b16 >> 1;
    const std::int32_t c = c16 >> 1;
    const std::int32_t of_b = narrow(wrap_add(wrap_mul(ab_, kOne - b), wrap_mul(twist_, c)));
    const std::int32_t of_c = narrow(wrap_mul(ac_, kOne - c));
    steps.x[0] = Cosine::from_raw(wrap_shl(wrap_add(wrap_mul(of_b, b), wrap_mul(of_c, c)), kUp));
    const std::int32_t first = wrap_add(wrap_mul(first_by_b_, b), wrap_mul(first_by_c_, c));
    steps.d[0] = Cosine::from_raw(wrap_add(first_, first));
    steps.second_difference[0] = second_difference_;
  }

 private:
  /// Fraction bits of chords and of coordinates.
  static constexpr int kChordBits = 12;
  static constexpr int kBits = 15;
  static constexpr int kUp = Cosine::kFraction - kChordBits - kBits;
  static constexpr std::int32_t kOne = std::int32_t{1} << kBits;
  /// 3.75: opposite normals have no direction half-way; up to here all sums fit.
  static constexpr std::uint32_t kMostChord = 15u << (kChordBits - 2);
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::int32_t narrow(std::int32_t product) {
    return round_shift(product, kBits);
  }
  /// A product of a chord and a coordinate with 16 fraction bits, rounded to 15.
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::int32_t fine(std::int32_t product) {
    return round_shift(product, kChordBits + 1);
  }

  std::int32_t ab_;
  std::int32_t ac_;
  std::int32_t twist_;
  std::int32_t first_;       ///< first difference along a row at b = c = 0; 30 fraction bits
  std::int32_t first_by_b_;  ///< 15 fraction bits, as the next
  std::int32_t first_by_c_;
  Cosine second_difference_;
};

/// The surface of a small triangle, in one piece, so that rows need one reference.
template <std::size_t Count>
struct SmallSurface {
  SmallPlanes<Count> planes;
  SmallMissing missing;  ///< set if the surface is normalised
};

/// The rows of a small surface: linear, or normalised if `RunOf` is a NormalisedRun.
template <class RunOf, std::size_t Count>
struct SmallRows {
  using Run = RunOf;
  const SmallSurface<Count>& surface;

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(std::int32_t, std::int32_t b, std::int32_t c) const {
    Run run;
    if constexpr (requires { run.missing; }) {
      surface.planes.start(b, c, run.linear);
      surface.missing.start(b, c, run.missing);
    } else {
      surface.planes.start(b, c, run);
    }
    return run;
  }
};

}  // namespace arcspan
