// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_fade.hpp>
#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/lighting/illumination_features.hpp>
#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/lighting/triangle_light.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// The weights of several grey lights, and what makes positions in their ramp; all with 15 fraction bits.
template <std::size_t Lights>
struct RampScale {
  using LightWeight = std::uint32_t;
  /// The sum of weight * N·L at the end of the ramp, and its reciprocal. Both follow from the material alone,
  /// so that other weights need no other ramp.
  std::uint32_t range = 0;
  std::uint32_t inverse = 0;
  std::array<LightWeight, Lights> weights{};   ///< strength * colour
  std::array<std::uint32_t, Lights> shares{};  ///< weights times `inverse`
};
/// The weights of several coloured lights, and what makes parts of a ChannelLight of N·L and the highlight.
template <std::size_t Lights>
struct ChannelScale {
  using LightWeight = std::array<std::uint32_t, 3>;
  std::array<LightWeight, Lights> weights{};  ///< strength * colour, 15 fraction bits
  /// For N·L: the diffuse coefficient times the weight, in 8-bit steps with 5 fraction bits.
  std::array<LightWeight, Lights> tints{};
  /// For HighlightTable::value(): the steps of a 5-6-5 pixel that one 8-bit step becomes, with the weight and
  /// the channel's share of the highlight; 15 fraction bits.
  std::array<LightWeight, Lights> shines{};
};
/// Used for a single light: its weight is in the coefficients, and its ramp is over N·L.
struct NoScale {
  using LightWeight = std::uint32_t;
};
template <std::size_t Lights, IlluminationFeatures Features>
using ScaleFor =
    std::conditional_t<Lights == 1, NoScale,
                       std::conditional_t<Features.coloured_lights, ChannelScale<Lights>, RampScale<Lights>>>;

/// The light of a pixel: what `Arc` takes of an Illumination per pixel (docs/decisions/0035-one-surface.md).
template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
class SurfaceLight : protected FadeFor<Features>,
                     protected ScaleFor<Lights, Features> {  // empty bases take no bytes
 public:
  static_assert(Lights >= 1 && Lights <= 4);
  static constexpr std::size_t kLights = Lights;
  static constexpr Highlight kModel = Model;
  static constexpr IlluminationFeatures kFeatures = Features;
  static constexpr std::size_t kScalars = Model == Highlight::kBlinn ? 2 * Lights : Lights + 1;
  /// N·L for every light, then N·H for every light (Blinn) or N·V once (Phong). They are linear in N.
  using Scalars = std::array<Cosine, kScalars>;
  /// True if the diffuse part is looked up in ramp(): a single light, or several that are grey.
  static constexpr bool kHasRamp = Lights == 1 || !Features.coloured_lights;

  /// The index of the scalar that the highlight of a light depends on besides N·L.
  [[nodiscard]] static constexpr std::size_t highlight_index(std::size_t light) {
    return Model == Highlight::kBlinn ? Lights + light : Lights;
  }

  /// Scalar i of a vertex as the functions of pixels take it: N·V and N·H in the scale of HighlightTable, N·H
  /// halved. N·L and N·V are multiplied for R·V; half of the last bit that products take is added to both, so
  /// that dropping the others rounds.
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
      const PackedRgb highlight = highlights_.colour(faded_highlight(at, scalars[0]));
      return diffuse_colour(scalars[0]).plus(highlight);
    } else if constexpr (!kHasRamp) {
      ChannelLevels levels = ambient_;
      add_coloured(scalars, levels, levels);
      return packed_levels(levels);
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
      return {diffuse, highlights_.colour(faded_highlight(at, scalars[0]))};
    } else if constexpr (kHasRamp) {
      std::uint32_t light = 0;      // 30 fraction bits
      std::uint32_t highlight = 0;  // in 8-bit steps, 8 fraction bits; at most four times 255
      unrolled<Lights>([&](auto i) {
        const std::int32_t of_light = scalars[i].raw() >> 15;
        if (of_light <= 0) return;
        light += static_cast<std::uint32_t>(of_light) * this->shares[i];
        const std::int32_t at = closeness(scalars, i);
        if (at > 0) highlight += (faded_highlight(at, scalars[i]) * this->weights[i]) >> 15;
      });
      const PackedRgb ramp = diffuse_colour(Cosine::from_raw(static_cast<std::int32_t>(light)));
      if (highlight == 0) return {ramp, {}};
      if (highlight < std::uint32_t{1} << 16) return {ramp, highlights_.colour(highlight)};
      return {ramp, highlights_.colour_of_sum(highlight)};
    } else {
      ChannelLevels diffuse = ambient_;
      ChannelLevels specular{};
      add_coloured(scalars, diffuse, specular);
      if ((specular[0] | specular[1] | specular[2]) == 0) return {packed_levels(diffuse), {}};
      // Both add up to surface_colour(), because what packing drops of the highlight goes to the diffuse
      // part.
      unrolled<3>([&](auto c) { diffuse[c] += specular[c] & ((std::uint32_t{1} << 18) - 1); });
      return {packed_levels(diffuse), packed_levels(specular, 0)};
    }
  }
  /// surface_light() of several coloured lights on a 5-6-5 texel, by one product per light and channel.
  [[nodiscard]] ARCSPAN_INLINE constexpr ChannelLight channel_light(const Scalars& scalars) const
      requires(Lights > 1 && Features.coloured_lights) {
    // Sums stay below 2^31: those of factors while N·L of each of four lights is below 1.7 (that of unit
    // normals is at most 1), and those of the highlight, which are at most 4 * 63 * 2^23.
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
    if constexpr (Model == Highlight::kBlinn) return wrap_add(closeness_origin_[0], other);
    return wrap_add(closeness_origin_[light], wrap_mul(scalars[light].raw() >> 15, other >> 15));
  }
  /// The highlight of a single light at a closeness above 0, without its fade() by N·L.
  [[nodiscard]] constexpr PackedRgb highlight_at(std::int32_t closeness) const {
    return highlights_.colour(highlights_.value(closeness) >> 16);
  }
  [[nodiscard]] constexpr const auto& fade() const { return static_cast<const FadeFor<Features>&>(*this); }

  /// The diffuse part of a colour by the scalar of diffuse_scalar() or diffuse_sum().
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb diffuse_colour(
      Cosine normal_light) const requires kHasRamp {
    return ramp_[ramp_index(normal_light)];
  }
  /// The scalar of diffuse_colour() as long as every light i that is in `lit` (bit i) has N·L >= 0 and every
  /// other one N·L <= 0: N·L of one light, the mean of several by their weights. It is linear in the normal.
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
  /// The scalar of diffuse_colour() for any normal: the weighted sum of max(0, N·L). `scalars` begins with
  /// N·L of every light.
  template <std::size_t Count>
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine diffuse_sum(const std::array<Cosine, Count>& scalars) const
      requires(kHasRamp&& Lights > 1 && Count >= Lights) {
    std::uint32_t sum = 0;
    unrolled<Lights>([&](auto i) { sum += not_negative(scalars[i]) * this->shares[i]; });
    return Cosine::from_raw(static_cast<std::int32_t>(sum));
  }

  /// The green channel of diffuse_colour() as a linear function; for illuminations that have a ramp().
  [[nodiscard]] constexpr LinearLevel linear_level() const {
    // Light in steps has at most 16, so that a sixteenth of its ramp has the colour of the first.
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

 protected:
  using ChannelLevels = std::array<std::uint32_t, 3>;  ///< in 8-bit steps, 20 fraction bits
  using Scale = ScaleFor<Lights, Features>;

  constexpr SurfaceLight() = default;

  /// `scalar` or 0 if it is negative, 15 fraction bits. Look-ups in the ramp clamp their sum.
  [[nodiscard]] static constexpr std::uint32_t not_negative(Cosine scalar) {
    const std::int32_t raw = scalar.raw() >> 15;
    return raw < 0 ? 0u : static_cast<std::uint32_t>(raw);
  }
  /// `scalar` clamped to 0...1, 15 fraction bits.
  [[nodiscard]] static constexpr std::uint32_t clamped(Cosine scalar) {
    const std::uint32_t light = not_negative(scalar);
    return light > 32768 ? 32768u : light;
  }
  /// The largest channel of a highlight at a closeness above 0, after fade(); 8-bit steps, 8 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t faded_highlight(std::int32_t closeness,
                                                                       Cosine normal_light) const {
    return fade()(highlights_.value(closeness) >> 16, normal_light);
  }
  /// The colour of these levels, saturated, after `half` was added to each: half an 8-bit step by default.
  [[nodiscard]] ARCSPAN_INLINE static constexpr PackedRgb packed_levels(const ChannelLevels& levels,
                                                                        std::uint32_t half = std::uint32_t{1}
                                                                                             << 19) {
    const auto level = [&levels, half](std::size_t channel) {
      const std::uint32_t rounded = (levels[channel] + half) >> 18;
      return rounded > 1023 ? 1023u : rounded;
    };
    return PackedRgb::of(level(0), level(1), level(2));
  }
  /// The weighted sum of N·L at the end of the ramp, or in full coloured light; 15 fraction bits.
  [[nodiscard]] constexpr std::uint32_t ramp_range() const {
    if constexpr (Lights > 1 && kHasRamp) return this->range;
    return static_cast<std::uint32_t>(Lights) << 15;
  }

  /// Entry i is ambient + diffuse * ramp_range() * (i + 1/2) / size. First, so that it needs no offset.
  std::array<PackedRgb, kHasRamp ? kRampSize : 0> ramp_{};
  std::array<std::uint32_t, 3> ambient_{};  ///< in 8-bit steps, 20 fraction bits
  /// The origin of closeness (HighlightTable): one per light by R·V, the same for all by N·H.
  std::array<std::int32_t, Model == Highlight::kPhong ? Lights : 1> closeness_origin_{};
  std::array<std::uint32_t, 3> diffuse_{};  ///< in 8-bit steps, 5 fraction bits
  HighlightTable highlights_{};

 private:
  /// Adds the light of the coloured lights from I on. By recursion, because gcc keeps sums in memory that
  /// loops or lambdas over the lights change.
  template <std::size_t I = 0>
  ARCSPAN_INLINE constexpr void add_coloured(const Scalars& scalars, ChannelLevels& diffuse,
                                             ChannelLevels& specular) const {
    const std::uint32_t light = clamped(scalars[I]);
    if (light != 0) {
      const std::int32_t at = closeness(scalars, I);
      unrolled<3>([&](auto c) { diffuse[c] += diffuse_[c] * ((light * this->weights[I][c]) >> 15); });
      if (at > 0) {
        const std::uint32_t most = faded_highlight(at, scalars[I]);
        unrolled<3>([&](auto c) {
          specular[c] += ((highlights_.channel(c, most) * this->weights[I][c]) >> 15) << 12;
        });
      }
    }
    if constexpr (I + 1 < Lights) add_coloured<I + 1>(scalars, diffuse, specular);
  }
  /// Adds the lights from the I-th on to the sums of channel_light(): `diffuse` as add_coloured() does,
  /// `highlight` in steps of the channel of a 5-6-5 pixel, 23 fraction bits.
  template <std::size_t I = 0>
  ARCSPAN_INLINE constexpr void add_channel_light(const Scalars& scalars, ChannelLevels& diffuse,
                                                  ChannelLevels& highlight) const {
    const std::int32_t light = scalars[I].raw() >> 15;  // may be above 1: the sums are clamped
    if (light > 0) {
      unrolled<3>([&](auto c) { diffuse[c] += static_cast<std::uint32_t>(light) * this->tints[I][c]; });
      const std::int32_t at = closeness(scalars, I);
      if (at > 0) {
        const std::uint32_t most = faded_highlight(at, scalars[I]);
        unrolled<3>([&](auto c) { highlight[c] += most * this->shines[I][c]; });
      }
    }
    if constexpr (I + 1 < Lights) add_channel_light<I + 1>(scalars, diffuse, highlight);
  }
};

}  // namespace arcspan
