// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/dichotomy.hpp>
#include <arcspan/literature/phong_segment.hpp>

#include <array>

/// The methods that S3 gives figures for and that the command does not offer: `entry(name, Class)`.
#define ARCSPAN_FOR_EACH_MEASURED_VARIANT(entry)                                                 \
  entry("phong-diffuse", PhongDiffuse) entry("phong-reciprocal-diffuse", PhongReciprocalDiffuse) \
      entry("phong-segment-diffuse", PhongSegmentDiffuse)                                        \
          entry("phong-reciprocal-segment-diffuse", PhongReciprocalSegmentDiffuse)               \
              entry("dichotomy-root-diffuse", DichotomyRootDiffuse)                              \
                  entry("dichotomy-printed-linear-diffuse", DichotomyPrintedDiffuse)

namespace arcspan {

/// An illumination of one light without its highlight. N·L is its only scalar: S3's figures are for the
/// diffuse part.
template <class Illumination>
struct Diffuse : Illumination {
  static constexpr std::size_t kScalars = 1;
  using Scalars = std::array<Cosine, 1>;

  Diffuse(const Illumination& lit) : Illumination(lit) {
    constexpr auto kOne = DirectionComponent::from_raw(1 << 15);
    const auto component = [&lit](const Direction& axis) {
      return convert<DirectionComponent>(lit.scalars(axis)[0]);
    };
    towards = {component({kOne, {}, {}}), component({{}, kOne, {}}), component({{}, {}, kOne})};
  }
  [[nodiscard]] Scalars scalars(const Direction& normal) const { return {dot(normal, towards)}; }
  [[nodiscard]] PackedRgb colour(const Scalars& scalars) const { return this->diffuse_colour(scalars[0]); }

  Direction towards{};
};

template <class Illumination>
using PhongReciprocalSegment = NormalSegments<Illumination, detail::UnitByReciprocalRoot>;
template <class Illumination>
using PhongDiffuse = Phong<Diffuse<Illumination>>;
template <class Illumination>
using PhongReciprocalDiffuse = PhongReciprocal<Diffuse<Illumination>>;
template <class Illumination>
using PhongSegmentDiffuse = PhongSegment<Diffuse<Illumination>>;
template <class Illumination>
using PhongReciprocalSegmentDiffuse = PhongReciprocalSegment<Diffuse<Illumination>>;
template <class Illumination>
using DichotomyRootDiffuse = DichotomyRoot<Diffuse<Illumination>>;
template <class Illumination>
using DichotomyPrintedDiffuse = DichotomyPrintedLinear<Diffuse<Illumination>>;

}  // namespace arcspan
