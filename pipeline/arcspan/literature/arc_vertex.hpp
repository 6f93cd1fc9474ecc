// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/arc_shape.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/root.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/surface/chords.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan::literature {

/// A normal and scalars that are linear in it, as a method interpolates them along great circles.
template <std::size_t Count>
struct ArcVertex {
  Normal normal;
  std::array<Cosine, Count> scalars;
};

/// The factor 1 / (2 cos(psi/2)) by which the sum of an arc's two ends becomes the value half-way (dichotomy,
/// S3): 1 / sqrt(2 + z), z = 2 a·b = 2 - s, where s is the squared chord.
class HalfWay {
 public:
  /// `chord` has 28 fraction bits, 0...4. Opposite normals have nothing half-way; they give 0, which is dark.
  constexpr explicit HalfWay(std::uint32_t chord)
      : square_(Factor::of(4.0).raw() - static_cast<std::int32_t>((chord + (1u << 12)) >> 13)),
        root_(reciprocal_root(static_cast<std::uint32_t>(square_))) {
    if (square_ <= 64) root_.mantissa = 0;
  }

  /// Returns the value half-way between two values with the sum `sum`, in the format of the sum, rounded to
  /// nearest.
  [[nodiscard]] constexpr std::int32_t of(std::int64_t sum) const {
    // 1/sqrt(value) = 2^7.5 / sqrt(raw) with 15 fraction bits, and 46341 = 2^15.5.
    const std::int64_t product = ((sum * root_.mantissa) >> 8) * 46341;
    return static_cast<std::int32_t>((product + (std::int64_t{1} << (root_.exponent - 1))) >> root_.exponent);
  }

  /// Returns the squared chord of half the arc, 2 - sqrt(4 - s); 28 fraction bits.
  [[nodiscard]] constexpr std::uint32_t chord() const {
    return (std::uint32_t{2} << 28) - (static_cast<std::uint32_t>(of(square_)) << 13);
  }

 private:
  std::int32_t square_;  ///< 4 - s = |a + b|^2, 15 fraction bits
  ReciprocalRoot root_;
};

/// Returns the vertex half-way along an arc. It does not depend on the order of a and b.
template <std::size_t Count>
[[nodiscard]] constexpr ArcVertex<Count> half_way(const ArcVertex<Count>& a, const ArcVertex<Count>& b) {
  const HalfWay half(squared_chord(a.normal, b.normal));
  const auto component = [&half](NormalComponent p, NormalComponent q) {
    return NormalComponent::from_raw(static_cast<std::int16_t>(half.of(std::int64_t{p.raw()} + q.raw())));
  };
  ArcVertex<Count> middle;
  middle.normal = {component(a.normal.x, b.normal.x), component(a.normal.y, b.normal.y),
                   component(a.normal.z, b.normal.z)};
  for (std::size_t i = 0; i < Count; ++i) {
    middle.scalars[i] = Cosine::from_raw(half.of(std::int64_t{a.scalars[i].raw()} + b.scalars[i].raw()));
  }
  return middle;
}

/// Returns the vertex at the fraction t, 0...1, of the arc from a to b (S0 eq. 2). Arcs of more than 60
/// degrees are halved up to twice first.
template <std::size_t Count>
[[nodiscard]] ARCSPAN_OUTLINE constexpr ArcVertex<Count> on_arc(const ArcVertex<Count>& a,
                                                                const ArcVertex<Count>& b, Factor t) {
  ArcVertex<Count> from = a;
  ArcVertex<Count> to = b;
  for (int i = 0; i < 2 && squared_chord(from.normal, to.normal) > kWidestArc; ++i) {
    const bool is_first = t < Factor::of(0.5);
    (is_first ? to : from) = half_way(from, to);
    t = is_first ? t + t : t + t - Factor::of(1.0);
  }
  const ArcShape shape(squared_chord(from.normal, to.normal));
  const std::int32_t excess = shape.excess(t);
  const auto between = [&](Cosine p, Cosine q) { return shape.between(p, q, t, excess); };
  const auto component = [&](NormalComponent p, NormalComponent q) {
    constexpr int kUp = Cosine::kFraction - NormalComponent::kFraction;
    const auto widened = [](NormalComponent v) { return Cosine::from_raw(wrap_shl(v.raw(), kUp)); };
    return convert<NormalComponent>(between(widened(p), widened(q)));
  };
  ArcVertex<Count> point;
  point.normal = {component(from.normal.x, to.normal.x), component(from.normal.y, to.normal.y),
                  component(from.normal.z, to.normal.z)};
  for (std::size_t i = 0; i < Count; ++i) point.scalars[i] = between(from.scalars[i], to.scalars[i]);
  return point;
}

/// A TriangleFrame whose vertices are ArcVertex, with the squared chords between its normals.
template <class Frame>
struct MeasuredFrame : Frame {
  constexpr explicit MeasuredFrame(const Frame& frame) : Frame(frame) {
    const Normal& a = frame.top->shade.normal;
    const Normal& b = frame.middle->shade.normal;
    const Normal& c = frame.bottom->shade.normal;
    chords = {squared_chord(a, b), squared_chord(a, c), squared_chord(b, c)};
  }
  NormalChords chords;
};

/// The common part of the methods whose vertices, of `Count` scalars, are interpolated along great circles.
template <class Illumination, std::size_t Count>
struct ArcMethod {
  using Lighting = Illumination;
  struct Face {};
  using Vertex = ArcVertex<Count>;
  static constexpr bool kNeedsFaceNormal = false;

  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  /// Returns the vertex at the fraction t, 0...1, of the arc from a to b.
  [[nodiscard]] static constexpr Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    return on_arc(a, b, t);
  }
};

}  // namespace arcspan::literature
