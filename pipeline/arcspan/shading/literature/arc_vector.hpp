// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/arc.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

namespace detail {

/// An illumination whose scalars are the three components of the normal, so that the arcs carry the vector.
/// Colours are those of `illumination` for that vector.
template <class Illumination>
struct NormalAsScalars {
  static constexpr std::size_t kScalars = 3;
  /// Not 1: with one light Arc carries scalars[0] alone where a triangle has no highlight.
  static constexpr std::size_t kLights = 2;
  using Scalars = std::array<Cosine, kScalars>;

  const Illumination* illumination;

  [[nodiscard]] static constexpr Scalars scalars(const Direction& n) {
    return {convert<Cosine>(n.x), convert<Cosine>(n.y), convert<Cosine>(n.z)};
  }
  [[nodiscard]] ARCSPAN_INLINE_IF_MANY_REGISTERS constexpr PackedRgb colour(const Scalars& s) const {
    return illumination->colour(
        illumination->scalars(Direction{convert<DirectionComponent>(s[0]), convert<DirectionComponent>(s[1]),
                                        convert<DirectionComponent>(s[2])}));
  }
};

}  // namespace detail

/// Spherical-angular shading with the vector (S0 eq. 7), for comparison. The arcs are those of Arc, but they
/// carry the three components of the normal, each by the recurrence, and each pixel takes the products with
/// L, H or V. Arc carries the products themselves (eq. 14) and saves these multiplies.
template <class Illumination>
struct ArcVector {
  using Components = detail::NormalAsScalars<Illumination>;
  using Base = Arc<Components>;
  using Lighting = Illumination;
  using Face = typename Base::Face;
  using Vertex = typename Base::Vertex;
  struct Prepared {
    ArcTriangle<3> arcs;
  };
  static constexpr bool kNeedsFaceNormal = false;
  static constexpr std::uint32_t kWidestChord = Base::kWidestChord;

  [[nodiscard]] static Vertex shade_vertex(const Lighting&, const Direction& normal) {
    return {to_normal(normal), Components::scalars(normal)};
  }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static constexpr Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    return Base::between(a, b, t);
  }
  [[nodiscard]] static constexpr bool too_wide(const Vertex& a, const Vertex& b) {
    return Base::too_wide(a, b);
  }
  template <class Frame>
  [[nodiscard]] static constexpr TriangleChords chords_of(const Frame& frame) {
    return Base::chords_of(frame);
  }

  static constexpr void prepare(const Lighting&, TriangleFrame<ArcVector>& frame, const Face&,
                                Prepared& prepared) {
    prepare_arcs(frame, prepared.arcs);
  }

  struct Run {
    ArcRun<Components> components;

    [[nodiscard]] ARCSPAN_INLINE_IF_MANY_REGISTERS constexpr PackedRgb colour(
        const Lighting& lighting) const {
      return components.colour(Components{&lighting});
    }
    constexpr void next() { components.next(); }
  };

  class Walker {
   public:
    using Run = ArcVector::Run;
    static constexpr std::int32_t kLongestRun = ArcWalker<Components>::kLongestRun;
    static constexpr bool kOutlined = true;
    constexpr explicit Walker(Prepared& prepared) : arcs_(prepared.arcs) {}
    [[nodiscard]] constexpr Run row(const RowStart& start) const { return {arcs_.row(start)}; }
    constexpr void next_row() { arcs_.next_row(); }
    constexpr void enter_lower() { arcs_.enter_lower(); }

   private:
    ArcWalker<Components> arcs_;
  };

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return draw(Walker(prepared));
  }
};

}  // namespace arcspan
