// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace arcspan::tools {

/// An illumination whose highlight and number of lights are known at run time only. It offers the scalars of
/// a normal and their colour, which is all that flat, Gouraud and the methods of shading/literature ask of an
/// illumination, so one instantiation of such a method serves every illumination. Scalars that the wrapped
/// one lacks are zero.
class AnyIllumination {
 public:
  static constexpr std::size_t kScalars = 8;  ///< of four lights with Blinn's highlight, the most there are
  using Scalars = std::array<Cosine, kScalars>;

  /// `wrapped` must live as long as this.
  template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
  explicit AnyIllumination(const Illumination<Lights, Model, Features>& wrapped)
      : wrapped_(&wrapped),
        scalars_(&scalars_of<Illumination<Lights, Model, Features>>),
        colour_(&colour_of<Illumination<Lights, Model, Features>>),
        deep_colour_(&deep_colour_of<Illumination<Lights, Model, Features>>) {}

  [[nodiscard]] Scalars scalars(const Direction& normal) const { return scalars_(wrapped_, normal); }
  [[nodiscard]] PackedRgb colour(const Scalars& scalars) const { return colour_(wrapped_, scalars); }
  [[nodiscard]] DeepColour deep_colour(const Scalars& scalars) const {
    return deep_colour_(wrapped_, scalars);
  }

 private:
  template <class Wrapped>
  static Scalars scalars_of(const void* wrapped, const Direction& normal) {
    const typename Wrapped::Scalars few = static_cast<const Wrapped*>(wrapped)->scalars(normal);
    Scalars all{};
    std::copy(few.begin(), few.end(), all.begin());
    return all;
  }
  template <class Wrapped>
  static typename Wrapped::Scalars of_wrapped(const Scalars& all) {
    typename Wrapped::Scalars few;
    std::copy_n(all.begin(), few.size(), few.begin());
    return few;
  }
  template <class Wrapped>
  static PackedRgb colour_of(const void* wrapped, const Scalars& all) {
    return static_cast<const Wrapped*>(wrapped)->colour(of_wrapped<Wrapped>(all));
  }
  template <class Wrapped>
  static DeepColour deep_colour_of(const void* wrapped, const Scalars& all) {
    return static_cast<const Wrapped*>(wrapped)->deep_colour(of_wrapped<Wrapped>(all));
  }

  const void* wrapped_;
  Scalars (*scalars_)(const void*, const Direction&);
  PackedRgb (*colour_)(const void*, const Scalars&);
  DeepColour (*deep_colour_)(const void*, const Scalars&);
};

}  // namespace arcspan::tools
