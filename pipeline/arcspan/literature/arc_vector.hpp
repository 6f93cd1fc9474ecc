// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/recurrence_method.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

namespace detail {

/// An illumination whose scalars are the three components of the normal, so that the arcs carry the vector.
/// Colours are those of `illumination` for that vector.
template <class Illumination>
struct NormalAsScalars {
  static constexpr std::size_t kScalars = 3;
  using Scalars = std::array<Cosine, kScalars>;

  const Illumination* illumination;

  [[nodiscard]] static constexpr Scalars scalars(const Direction& n) {
    return {convert<Cosine>(n.x), convert<Cosine>(n.y), convert<Cosine>(n.z)};
  }
  [[nodiscard]] constexpr PackedRgb colour(const Scalars& s) const {
    return illumination->colour(
        illumination->scalars(Direction{convert<DirectionComponent>(s[0]), convert<DirectionComponent>(s[1]),
                                        convert<DirectionComponent>(s[2])}));
  }
};

}  // namespace detail

/// Spherical-angular shading with the vector (S0 eq. 7), for comparison. It is Recurrence, except that the
/// three components of the normal are stepped, and each pixel takes the products with L, H or V. Recurrence
/// steps the products themselves (eq. 14) and saves these multiplies.
template <class Illumination>
struct ArcVector : Recurrence<detail::NormalAsScalars<Illumination>> {
  using Components = detail::NormalAsScalars<Illumination>;
  using Base = Recurrence<Components>;
  using Lighting = Illumination;
  using typename Base::Face;
  using typename Base::Prepared;
  using typename Base::Scalars;
  using typename Base::Vertex;

  [[nodiscard]] static Vertex shade_vertex(const Lighting&, const Direction& normal) {
    return {to_normal(normal), Components::scalars(normal)};
  }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }

  template <class Frame>
  static constexpr void prepare(const Lighting&, Frame& frame, const Face& face, Prepared& prepared) {
    Base::prepare({}, frame, face, prepared);
  }

  struct Run {
    RecurrenceRun<Components> components;

    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
      return components.colour(Components{&lighting});
    }
    constexpr void next() { components.next(); }
    [[nodiscard]] constexpr std::int32_t length() const { return components.length(); }
  };
  [[nodiscard]] static constexpr PackedRgb colour_of(const Lighting& lighting, const Scalars& components) {
    return Components{&lighting}.colour(components);
  }

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if (prepared.is_wide) return draw(literature::VeryWideWalker<ArcVector, 3>(prepared.wide));
    return draw(RecurrenceWalker<Components, Run>(prepared.narrow));
  }
};

}  // namespace arcspan
