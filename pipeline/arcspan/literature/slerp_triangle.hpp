// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/arc_vertex.hpp>
#include <arcspan/literature/linear_normal.hpp>
#include <arcspan/literature/row_pixel.hpp>
#include <arcspan/literature/sine_table.hpp>
#include <arcspan/literature/wide_rows.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace detail {

/// numerator / v, 30 fraction bits, saturated at 1; `inverse` is the reciprocal of v.
[[nodiscard]] constexpr std::uint32_t ratio30(std::uint32_t numerator, const Reciprocal& inverse) {
  const std::uint64_t product = std::uint64_t{numerator} * inverse.mantissa;
  const int down = inverse.exponent - 30;
  const std::uint64_t ratio = down >= 0 ? product >> down : product << -down;
  return ratio > (std::uint32_t{1} << 30) ? std::uint32_t{1} << 30 : static_cast<std::uint32_t>(ratio);
}

/// angle * fraction, rounded down; `fraction` in 0...1 with 30 fraction bits.
[[nodiscard]] constexpr Angle32 part_of(Angle32 angle, std::uint32_t fraction) {
  return static_cast<Angle32>((std::uint64_t{angle} * fraction) >> 30);
}

}  // namespace detail

/// Scalars of a unit normal: first its three components, then `Count` - 3 others that are linear in it.
template <std::size_t Count>
using SlerpValues = std::array<Cosine, Count>;

/// The weights of S0 eq. 2, N(t) = [sin((1-t) psi) A + sin(t psi) B] / sin(psi), on an arc between two unit
/// normals A and B.
///
/// psi is limited to 2^-8 rad ... 60 degrees: a wider arc counts as 60 degrees, a shorter one as 2^-8 rad.
/// For shorter ones the weights differ from linear ones by less than 2e-6, and the sines would have too few
/// bits.
struct SlerpArc {
  Angle32 angle;               ///< psi
  std::uint32_t inverse_sine;  ///< mantissa of 1 / sin(psi), in [2^15, 2^16]
  int zeros;                   ///< leading zeros of sin(psi) with 30 fraction bits

  /// The arc between the unit normals in the first three values of `a` and `b`. Takes one root.
  template <std::size_t Count>
  [[nodiscard]] static constexpr SlerpArc of(const SlerpValues<Count>& a, const SlerpValues<Count>& b) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t difference = round_shift(wrap_sub(a[i].raw() >> 1, b[i].raw() >> 1), 14);
      sum += static_cast<std::uint64_t>(difference * difference);
    }
    const std::uint32_t chord =
        sum > (std::uint32_t{1} << 30) ? std::uint32_t{1} << 30 : static_cast<std::uint32_t>(sum);
    // psi^2 = s (1 + s/12 + s^2/90 + s^3/560 + ...), as in arc_angle.hpp, with the rest of the series in the
    // last coefficient.
    const std::uint32_t s = chord >> 15;
    const std::uint32_t inner = 364u + ((s * 73u) >> 15);
    const std::uint32_t outer = 2731u + ((s * inner) >> 15);
    const std::uint32_t root = nearest_root(chord + s * ((s * outer) >> 15));
    constexpr std::uint32_t kTwoOverPi = 20861;  // 15 fraction bits
    const Angle32 angle = root < 128 ? 128 * kTwoOverPi : root * kTwoOverPi;
    const std::uint32_t sine = quarter_sine(angle);
    const Reciprocal inverse = reciprocal(sine);
    return {angle, inverse.mantissa, 47 - inverse.exponent};
  }

  /// sin(part) / sin(psi), 15 fraction bits, for part <= psi.
  [[nodiscard]] constexpr std::int32_t weight(Angle32 part) const {
    const std::uint32_t sine = (quarter_sine(part) << zeros) >> 16;
    return static_cast<std::int32_t>((sine * inverse_sine + (1u << 15)) >> 16);
  }

  /// Factors of A and B, 15 fraction bits each.
  struct Weights {
    std::int32_t a;
    std::int32_t b;
  };
  /// The weights at angle `phase` from A; beyond psi those of B, because the steps may add up to more than
  /// psi.
  [[nodiscard]] constexpr Weights at(Angle32 phase) const {
    const Angle32 held = phase < angle ? phase : angle;
    return {weight(angle - held), weight(held)};
  }
};

/// The scalars along an edge by S0 eq. 2, stepped from row to row. They depend only on the edge's two ends,
/// so that the two triangles of an edge agree.
template <std::size_t Count>
struct SlerpEdge {
  SlerpValues<Count> top;
  SlerpValues<Count> bottom;
  SlerpArc arc;
  Angle32 phase;
  Angle32 step;

  constexpr void make(const EdgeSetup& edge, const SlerpValues<Count>& from, const SlerpValues<Count>& to) {
    top = from;
    bottom = to;
    arc = SlerpArc::of(from, to);
    phase =
        detail::part_of(arc.angle, detail::ratio30(static_cast<std::uint32_t>(edge.offset), edge.inverse));
    step = detail::part_of(arc.angle, detail::ratio30(1u << Subpixel::kFraction, edge.inverse));
  }
  constexpr void advance() { phase += step; }

  [[nodiscard]] constexpr SlerpValues<Count> here() const {
    const SlerpArc::Weights w = arc.at(phase);
    SlerpValues<Count> values;
    unrolled<Count>([&](auto i) {
      const std::int64_t sum = std::int64_t{top[i].raw()} * w.a + std::int64_t{bottom[i].raw()} * w.b;
      values[i] = Cosine::from_raw(static_cast<std::int32_t>((sum + (1 << 14)) >> 15));
    });
    return values;
  }
};

/// A row: the scalars at its two ends and the arc between them.
template <std::size_t Count>
struct SlerpRow {
  SlerpValues<Count> left;
  SlerpValues<Count> right;
  SlerpArc arc;
  Angle32 phase;  ///< of the first pixel, from the left end
  Angle32 step;   ///< per pixel
};

/// The prepared part of a method that finds both ends of every row by S0 eq. 2.
template <std::size_t Count>
struct SlerpTriangle {
  SlerpEdge<Count> long_edge;
  SlerpEdge<Count> upper_edge;
  SlerpEdge<Count> lower_edge;
  bool middle_left;
  bool in_lower;

  template <class Frame>
  constexpr void make(Frame& frame) {
    const auto& top = frame.top->shade.scalars;
    const auto& middle = frame.middle->shade.scalars;
    const auto& bottom = frame.bottom->shade.scalars;
    long_edge.make(frame.long_edge, top, bottom);
    if (frame.has_upper) upper_edge.make(frame.upper_edge, top, middle);
    if (frame.has_lower) lower_edge.make(frame.lower_edge, middle, bottom);
    middle_left = frame.middle_left;
    in_lower = false;
  }
  constexpr void next_row() {
    long_edge.advance();
    (in_lower ? lower_edge : upper_edge).advance();
  }
  constexpr void enter_lower() { in_lower = true; }

  [[nodiscard]] constexpr SlerpRow<Count> row(const RowStart& start) const {
    const SlerpEdge<Count>& short_edge = in_lower ? lower_edge : upper_edge;
    SlerpRow<Count> row;
    row.left = (middle_left ? short_edge : long_edge).here();
    row.right = (middle_left ? long_edge : short_edge).here();
    row.arc = SlerpArc::of(row.left, row.right);
    const literature::RowPixel first = literature::row_pixel(start);
    const Reciprocal inverse = nonzero_reciprocal(first.width);
    const std::uint32_t inside = first.inside < first.width ? first.inside : first.width;
    row.phase = detail::part_of(row.arc.angle, detail::ratio30(inside, inverse));
    // A row shorter than a pixel has one pixel and no step.
    row.step = first.bits != 16
                   ? 0
                   : detail::part_of(row.arc.angle, detail::ratio30(std::uint32_t{1} << 16, inverse));
    return row;
  }
};

/// The common part of Slerp and KuijkBlake: vertices carry the normal's three components and `More` other
/// scalars.
template <class Illumination, std::size_t More>
struct SlerpBase : literature::ArcMethod<Illumination, 3 + More> {
  static constexpr std::size_t kCount = 3 + More;
  using Base = literature::ArcMethod<Illumination, kCount>;
  using typename Base::Face;
  using typename Base::Lighting;
  using typename Base::Vertex;
  using Prepared = literature::NarrowOrWide<SlerpTriangle<kCount>, kCount>;

  template <class Frame>
  static constexpr void prepare(const Lighting&, const Frame& unmeasured, const Face&, Prepared& prepared) {
    literature::MeasuredFrame<Frame> frame(unmeasured);
    if (!prepared.prepare_if_wide(frame)) prepared.narrow.make(frame);
  }

 protected:
  /// A vertex with the components of `n`; the other scalars are 0.
  [[nodiscard]] static constexpr Vertex vertex_of(const Direction& n) {
    Vertex vertex{to_normal(n), {}};
    vertex.scalars[0] = convert<Cosine>(n.x);
    vertex.scalars[1] = convert<Cosine>(n.y);
    vertex.scalars[2] = convert<Cosine>(n.z);
    return vertex;
  }
};

}  // namespace arcspan
