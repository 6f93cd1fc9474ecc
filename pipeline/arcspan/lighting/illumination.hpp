// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/checked.hpp>
#include <arcspan/lighting/accuracy_limits.hpp>
#include <arcspan/lighting/check_light.hpp>
#include <arcspan/lighting/directional_light.hpp>
#include <arcspan/lighting/highlight_fade.hpp>
#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/lighting/illumination_features.hpp>
#include <arcspan/lighting/material.hpp>
#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/lighting/power_table.hpp>
#include <arcspan/lighting/triangle_light.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// How the sum of several grey lights becomes a position in their ramp. All members have 15 fraction bits.
template <std::size_t Lights>
struct RampScale {
  /// The weighted sum of N·L at the end of the ramp, and its reciprocal. It depends on the material only, so
  /// that a change of the weights need not make the ramp.
  std::uint32_t range = 0;
  std::uint32_t inverse = 0;
  std::array<std::uint32_t, Lights> shares{};  ///< the lights' weights times `inverse`
};
/// For each of several coloured lights, and red, green and blue: the factors by which N·L and the highlight
/// become parts of a ChannelLight.
template <std::size_t Lights>
struct ChannelScale {
  /// For N·L: the diffuse coefficient times the light's weight, in 8-bit steps with 5 fraction bits.
  std::array<std::array<std::uint32_t, 3>, Lights> tints{};
  /// For the highlight: how many steps of a 5-6-5 pixel one 8-bit step of HighlightTable::value() becomes,
  /// with the light's weight and the channel's share of the highlight, 15 fraction bits.
  std::array<std::array<std::uint32_t, 3>, Lights> shines{};
};
/// Used for a single light, whose ramp is over N·L.
struct NoScale {};
template <std::size_t Lights, IlluminationFeatures Features>
using ScaleFor =
    std::conditional_t<Lights == 1, NoScale,
                       std::conditional_t<Features.coloured_lights, ChannelScale<Lights>, RampScale<Lights>>>;

/// The illumination of one object by `Lights` (1...4) lights: its constants, and the colour of a normal's
/// scalars. The scalars of a normal N are N·L for every light, then N·H for every light (Blinn) or N·V once
/// (Phong). They are linear on a surface because they are linear in N.
template <std::size_t Lights, Highlight Model, IlluminationFeatures Features = IlluminationFeatures{}>
class Illumination : private FadeFor<Features>,
                     private ScaleFor<Lights, Features>,
                     private CheckedState {  // empty bases take no bytes
 public:
  static_assert(Lights >= 1 && Lights <= 4);
  static constexpr std::size_t kLights = Lights;
  static constexpr Highlight kModel = Model;
  static constexpr IlluminationFeatures kFeatures = Features;
  static constexpr std::size_t kScalars = Model == Highlight::kBlinn ? 2 * Lights : Lights + 1;
  using Scalars = std::array<Cosine, kScalars>;
  /// True if the diffuse part is looked up in ramp(): a single light, or several that are grey.
  static constexpr bool kHasRamp = Lights == 1 || !Features.coloured_lights;

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
  /// all channels. A single light's are in the ramp.
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
          power += (fade()(power_(half_distance), scalars[i]) * weights_[i] + (1u << 14)) >> 15;
      });
      const PackedRgb ramp = diffuse_colour(diffuse_sum(scalars));
      return power == 0 ? ramp : ramp.plus(highlight(power));
    } else {
      const LightSums sums = light_sums(scalars);
      return packed_levels<true>({channel(0, sums), channel(1, sums), channel(2, sums)});
    }
  }

  // The functions that `Arc` calls (docs/decisions/0035-one-surface.md).

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
  /// Scalar i of a vertex as surface_colour() takes it: that of the highlight in the scale of HighlightTable,
  /// and those that are multiplied with half a unit of what the product drops, so that dropping rounds.
  [[nodiscard]] constexpr Cosine pixel_scalar(Cosine scalar, std::size_t i) const {
    constexpr Cosine kHalf = Cosine::from_raw(1 << 14);
    if (Model == Highlight::kPhong) return (i < Lights ? scalar : highlights_.scaled(scalar)) + kHalf;
    return i < Lights ? scalar : Cosine::from_raw(highlights_.scaled(scalar).raw() >> 1);
  }
  /// The colour of a pixel with these pixel_scalar().
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb surface_colour(const Scalars& scalars) const {
    if constexpr (Lights == 1) {
      const std::int32_t at = closeness(scalars, 0);
      if (at <= 0 || scalars[0].raw() <= 0) return diffuse_colour(scalars[0]);
      const PackedRgb highlight = highlights_.colour(fade()(highlights_.value(at) >> 16, scalars[0]));
      return diffuse_colour(scalars[0]).plus(highlight);
    } else if constexpr (!kHasRamp) {
      ChannelLevels levels = ambient_;
      add_coloured(scalars, levels, levels);
      return packed_levels<true>(levels);
    } else {
      const PixelLight parts = surface_light(scalars);
      return parts.highlight.lanes == 0 ? parts.diffuse : parts.diffuse.plus(parts.highlight);
    }
  }
  /// The parts of surface_colour().
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight surface_light(const Scalars& scalars) const {
    if constexpr (Lights == 1) {
      const PackedRgb diffuse = diffuse_colour(scalars[0]);
      const std::int32_t at = closeness(scalars, 0);
      if (at <= 0 || scalars[0].raw() <= 0) return {diffuse, {}};
      return {diffuse, highlights_.colour(fade()(highlights_.value(at) >> 16, scalars[0]))};
    } else if constexpr (kHasRamp) {
      std::uint32_t light = 0;      // 30 fraction bits
      std::uint32_t highlight = 0;  // in 8-bit steps, 8 fraction bits; at most four times 255
      unrolled<Lights>([&](auto i) {
        const std::int32_t of_light = scalars[i].raw() >> 15;
        if (of_light <= 0) return;
        light += static_cast<std::uint32_t>(of_light) * this->shares[i];
        const std::int32_t at = closeness(scalars, i);
        if (at > 0) highlight += (fade()(highlights_.value(at) >> 16, scalars[i]) * weights_[i]) >> 15;
      });
      const PackedRgb ramp = diffuse_colour(Cosine::from_raw(static_cast<std::int32_t>(light)));
      if (highlight == 0) return {ramp, {}};
      if (highlight < std::uint32_t{1} << 16) return {ramp, highlights_.colour(highlight)};
      return {ramp, highlights_.colour_of_sum(highlight)};
    } else {
      ChannelLevels diffuse = ambient_;
      ChannelLevels specular{};
      add_coloured(scalars, diffuse, specular);
      if ((specular[0] | specular[1] | specular[2]) == 0) return {packed_levels<true>(diffuse), {}};
      constexpr std::uint32_t kFraction = (std::uint32_t{1} << 18) - 1;
      unrolled<3>([&](auto c) { diffuse[c] += specular[c] & kFraction; });  // their sum is surface_colour()
      return {packed_levels<true>(diffuse), packed_levels<false>(specular)};
    }
  }

  /// surface_light() of several coloured lights on a 5-6-5 texel, by one product per light and channel.
  [[nodiscard]] ARCSPAN_INLINE constexpr ChannelLight channel_light(const Scalars& scalars) const
      requires(Lights > 1 && Features.coloured_lights) {
    // The sums stay below 2^31 as long as N·L of four lights is below 1.7; that of unit normals is at most 1.
    ChannelLevels sums = ambient_;
    ChannelLevels highlight{};
    add_channel_light(scalars, sums, highlight);
    const auto factor = [&sums](std::size_t channel) {
      return clamped_unsigned<10, 18>(static_cast<std::int32_t>(sums[channel] + (std::uint32_t{1} << 19)));
    };
    ChannelLight result{{factor(0), factor(1), factor(2)}, 0};
    if ((highlight[0] | highlight[1] | highlight[2]) == 0) return result;
    const auto rounded = [&highlight](std::size_t channel) {
      return static_cast<std::int32_t>(highlight[channel] + (std::uint32_t{1} << 22));
    };
    result.shine = clamped_unsigned<5, 23>(rounded(0)) << 11 | clamped_unsigned<6, 23>(rounded(1)) << 22 |
                   clamped_unsigned<5, 23>(rounded(2));
    return result;
  }

  /// The closeness of HighlightTable at a pixel with these pixel_scalar().
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t closeness(const Scalars& scalars,
                                                                std::size_t light) const {
    const std::int32_t other = scalars[highlight_index(light)].raw();
    if constexpr (Model == Highlight::kBlinn) return wrap_add(closeness_origin_[light], other);
    return wrap_add(closeness_origin_[light], wrap_mul(scalars[light].raw() >> 15, other >> 15));
  }
  /// The highlight of a single light at a closeness above 0, and its fade() by N·L.
  [[nodiscard]] constexpr PackedRgb highlight_at(std::int32_t closeness) const {
    return highlights_.colour(highlights_.value(closeness) >> 16);
  }
  [[nodiscard]] constexpr const auto& fade() const { return static_cast<const FadeFor<Features>&>(*this); }

  /// The scalar of which diffuse_colour() is the diffuse part of colour(), as long as every light i that is
  /// in `lit` (bit i) has N·L >= 0 and every other one N·L <= 0: N·L of one light, the mean of several by
  /// their weights. It is linear in the normal.
  [[nodiscard]] constexpr Cosine diffuse_scalar(const Scalars& scalars,
                                                [[maybe_unused]] std::uint32_t lit) const requires kHasRamp {
    if constexpr (Lights == 1) {
      return scalars[0];
    } else {
      Cosine sum{};
      for (std::size_t i = 0; i < Lights; ++i) {
        if ((lit >> i & 1u) != 0) sum += Cosine::from_raw(scaled_down(scalars[i].raw(), this->shares[i], 15));
      }
      return sum;
    }
  }
  /// The weighted sum of max(0, N·L), of which diffuse_colour() is the diffuse part of colour() for any
  /// normal. `scalars` begins with N·L of every light.
  template <std::size_t Count>
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine diffuse_sum(const std::array<Cosine, Count>& scalars) const
      requires(kHasRamp&& Lights > 1 && Count >= Lights) {
    std::uint32_t sum = 0;
    unrolled<Lights>([&](auto i) { sum += not_negative(scalars[i]) * this->shares[i]; });
    return Cosine::from_raw(static_cast<std::int32_t>(sum));
  }
  /// Sets `lit` to the lights that reach a triangle with these scalars at its vertices. Returns false if one
  /// of several reaches only a part of it, where diffuse_scalar() does not hold. With all N·L of one sign at
  /// the vertices, they have it everywhere.
  [[nodiscard]] constexpr bool lit_throughout(const Scalars& a, const Scalars& b, const Scalars& c,
                                              std::uint32_t& lit) const;

  /// colour() without a highlight, by the scalar of diffuse_scalar().
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb diffuse_colour(
      Cosine normal_light) const requires kHasRamp {
    return ramp_[ramp_index(normal_light)];
  }

  /// The green channel of diffuse_colour() as a linear function; for illuminations that have a ramp().
  [[nodiscard]] constexpr LinearLevel linear_level() const {
    // Light in steps has at most 16, so that a sixteenth of its ramp or more has the colour of the first
    // step.
    const bool is_gradual = diffuse_[1] == 0 || ramp_[kRampSize / 16 - 1].lanes != ramp_[0].lanes;
    return {static_cast<std::int32_t>(ambient_[1] >> 12),
            static_cast<std::int32_t>((diffuse_[1] * ramp_range()) >> 12), is_gradual};
  }
  /// The colours of diffuse_colour(), evenly spaced over 0...1: 256 of one light, 512 of two, else 1024.
  [[nodiscard]] constexpr const auto& ramp() const requires kHasRamp { return ramp_; }
  static constexpr int kRampBits = Lights == 1 ? 8 : Lights == 2 ? 9 : 10;
  static constexpr std::size_t kRampSize = std::size_t{1} << kRampBits;
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::size_t ramp_index(Cosine normal_light) {
    return static_cast<std::size_t>(
        clamped_unsigned<kRampBits, Cosine::kFraction - kRampBits>(normal_light.raw()));
  }

  /// A lower bound of the half distance (PowerTable) of the highlight of one light over all normals of a
  /// triangle. `a`, `b` and `c` are the scalars of its vertices; `headroom` is the most by which a scalar
  /// inside may exceed them. INT32_MAX if the light does not reach it.
  [[nodiscard]] constexpr std::int32_t nearest_highlight_of(std::size_t light, const Scalars& a,
                                                            const Scalars& b, const Scalars& c,
                                                            Cosine headroom) const;

  /// The index of the scalar that the highlight of a light depends on besides N·L.
  [[nodiscard]] static constexpr std::size_t highlight_index(std::size_t light) {
    return Model == Highlight::kBlinn ? Lights + light : Lights;
  }
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

  /// Several lights have a weight per channel or one for all. A single light's are in the coefficients.
  static constexpr bool kWeighsChannels = Lights > 1 && Features.coloured_lights;
  using Weights = std::conditional_t<kWeighsChannels, std::array<std::uint32_t, 3>, std::uint32_t>;

  /// The two sums of colour() over the lights per weight, 0...4 each, 15 fraction bits.
  struct LightSums {
    Weights diffuse{};
    Weights specular{};
  };

  /// `scalar` clamped to 0...1, 15 fraction bits.
  [[nodiscard]] static constexpr std::uint32_t clamped(Cosine scalar) {
    const std::int32_t raw = scalar.raw() >> 15;
    return raw <= 0 ? 0u : raw > 32768 ? 32768u : static_cast<std::uint32_t>(raw);
  }

  /// `scalar` or 0 if it is negative, 15 fraction bits. Look-ups in the ramp clamp their sum.
  [[nodiscard]] static constexpr std::uint32_t not_negative(Cosine scalar) {
    const std::int32_t raw = scalar.raw() >> 15;
    return raw < 0 ? 0u : static_cast<std::uint32_t>(raw);
  }

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
      return wrap_sub(half_one_plus_light_eye_[light], product);
    }
  }

  [[nodiscard]] constexpr LightSums light_sums(const Scalars& scalars) const {
    LightSums sums;
    unrolled<Lights>([&](auto i) {
      const std::uint32_t diffuse = clamped(scalars[i]);
      if (diffuse == 0) return;
      const std::int32_t half_distance = highlight_distance(scalars[i], scalars[highlight_index(i)], i);
      const std::uint32_t specular =
          half_distance < power_.half_reach() ? fade()(power_(half_distance), scalars[i]) : 0;
      const auto weighted = [](std::uint32_t value, std::uint32_t weight) {
        return (value * weight + (1u << 14)) >> 15;
      };
      if constexpr (Lights == 1) {
        sums = {diffuse, specular};
      } else if constexpr (!kWeighsChannels) {
        sums.diffuse += weighted(diffuse, weights_[i]);
        sums.specular += weighted(specular, weights_[i]);
      } else {
        unrolled<3>([&](auto c) { sums.diffuse[c] += weighted(diffuse, weights_[i][c]); });
        if (specular != 0)
          unrolled<3>([&](auto c) { sums.specular[c] += weighted(specular, weights_[i][c]); });
      }
    });
    return sums;
  }

  /// Channel `c` in 8-bit steps with 20 fraction bits: 5 of the coefficients and 15 of the sums. At most
  /// 255 * (1 + 4 + 4) * 2^20 < 2^32.
  [[nodiscard]] constexpr std::uint32_t channel(std::size_t c, const LightSums& sums) const {
    if constexpr (kWeighsChannels) {
      return ambient_[c] + diffuse_[c] * sums.diffuse[c] + specular_[c] * sums.specular[c];
    } else {
      return ambient_[c] + diffuse_[c] * sums.diffuse + specular_[c] * sums.specular;
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

  /// The largest of three scalars, at least 0.
  [[nodiscard]] static constexpr std::int32_t largest(Cosine a, Cosine b, Cosine c) {
    const std::int32_t two = a.raw() > b.raw() ? a.raw() : b.raw();
    const std::int32_t three = two > c.raw() ? two : c.raw();
    return three > 0 ? three : 0;
  }
  using ChannelLevels = std::array<std::uint32_t, 3>;  ///< in 8-bit steps, 20 fraction bits
  template <std::size_t Channel = 0>
  ARCSPAN_INLINE static constexpr void add_products(std::uint32_t value, const ChannelLevels& weights,
                                                    ChannelLevels& sums) {
    sums[Channel] += value * weights[Channel];
    if constexpr (Channel < 2) add_products<Channel + 1>(value, weights, sums);
  }
  /// Add the light of coloured light I and of those behind it. Recursive, and channels unrolled, because gcc
  /// keeps sums that loops or lambdas over the lights change in memory.
  template <std::size_t I = 0>
  ARCSPAN_INLINE constexpr void add_coloured(const Scalars& scalars, ChannelLevels& diffuse,
                                             ChannelLevels& specular) const {
    const std::uint32_t light = clamped(scalars[I]);
    if (light != 0) {
      const std::int32_t at = closeness(scalars, I);
      unrolled<3>([&](auto c) { diffuse[c] += diffuse_[c] * ((light * weights_[I][c]) >> 15); });
      if (at > 0) {
        const std::uint32_t most = fade()(highlights_.value(at) >> 16, scalars[I]);
        unrolled<3>(
            [&](auto c) { specular[c] += ((highlights_.channel(c, most) * weights_[I][c]) >> 15) << 12; });
      }
    }
    if constexpr (I + 1 < Lights) add_coloured<I + 1>(scalars, diffuse, specular);
  }
  template <std::size_t I = 0>
  ARCSPAN_INLINE constexpr void add_channel_light(const Scalars& scalars, ChannelLevels& diffuse,
                                                  ChannelLevels& highlight) const {
    const std::int32_t light = scalars[I].raw() >> 15;  // not clamped: the sum is
    if (light > 0) {
      add_products(static_cast<std::uint32_t>(light), this->tints[I], diffuse);
      const std::int32_t at = closeness(scalars, I);
      if (at > 0) {
        const std::uint32_t most = fade()(highlights_.value(at) >> 16, scalars[I]);
        add_products(most, this->shines[I], highlight);
      }
    }
    if constexpr (I + 1 < Lights) add_channel_light<I + 1>(scalars, diffuse, highlight);
  }
  /// The colour of these levels, saturated, after half an 8-bit step was added to each if `AddsHalf`.
  template <bool AddsHalf>
  [[nodiscard]] ARCSPAN_INLINE static constexpr PackedRgb packed_levels(const ChannelLevels& levels) {
    constexpr std::uint32_t kHalf = std::uint32_t{AddsHalf} << 19;
    const auto level = [&levels](std::size_t channel) {
      const std::uint32_t rounded = (levels[channel] + kHalf) >> 18;
      return rounded > 1023 ? 1023u : rounded;
    };
    return PackedRgb::of(level(0), level(1), level(2));
  }
  /// True if a light's highlight may reach N·L = 0 in a triangle with these scalars at its vertices. There it
  /// ends or fades, so that errors of N·L show more.
  [[nodiscard]] constexpr bool may_end(std::size_t light, const Scalars& a, const Scalars& b,
                                       const Scalars& c) const;
  /// The slope of c^n by c at a half distance, as a part of the slope at c = 1, 15 fraction bits; above 1 by
  /// up to 1/8 if n = 1.
  [[nodiscard]] constexpr std::uint32_t highlight_slope(std::int32_t half_distance) const;
  /// `highlight_height` is that of AccuracyLimits.
  constexpr void set_limits(std::uint32_t highlight_height) {
    limits_.highlight_height = highlight_height;
    limits_.set(Model, shininess_, power_);
  }
  constexpr void set_ramp_range();
  /// The weighted sum of N·L at the end of the ramp, or in full coloured light; 15 fraction bits.
  [[nodiscard]] constexpr std::uint32_t ramp_range() const {
    if constexpr (Lights > 1 && kHasRamp) return this->range;
    return static_cast<std::uint32_t>(Lights) << 15;
  }
  constexpr void make_ramp();

  /// Entry i is ambient + diffuse * ramp_range() * (i + 1/2) / size. First, so that it needs no offset.
  std::array<PackedRgb, kHasRamp ? kRampSize : 0> ramp_{};
  std::array<Direction, kScalars> axes_{};   ///< scalar i is the product of the normal and this
  std::array<std::uint32_t, 3> ambient_{};   ///< in 8-bit steps, 20 fraction bits
  std::array<std::uint32_t, 3> diffuse_{};   ///< in 8-bit steps, 5 fraction bits
  std::array<std::uint32_t, 3> specular_{};  ///< in 8-bit steps, 5 fraction bits
  std::array<Weights, Lights> weights_{};  ///< strength * colour of each of several lights, 15 fraction bits
  std::array<std::int32_t, Lights> half_one_plus_light_eye_{};  ///< (1 + L·V) / 2, 30 fraction bits
  std::array<std::int32_t, Lights> closeness_origin_{};         ///< HighlightTable
  PowerTable power_{};
  HighlightTable highlights_{};
  AccuracyLimits limits_{};
  std::uint32_t shininess_ = 1;
  std::uint32_t white_specular_ = 0;  ///< specular_[0] if all channels are equal, else 0
};

}  // namespace arcspan

#include <arcspan/lighting/illumination_bounds.hpp>
#include <arcspan/lighting/make_illumination.hpp>
