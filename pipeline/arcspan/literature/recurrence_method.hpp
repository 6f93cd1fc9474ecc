// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/arc_vertex.hpp>
#include <arcspan/literature/recurrence_walker.hpp>
#include <arcspan/literature/wide_rows.hpp>
#include <arcspan/status.hpp>

#include <array>
#include <cstddef>

namespace arcspan {

/// Spherical-angular shading with scalars as S0 prints it (eq. 14), for comparison: the products of the
/// normal with L, H or V follow great circles down the edges and along the rows of every triangle with
/// normals up to 60 degrees apart, however close they are. The recurrence steps each of them by one multiply,
/// one shift and subtractions per row and per pixel (RecurrenceScalar); no triangle is a quadratic surface.
/// Arcs up to 60 degrees are within 2^-8 of bilinear SLERP, those up to 30 degrees within 1.4e-4. Wider
/// triangles are drawn in pieces of rows (WideWalker).
template <class Illumination>
struct Recurrence : literature::ArcMethod<Illumination, Illumination::kScalars> {
  static constexpr std::size_t kScalars = Illumination::kScalars;
  using Base = literature::ArcMethod<Illumination, kScalars>;
  using typename Base::Face;
  using typename Base::Lighting;
  using typename Base::Vertex;
  using Scalars = std::array<Cosine, kScalars>;
  using Prepared = literature::NarrowOrWide<RecurrenceTriangle<kScalars>, kScalars>;

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return {to_normal(normal), lighting.scalars(normal)};
  }
  [[nodiscard]] static constexpr auto colour_of(const Lighting& lighting, const Scalars& scalars) {
    return lighting.colour(scalars);
  }
  template <class Frame>
  static constexpr void prepare(const Lighting&, const Frame& unmeasured, const Face&, Prepared& prepared) {
    literature::MeasuredFrame<Frame> frame(unmeasured);
    if (!prepared.prepare_if_wide(frame)) prepare_recurrence(frame, prepared.narrow);
  }
  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if (prepared.is_wide) return draw(literature::VeryWideWalker<Recurrence, kScalars>(prepared.wide));
    return draw(RecurrenceWalker<Illumination>(prepared.narrow));
  }
};

}  // namespace arcspan
