// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/arc_edge.hpp>
#include <arcspan/shading/arc/arc_vertex.hpp>
#include <arcspan/shading/arc/row_angles.hpp>
#include <arcspan/shading/arc/row_pieces.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// An edge that may be wider than 60 degrees, and the part of it that holds the current row: the whole edge,
/// a half or a quarter, whichever is narrow enough for ArcShape.
template <std::size_t Count>
struct DividedEdge {
  EdgeFraction fraction;  ///< of the whole edge, from its upper end
  std::int32_t begin;     ///< of the part, as fraction.t
  std::int32_t size;      ///< of the part, 2^30 or less; 0 if no part is set
  int halvings;
  ArcVertex<Count> from;  ///< upper end of the part
  ArcVertex<Count> to;
  ArcShape shape;

  constexpr void start(const EdgeFraction& at) {
    fraction.t = at.t;
    fraction.dt = at.dt;
    begin = -1;
    size = 0;
  }
  /// Returns false if the current row is not on the part. The part's end belongs to the next one, so that a
  /// row has the same part whether or not the rows above were drawn.
  [[nodiscard]] constexpr bool is_on_part() const {
    return static_cast<std::uint32_t>(wrap_sub(fraction.t, begin)) < static_cast<std::uint32_t>(size);
  }
  /// Sets the part that holds the current row, of the edge from `top` to `bottom`.
  ARCSPAN_COLD_OUTLINE constexpr void find_part(const ArcVertex<Count>& top, const ArcVertex<Count>& bottom) {
    from = top;
    to = bottom;
    begin = 0;
    size = std::int32_t{1} << 30;
    for (halvings = 0; halvings < 2 && squared_chord(from.normal, to.normal) > kWidestArc; ++halvings) {
      size >>= 1;
      const ArcVertex<Count> middle = half_way(from, to);
      if (wrap_sub(fraction.t, begin) < size) {
        to = middle;
      } else {
        from = middle;
        begin += size;
      }
    }
    const std::uint32_t chord = squared_chord(from.normal, to.normal);
    shape = ArcShape(chord < kWidestArc ? chord : kWidestArc);
  }
  /// Returns the fraction of the part at the current row.
  [[nodiscard]] constexpr Factor on_part() const {
    return Factor::from_raw(wrap_shl(wrap_sub(fraction.t, begin), halvings) >> 15);
  }
};

/// A triangle with normals more than 60 degrees apart, for which neither ArcShape nor RowAngles hold. Its
/// edges are divided into parts of at most 60 degrees, and the angle of a row follows from the normals at the
/// ends of the two parts.
template <std::size_t Count>
struct VeryWideTriangle {
  ArcVertex<Count> top;
  ArcVertex<Count> middle;
  ArcVertex<Count> bottom;
  EdgeFraction lower_edge;  ///< from its upper end
  DividedEdge<Count> long_edge;
  DividedEdge<Count> short_edge;  ///< of the current half
  std::array<std::int32_t, 4>
      products;  ///< of the normals at the ends of the parts, 15 fraction bits: from·from,
                 ///< from·to, to·from and to·to, that of the long edge first

  template <class Frame>
  ARCSPAN_COLD_OUTLINE constexpr void prepare(Frame& frame) {
    make_short_inverses(frame);
    top = frame.top->shade;
    middle = frame.middle->shade;
    bottom = frame.bottom->shade;
    long_edge.start(edge_fraction(frame.long_edge, true));
    if (frame.has_upper) short_edge.start(edge_fraction(frame.upper_edge, true));
    if (frame.has_lower) lower_edge = edge_fraction(frame.lower_edge, true);
  }

  constexpr void next_row() {
    long_edge.fraction.advance();
    short_edge.fraction.advance();
  }
  constexpr void skip_rows(std::int32_t rows) {
    long_edge.fraction.advance(rows);
    short_edge.fraction.advance(rows);
  }
  constexpr void enter_lower() { short_edge.start(lower_edge); }

  /// Sets `ends` to the first `Used` scalars of the current row and to its squared angle. A row of more than
  /// 60 degrees is halved; the ends are then those of the part in which `start` lies, and `start` becomes
  /// relative to it. Returns the pixels from there to the end of the part, INT32_MAX in the last one.
  template <std::size_t Used>
  [[nodiscard]] ARCSPAN_OUTLINE constexpr std::int32_t row(bool in_lower, bool middle_left, RowStart& start,
                                                           RowEnds<Count>& ends) {
    if (!long_edge.is_on_part() || !short_edge.is_on_part()) find_parts(in_lower);
    const Factor on_long = long_edge.on_part();
    const Factor on_short = short_edge.on_part();
    const std::int32_t long_excess = long_edge.shape.excess(on_long);
    const std::int32_t short_excess = short_edge.shape.excess(on_short);
    std::array<Cosine, Count>& at_long = middle_left ? ends.right : ends.left;
    std::array<Cosine, Count>& at_short = middle_left ? ends.left : ends.right;
    unrolled<Used>([&](auto i) {
      at_long[i] =
          long_edge.shape.between(long_edge.from.scalars[i], long_edge.to.scalars[i], on_long, long_excess);
      at_short[i] = short_edge.shape.between(short_edge.from.scalars[i], short_edge.to.scalars[i], on_short,
                                             short_excess);
    });
    const std::uint32_t chord =
        row_chord({long_edge.shape, on_long, long_excess}, {short_edge.shape, on_short, short_excess});
    return halve<Used>(chord, start, ends);
  }

 private:
  ARCSPAN_COLD_OUTLINE constexpr void find_parts(bool in_lower) {
    if (!long_edge.is_on_part()) long_edge.find_part(top, bottom);
    if (!short_edge.is_on_part()) {
      short_edge.find_part(in_lower ? middle : top, in_lower ? bottom : middle);
    }
    const auto product = [](const ArcVertex<Count>& a, const ArcVertex<Count>& b) {
      return 32768 - static_cast<std::int32_t>(squared_chord(a.normal, b.normal) >> 14);
    };
    products = {product(long_edge.from, short_edge.from), product(long_edge.from, short_edge.to),
                product(long_edge.to, short_edge.from), product(long_edge.to, short_edge.to)};
  }

  /// Returns the squared chord of a row between points of both parts, 28 fraction bits.
  [[nodiscard]] constexpr std::uint32_t row_chord(const detail::ArcWeights& on_long,
                                                  const detail::ArcWeights& on_short) const {
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

  /// Halves a row until it is at most 60 degrees wide, and sets the squared angle of `ends`.
  template <std::size_t Used>
  [[nodiscard]] constexpr std::int32_t halve(std::uint32_t chord, RowStart& start,
                                             RowEnds<Count>& ends) const {
    std::int32_t length = INT32_MAX;
    while (chord > kWidestArc) {
      const HalfWay half(chord);
      const RowPiece part = piece_of_row(start, 1);
      auto& replaced = part.index != 0 ? ends.left : ends.right;
      for (std::size_t i = 0; i < Used; ++i) {
        replaced[i] = Cosine::from_raw(half.of(std::int64_t{ends.left[i].raw()} + ends.right[i].raw()));
      }
      start.inside = part.inside;
      start.width = part.width >> 1;
      start.bits = part.bits;
      if (part.length < length) length = part.length;
      chord = half.chord();
    }
    ends.angle2 = Factor::from_raw(static_cast<std::int32_t>(detail::squared_angle(chord >> 12) >> 1));
    return length;
  }
};

}  // namespace arcspan
