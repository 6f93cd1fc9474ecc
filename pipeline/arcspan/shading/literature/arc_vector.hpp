// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/arc.hpp>

namespace arcspan {

namespace detail {

/// An illumination whose scalars are the three components of the normal itself: what the arcs carry when the
/// vector is wanted. `lit` makes colours of the direction.
template <class Illumination>
struct NormalAsScalars {
  static constexpr std::size_t kScalars = 3;
  static constexpr std::size_t kLights = 2;  ///< not one: there is no scalar that could do without the others
  using Scalars = std::array<Cosine, kScalars>;

  const Illumination* lit;

  [[nodiscard]] static constexpr Scalars scalars(const Direction& n) {
    return {convert<Cosine>(n.x), convert<Cosine>(n.y), convert<Cosine>(n.z)};
  }
  [[nodiscard]] constexpr PackedRgb colour(const Scalars& s) const {
    return lit->colour(
        lit->scalars(Direction{convert<DirectionComponent>(s[0]), convert<DirectionComponent>(s[1]),
                               convert<DirectionComponent>(s[2])}));
  }
};

}  // namespace detail

/// Spherical-angular shading with the vector (S0 eq. 7), for comparison: the three components of the normal
/// run along the arcs, each by the recurrence, and a pixel takes the products with L, H or V. The arcs are
/// those of Arc; the vector is what Arc's scalars (eq. 14) save.
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

    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
      return components.colour(Components{&lighting});
    }
    constexpr void next() { components.next(); }
  };

  class Walker {
   public:
    using Run = ArcVector::Run;
    static constexpr std::int32_t kLongestRun = ArcWalker<Components>::kLongestRun;
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
