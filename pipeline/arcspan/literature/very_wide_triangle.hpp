// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/arc_vertex.hpp>
#include <arcspan/literature/row_angles.hpp>
#include <arcspan/literature/row_pieces.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan::literature {

/// An edge that may be wider than 60 degrees, and the part of it that holds the current row: the whole edge,
/// a half or a quarter, whichever is narrow enough for ArcShape.
template <std::size_t Count>
struct DividedEdge {
  static constexpr int kBits = 30;  ///< of fraction.t

  EdgeFraction fraction;           ///< of the whole edge, from its upper end
  std::array<Cosine, Count> from;  ///< scalars at the part's upper end
  std::array<Cosine, Count> to;    ///< scalars at its lower end
  ArcShape shape;                  ///< of the part
  std::uint8_t halvings;           ///< the edge has 2^halvings parts of this size
  std::uint8_t end;                ///< of the part, in quarters of the edge; + kLast if it is the last one
  static constexpr std::uint8_t kLast = 8;

  constexpr void start(const EdgeFraction& at) {
    fraction = at;
    halvings = 0;
    end = 0;
  }
  /// Returns false if the current row is not on the part. The part's end belongs to the next one.
  [[nodiscard]] constexpr bool is_on_part() const { return (fraction.t >> (kBits - 2)) < end; }
  /// Sets the part that holds the current row, of the edge between the vertices `upper` and `lower`, which
  /// become the part's ends.
  constexpr void find_part(ArcVertex<Count>& upper, ArcVertex<Count>& lower) {
    for (halvings = 0; halvings < 2 && squared_chord(upper.normal, lower.normal) > kWidestArc;) {
      ++halvings;
      const bool is_second = (part_of_row() & 1) != 0;
      (is_second ? upper : lower) = half_way(upper, lower);
    }
    const std::int32_t quarters = (part_of_row() + 1) << (2 - halvings);
    end = static_cast<std::uint8_t>(quarters == 4 ? 4 + kLast : quarters);
    from = upper.scalars;
    to = lower.scalars;
    const std::uint32_t chord = squared_chord(upper.normal, lower.normal);
    shape = ArcShape(chord < kWidestArc ? chord : kWidestArc);
  }
  /// Returns the index of the part that holds the current row; the edge's lower end belongs to the last part.
  [[nodiscard]] constexpr std::int32_t part_of_row() const {
    constexpr std::int32_t kLatest = (std::int32_t{1} << kBits) - 1;
    return (fraction.t < kLatest ? fraction.t : kLatest) >> (kBits - halvings);
  }
  /// Returns the fraction of the part at the current row.
  [[nodiscard]] constexpr Factor on_part() const {
    const std::int32_t to_end = wrap_sub(wrap_shl(end & 7, kBits - 2), fraction.t);
    constexpr std::int32_t kOne = std::int32_t{1} << kBits;
    return Factor::from_raw(wrap_sub(kOne, wrap_shl(to_end, halvings)) >> (kBits - Factor::kFraction));
  }
  /// Sets `scalars` to those at the fraction `t` of the part.
  constexpr void set_scalars(Factor t, std::array<Cosine, Count>& scalars) const {
    const std::int32_t excess = shape.excess(t);
    unrolled<Count>([&](auto i) { scalars[i] = shape.between(from[i], to[i], t, excess); });
  }
};

/// A triangle with normals more than 60 degrees apart, for which neither ArcShape nor RowAngles hold, to be
/// drawn in pieces of rows (WideWalker). Its edges are divided into parts of at most 60 degrees, and the
/// angle of a row follows from the normals at the ends of the two parts.
template <std::size_t Count>
struct VeryWideTriangle {
  ArcVertex<Count> top;
  ArcVertex<Count> middle;
  ArcVertex<Count> bottom;
  EdgeFraction lower_edge;  ///< from its upper end
  DividedEdge<Count> long_edge;
  DividedEdge<Count> short_edge;  ///< of the current half
  /// The dot products of the normals at the ends of both edges' current parts, 15 fraction bits: first the
  /// normal on the long edge, then the one on the short edge: from·from, from·to, to·from, to·to.
  std::array<std::int32_t, 4> products;
  Factor widest_piece;  ///< squared angle of a piece of a row, at most
  bool middle_left;     ///< the middle vertex is on the left of the long edge
  bool in_lower;        ///< the current row is in the lower half

  /// `Frame` is a TriangleFrame whose chords are measured and whose vertices are ArcVertex.
  template <class Frame>
  ARCSPAN_OUTLINE constexpr void prepare(Frame& frame, Factor widest) {
    widest_piece = widest;
    middle_left = frame.middle_left;
    in_lower = false;
    top = frame.top->shade;
    middle = frame.middle->shade;
    bottom = frame.bottom->shade;
    long_edge.start(EdgeFraction::of(frame.long_edge, true));
    if (frame.has_lower) lower_edge = EdgeFraction::of(frame.lower_edge, true);
    if (!frame.has_upper) return;
    short_edge.start(EdgeFraction::of(frame.upper_edge, true));
    find_parts();
  }

  constexpr void next_row() {
    long_edge.fraction.advance();
    short_edge.fraction.advance();
    if (!long_edge.is_on_part() || !short_edge.is_on_part()) find_parts();
  }
  constexpr void enter_lower() {
    in_lower = true;
    short_edge.start(lower_edge);
    find_parts();
  }

  /// Sets `ends` to the scalars of the current row and to its squared angle. A row of more than 60 degrees is
  /// halved; the ends are then those of the part in which `start` lies, and `start` becomes relative to it.
  /// Returns the pixels from there to the end of the part, INT32_MAX in the last one.
  [[nodiscard]] ARCSPAN_OUTLINE constexpr std::int32_t row(RowPixel& start, RowEnds<Count>& ends) const {
    const Factor on_long = long_edge.on_part();
    const Factor on_short = short_edge.on_part();
    long_edge.set_scalars(on_long, middle_left ? ends.right : ends.left);
    short_edge.set_scalars(on_short, middle_left ? ends.left : ends.right);
    std::uint32_t chord = row_chord({long_edge.shape, on_long}, {short_edge.shape, on_short});
    std::int32_t length = INT32_MAX;
    while (chord > kWidestArc) {
      const HalfWay half(chord);
      const RowPiece part = piece_of_row(start, 1);
      auto& replaced = part.index != 0 ? ends.left : ends.right;
      for (std::size_t i = 0; i < Count; ++i) {
        replaced[i] = Cosine::from_raw(half.of(std::int64_t{ends.left[i].raw()} + ends.right[i].raw()));
      }
      start = {part.inside, part.width >> 1, part.bits};
      if (part.length < length) length = part.length;
      chord = half.chord();
    }
    ends.angle2 = Factor::from_raw(static_cast<std::int32_t>(squared_angle(chord >> 12) >> 1));
    return length;
  }

 private:
  ARCSPAN_OUTLINE constexpr void find_parts() {
    std::array<ArcVertex<Count>, 4> ends{top, bottom, in_lower ? middle : top, in_lower ? bottom : middle};
    long_edge.find_part(ends[0], ends[1]);
    short_edge.find_part(ends[2], ends[3]);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t chord = squared_chord(ends[i >> 1].normal, ends[2 + (i & 1)].normal);
      products[i] = 32768 - static_cast<std::int32_t>(chord >> 14);
    }
  }

  /// Returns the squared chord of a row between points of both parts, 28 fraction bits.
  [[nodiscard]] constexpr std::uint32_t row_chord(const ArcWeights& on_long,
                                                  const ArcWeights& on_short) const {
    const auto mixed = [&](std::int32_t with_a, std::int32_t with_c) {
      return wrap_add(wrap_mul(static_cast<std::int32_t>(on_short.a), with_a),
                      wrap_mul(static_cast<std::int32_t>(on_short.c), with_c)) >>
             15;
    };
    const std::int32_t product =  // of both normals, 30 fraction bits
        wrap_add(wrap_mul(static_cast<std::int32_t>(on_long.a), mixed(products[0], products[1])),
                 wrap_mul(static_cast<std::int32_t>(on_long.c), mixed(products[2], products[3])));
    const std::int32_t chord = 65536 - (product >> 14);  // 15 fraction bits
    return chord <= 0 ? 0u : static_cast<std::uint32_t>(chord) << 13;
  }
};

}  // namespace arcspan::literature
