// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/checked.hpp>
#include <arcspan/lighting/accuracy_limits.hpp>
#include <arcspan/lighting/check_light.hpp>
#include <arcspan/lighting/directional_light.hpp>
#include <arcspan/lighting/material.hpp>
#include <arcspan/lighting/power_table.hpp>
#include <arcspan/lighting/surface_light.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// (1 + L·V) / 2 of each light, 30 fraction bits, for highlights by R·V.
template <std::size_t Lights>
struct PhongPeaks {
  std::array<std::int32_t, Lights> half_one_plus_light_eye{};
};
/// Used for highlights by N·H.
struct NoPeaks {};

/// The illumination of one object by `Lights` (1...4) lights: its constants, and the colour of a normal by
/// its scalars. Its base colours pixels, by scalars that are interpolated.
template <std::size_t Lights, Highlight Model, IlluminationFeatures Features = IlluminationFeatures{}>
class Illumination : public SurfaceLight<Lights, Model, Features>,
                     private std::conditional_t<Model == Highlight::kPhong, PhongPeaks<Lights>, NoPeaks>,
                     private CheckedState {
  using Base = SurfaceLight<Lights, Model, Features>;

 public:
  using Base::diffuse_colour, Base::diffuse_scalar, Base::diffuse_sum, Base::fade, Base::highlight_index;
  using Base::kHasRamp, Base::kRampBits, Base::kRampSize, Base::kScalars;
  using typename Base::Scalars;

  constexpr Illumination() = default;

  /// Makes the illumination of lights and an eye, with `to_eye` the unit vector to the eye in object space.
  /// Returns kInvalidArgument, and does not change `illumination`, if a coefficient, a strength or a colour
  /// is outside 0...1 or the shininess outside 1...256; kUnsupported if `Features` lacks what they ask for.
  static constexpr Status make(const Material& material, const std::array<DirectionalLight, Lights>& lights,
                               const Direction& to_eye, Illumination& illumination);

  /// make() as a constant, which can lie in flash. Arguments that make() rejects do not compile.
  [[nodiscard]] static consteval Illumination of(const Material& material,
                                                 const std::array<DirectionalLight, Lights>& lights,
                                                 const Direction& to_eye) {
    Illumination illumination;
    if (ok(make(material, lights, to_eye, illumination))) return illumination;
    detail::refuse_material(material, Features);
    for (const DirectionalLight& light : lights) detail::refuse_light(light.strength, light.colour);
    detail::refused::features_lack_coloured_lights();
    return illumination;
  }

  /// Changes only the directions that make() was given, in object space: unit vectors to the lights and to
  /// the eye. Enough for an object that turns, or whose camera does, because everything else depends on the
  /// material and on the colours of the lights.
  constexpr void set_directions(const std::array<Direction, Lights>& to_lights, const Direction& to_eye);

  /// Changes only the strengths and colours of several lights, 0...1. Without coloured_lights red counts for
  /// all channels. A single light's are in the coefficients, which only make() sets.
  constexpr void set_strengths(const std::array<DirectionalLight, Lights>& lights) requires(Lights > 1);

  /// Sets by how much more `Arc` may be off than without tolerance (docs/accuracy.md), in 8-bit steps,
  /// 0...64; 0 after make(). The larger, the more triangles it draws by cheaper orders. Returns
  /// kInvalidArgument, and changes nothing, if `steps` is out of range.
  constexpr Status set_tolerance(std::int32_t steps) {
    if (steps < 0 || steps > 64) return Status::kInvalidArgument;
    limits_.tolerance = steps;
    limits_.set(Model, shininess_, power_);
    return Status::kOk;
  }
  [[nodiscard]] constexpr std::int32_t tolerance() const { return limits_.tolerance; }
  /// Light in 2...16 equal `steps`, and hard highlights for `Arc`, until make() (lighting/toon.hpp). Returns
  /// kInvalidArgument, and changes nothing, if `steps` is out of range.
  constexpr Status set_toon(std::int32_t steps) requires(Lights == 1 || !Features.coloured_lights);

  /// The scalars of a unit normal.
  [[nodiscard]] constexpr Scalars scalars(const Direction& normal) const {
    Scalars result;
    for (std::size_t i = 0; i < kScalars; ++i) result[i] = dot(normal, axes_[i]);
    return result;
  }

  /// The colour of a normal with these scalars, each channel rounded and clamped:
  ///
  ///   ambient + diffuse * sum(weight * max(0, N·L)) + specular * sum(weight * fade * c^n)
  ///
  /// with weight = strength * colour of a light, c the cosine of `Highlight` and n the exponent. The second
  /// sum is over lights with N·L > 0. With a ramp() the diffuse part comes from there.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Scalars& scalars) const {
    if constexpr (Lights == 1) {
      const PackedRgb ramp = diffuse_colour(scalars[0]);
      const std::int32_t half_distance = highlight_distance(scalars[0], scalars[1], 0);
      if (half_distance >= power_.half_reach() || scalars[0].raw() <= 0) return ramp;
      return ramp.plus(highlight(fade()(power_(half_distance), scalars[0])));
    } else if constexpr (kHasRamp) {
      std::uint32_t power = 0;  // of all highlights, weighted; 15 fraction bits
      unrolled<Lights>([&](auto i) {
        if (not_negative(scalars[i]) == 0) return;
        const std::int32_t half_distance = highlight_distance(scalars[i], scalars[highlight_index(i)], i);
        if (half_distance < power_.half_reach())
          power += weighted(fade()(power_(half_distance), scalars[i]), this->weights[i]);
      });
      const PackedRgb ramp = diffuse_colour(diffuse_sum(scalars));
      return power == 0 ? ramp : ramp.plus(highlight(power));
    } else {
      const LightSums sums = light_sums(scalars);
      return packed_levels({channel(0, sums), channel(1, sums), channel(2, sums)});
    }
  }

  /// True if no light reaches a triangle with these scalars at its vertices: with all N·L of one sign there,
  /// they have it everywhere. False where dark pixels have no path of their own.
  [[nodiscard]] constexpr bool is_dark(const Scalars& a, const Scalars& b, const Scalars& c) const {
    for (std::size_t i = 0; i < Lights; ++i) {
      if (!kHasRamp || a[i].raw() > 0 || b[i].raw() > 0 || c[i].raw() > 0) return false;
    }
    return true;
  }
  /// Finds whether diffuse light and highlights reach a triangle, whether planes are within the tolerance,
  /// and up to which chord quadratic surfaces are. `widest`: the widest squared chord between its normals, 28
  /// fraction bits, at most kWidestBounded.
  [[nodiscard]] constexpr TriangleLight light_over(const Scalars& a, const Scalars& b, const Scalars& c,
                                                   std::uint32_t widest) const;
  /// Sets `lit` to the lights that reach a triangle with these scalars at its vertices. Returns false if one
  /// of several reaches only a part of it, where diffuse_scalar() does not hold. With all N·L of one sign at
  /// the vertices, they have it everywhere.
  [[nodiscard]] constexpr bool lit_throughout(const Scalars& a, const Scalars& b, const Scalars& c,
                                              std::uint32_t& lit) const;

  /// A lower bound of the half distance (PowerTable) of the highlight of one light over all normals of a
  /// triangle. `a`, `b` and `c` are the scalars of its vertices; `headroom` is the most by which a scalar
  /// inside may exceed them. INT32_MAX if the light does not reach it.
  [[nodiscard]] constexpr std::int32_t nearest_highlight_of(std::size_t light, const Scalars& a,
                                                            const Scalars& b, const Scalars& c,
                                                            Cosine headroom) const;

  /// The squared chord up to which a triangle of any shape with a highlight may be quadratic
  /// (is_accurate_quadratic()).
  [[nodiscard]] constexpr std::uint32_t widest_patch() const { return limits_.widest_patch; }

  /// The change of the largest diffuse channel from no light to all, in 8-bit steps with 5 fraction bits.
  [[nodiscard]] constexpr std::uint32_t most_light() const { return limits_.light_height; }
  /// The largest diffuse coefficient of a channel, in 8-bit steps with 5 fraction bits.
  [[nodiscard]] constexpr std::uint32_t most_diffuse() const { return largest_channel(diffuse_); }
  [[nodiscard]] constexpr const PowerTable& power() const { return power_; }
  [[nodiscard]] constexpr std::uint32_t shininess() const { return shininess_; }
  /// False for an illumination that make() has not set, in builds with checks only (ARCSPAN_CHECKED).
  [[nodiscard]] constexpr bool is_made() const { return !kIsChecked || CheckedState::get() != 0; }
  /// The colour of a normal with these scalars in 256ths of an 8-bit step. Without the ramp, for any number
  /// of lights.
  [[nodiscard]] constexpr DeepColour deep_colour(const Scalars& scalars) const {
    const LightSums sums = light_sums(scalars);
    const auto deep_level = [&](std::size_t c) {
      const std::uint32_t rounded = (channel(c, sums) + (1u << 11)) >> 12;
      return static_cast<std::int32_t>(rounded > 65280 ? 65280 : rounded);
    };
    return {deep_level(0), deep_level(1), deep_level(2)};
  }

 private:
  friend struct HighlightsOver;  // literature/highlights_over.hpp

  using Base::ambient_, Base::closeness_origin_, Base::diffuse_, Base::highlights_, Base::ramp_;
  using Base::clamped, Base::not_negative, Base::packed_levels, Base::ramp_range;

  /// The two sums of colour() over the lights per weight, 0...4 each, 15 fraction bits.
  struct LightSums {
    typename Base::Scale::LightWeight diffuse{};
    typename Base::Scale::LightWeight specular{};
  };

  /// (1 - c) / 2 of the highlight's cosine c, 30 fraction bits. `other` is N·H of this light (Blinn) or N·V
  /// (Phong). Phong's c is R·V = 2 (N·L)(N·V) - L·V, so that the result is (1 + L·V) / 2 - (N·L)(N·V).
  [[nodiscard]] constexpr std::int32_t highlight_distance(Cosine normal_light, Cosine other,
                                                          std::size_t light) const {
    if constexpr (Model == Highlight::kBlinn) {
      return (std::int32_t{1} << (Cosine::kFraction - 1)) - (other.raw() >> 1);
    } else {
      // Rounded to 15 bits; truncation would change a highlight of n = 64 by up to two 8-bit steps.
      const std::int32_t product =
          wrap_mul(round_shift(normal_light.raw(), 15), round_shift(other.raw(), 15));
      return wrap_sub(this->half_one_plus_light_eye[light], product);
    }
  }

  /// value * weight, rounded; the weight has 15 fraction bits.
  [[nodiscard]] static constexpr std::uint32_t weighted(std::uint32_t value, std::uint32_t weight) {
    return (value * weight + (1u << 14)) >> 15;
  }

  [[nodiscard]] constexpr LightSums light_sums(const Scalars& scalars) const {
    LightSums sums;
    unrolled<Lights>([&](auto i) {
      const std::uint32_t diffuse = clamped(scalars[i]);
      if (diffuse == 0) return;
      const std::int32_t half_distance = highlight_distance(scalars[i], scalars[highlight_index(i)], i);
      const std::uint32_t specular =
          half_distance < power_.half_reach() ? fade()(power_(half_distance), scalars[i]) : 0;
      if constexpr (Lights == 1) {
        sums = {diffuse, specular};
      } else if constexpr (kHasRamp) {
        sums.diffuse += weighted(diffuse, this->weights[i]);
        sums.specular += weighted(specular, this->weights[i]);
      } else {
        unrolled<3>([&](auto c) { sums.diffuse[c] += weighted(diffuse, this->weights[i][c]); });
        if (specular != 0)
          unrolled<3>([&](auto c) { sums.specular[c] += weighted(specular, this->weights[i][c]); });
      }
    });
    return sums;
  }

  /// Channel `c` in 8-bit steps with 20 fraction bits: 5 of the coefficients and 15 of the sums. At most
  /// 255 * (1 + 4 + 4) * 2^20 < 2^32.
  [[nodiscard]] constexpr std::uint32_t channel(std::size_t c, const LightSums& sums) const {
    if constexpr (kHasRamp) {
      return ambient_[c] + diffuse_[c] * sums.diffuse + specular_[c] * sums.specular;
    } else {
      return ambient_[c] + diffuse_[c] * sums.diffuse[c] + specular_[c] * sums.specular[c];
    }
  }

  /// A highlight, each channel clamped; `power` is c^n with 15 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb highlight(std::uint32_t power) const {
    const auto share = [power](std::uint32_t coefficient) {
      const std::uint32_t level = (coefficient * power) >> 18;
      return Lights == 1 || level < 1023 ? level : 1023u;  // several highlights may coincide
    };
    if (white_specular_ != 0) return PackedRgb::grey(share(white_specular_));
    return PackedRgb::of(share(specular_[0]), share(specular_[1]), share(specular_[2]));
  }

  /// True if a light's highlight may reach N·L = 0 in a triangle with these scalars at its vertices. There it
  /// ends or fades, so that errors of N·L show more.
  [[nodiscard]] constexpr bool may_end(std::size_t light, const Scalars& a, const Scalars& b,
                                       const Scalars& c) const;
  /// `highlight_height` is that of AccuracyLimits.
  constexpr void set_limits(std::uint32_t highlight_height) {
    limits_.highlight_height = highlight_height;
    limits_.widest_patch = detail::widest_patch(Model, shininess_, highlight_height);
    limits_.set(Model, shininess_, power_);
  }
  /// Sets the ramp, and with several lights the range of its scale.
  constexpr void make_ramp();

  std::array<Direction, kScalars> axes_{};   ///< scalar i is the product of the normal and this
  std::array<std::uint32_t, 3> specular_{};  ///< in 8-bit steps, 5 fraction bits
  AccuracyLimits limits_{};
  std::uint32_t shininess_ = 1;
  std::uint32_t white_specular_ = 0;  ///< specular_[0] if all channels are equal, else 0
  PowerTable power_{};
};

}  // namespace arcspan

#include <arcspan/lighting/illumination_bounds.hpp>
#include <arcspan/lighting/make_illumination.hpp>
