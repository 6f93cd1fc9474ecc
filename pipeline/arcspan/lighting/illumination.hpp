// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/power_table.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/status.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Which cosine the highlight is a power of: Blinn's N·H (S0 eq. 12) or Phong's R·V (S0 eq. 1).
enum class Highlight : std::uint8_t { kBlinn, kPhong };

/// One value per colour channel, each 0...1.
struct ChannelCoefficients {
  Coefficient r{};
  Coefficient g{};
  Coefficient b{};
};

/// What the surface does with light: ambient, diffuse and specular share per channel, and the highlight's
/// exponent (1...256).
struct Material {
  ChannelCoefficients ambient;
  ChannelCoefficients diffuse;
  ChannelCoefficients specular;
  std::int32_t shininess = 32;
};

/// A light so far away that its direction is the same all over the object. `towards` is the unit vector to
/// the light in object space, `strength` its factor 1 / (d + K) (S1), 0...1.
struct DirectionalLight {
  Direction towards;
  Coefficient strength = Coefficient::of(1.0);
};

/// A colour in 256ths of an 8-bit step per channel, 0...65280: what Gouraud shading interpolates.
struct DeepColour {
  std::int32_t r;
  std::int32_t g;
  std::int32_t b;
};

/// Squared chords (28 fraction bits) of 16 and of 12 degrees. A patch up to 16 degrees is within 3.3e-4 of
/// bilinear SLERP; what is a third of an 8-bit step in the diffuse light grows with the exponent in a
/// highlight, which therefore may ask for more.
inline constexpr std::uint32_t kWidestPatch = 20797469u;
inline constexpr std::uint32_t kWidestSharpPatch = 11731918u;
[[nodiscard]] constexpr std::uint32_t widest_patch(std::int32_t shininess) {
  return shininess > 16 ? kWidestSharpPatch : kWidestPatch;
}

/// The illumination of one object by `Lights` (1...4) lights: constants and the way from a normal's scalars
/// to a colour. The scalars of a normal N are N·L for every light, then N·H for every light (Blinn) or N·V
/// once (Phong). They are linear in N, which is why arcs carry them.
template <std::size_t Lights, Highlight Model>
class Illumination {
 public:
  static_assert(Lights >= 1 && Lights <= 4);
  static constexpr std::size_t kLights = Lights;
  static constexpr Highlight kModel = Model;
  static constexpr std::size_t kScalars = Model == Highlight::kBlinn ? 2 * Lights : Lights + 1;
  using Scalars = std::array<Cosine, kScalars>;

  constexpr Illumination() = default;

  /// `lights` and `to_eye` (the unit vector to the eye) in object space. kInvalidArgument if a coefficient or
  /// a strength is outside 0...1 or the shininess outside 1...256.
  static constexpr Status make(const Material& material, const std::array<DirectionalLight, Lights>& lights,
                               const Direction& to_eye, Illumination& illumination);

  /// The same as a constant, which can lie in flash; what make() would refuse does not compile.
  [[nodiscard]] static consteval Illumination of(const Material& material,
                                                 const std::array<DirectionalLight, Lights>& lights,
                                                 const Direction& to_eye) {
    Illumination illumination;
    if (!ok(make(material, lights, to_eye, illumination))) detail::constant_refused();
    return illumination;
  }

  /// The scalars of a unit normal.
  [[nodiscard]] constexpr Scalars scalars(const Direction& normal) const {
    Scalars result;
    for (std::size_t i = 0; i < kScalars; ++i) result[i] = dot(normal, axes_[i]);
    return result;
  }

  /// pixel = ambient + diffuse * sum(strength * max(0, N·L)) + specular * sum(strength * factor^n), where N·L
  /// > 0, each channel rounded and clamped. With one light the diffuse part comes from a ramp of 256 colours.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Scalars& scalars) const {
    if constexpr (Lights == 1) {
      const PackedRgb ramp = diffuse_colour(scalars[0]);
      const std::int32_t half_distance = highlight_distance(scalars[0], scalars[1], 0);
      if (half_distance >= power_.half_reach() || scalars[0].raw() <= 0) return ramp;
      return with_highlight(ramp, power_(half_distance));
    } else {
      const Light light = gather(scalars);
      return PackedRgb::of(level(0, light), level(1, light), level(2, light));
    }
  }

  /// The same where no highlight is within reach; one light only.
  [[nodiscard]] constexpr PackedRgb diffuse_colour(Cosine normal_light) const requires(Lights == 1) {
    const std::uint32_t index = clamped_byte(normal_light.raw() >> (Cosine::kFraction - kRampBits));
    return ramp_[static_cast<std::size_t>(index)];
  }

  /// diffuse_colour() of N·L = i / 256 ... (i + 1) / 256.
  [[nodiscard]] constexpr const auto& ramp() const requires(Lights == 1) { return ramp_; }

  /// The code that `Codes` (code_table.hpp) has for it or, where there is a highlight,
  /// Format::encode(colour()).
  template <class Format, class Colours>
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded encoded(const Scalars& scalars,
                                                                          const Colours& encoded) const
      requires(Lights == 1) {
    const std::int32_t half_distance = highlight_distance(scalars[0], scalars[1], 0);
    if (half_distance >= power_.half_reach() || scalars[0].raw() <= 0) return encoded[scalars[0]];
    return Format::encode(with_highlight(diffuse_colour(scalars[0]), power_(half_distance)));
  }

  /// False if scalars that exceed those of the three vertices by `headroom` at most have no highlight.
  [[nodiscard]] constexpr bool may_shine(const Scalars& a, const Scalars& b, const Scalars& c,
                                         Cosine headroom) const {
    return nearest_highlight(a, b, c, headroom) < power_.half_reach();
  }
  /// The least half distance (PowerTable) of a highlight from such scalars; INT32_MAX where all are dark.
  [[nodiscard]] constexpr std::int32_t nearest_highlight(const Scalars& a, const Scalars& b, const Scalars& c,
                                                         Cosine headroom) const {
    const auto highest = [&](std::size_t i) {
      const Cosine upper = a[i] > b[i] ? a[i] : b[i];
      const Cosine most = (upper > c[i] ? upper : c[i]) + headroom;
      return most.raw() < 0 ? Cosine{} : most;
    };
    std::int32_t nearest = INT32_MAX;
    for (std::size_t i = 0; i < Lights; ++i) {
      const Cosine light = highest(i);
      if (light.raw() == 0) continue;
      const Cosine other = highest(Model == Highlight::kBlinn ? Lights + i : Lights);
      const std::int32_t distance = highlight_distance(light, other, i);
      if (distance < nearest) nearest = distance;
    }
    return nearest;
  }

  /// (1 - R·V) / 2 at a normal with these scalars, 30 fraction bits; within 2^-28, where a pixel rounds both
  /// factors to 15 bits.
  [[nodiscard]] constexpr std::int32_t half_distance(Cosine normal_light, Cosine normal_eye) const
      requires(Lights == 1 && Model == Highlight::kPhong) {
    const std::int32_t product = multiply_high(normal_light.raw(), normal_eye.raw());
    return wrap_sub(half_one_plus_light_eye_[0], wrap_shl(product, 2));
  }

  /// The squared chord up to which a triangle with a highlight may be a patch.
  [[nodiscard]] constexpr std::uint32_t widest_patch() const { return widest_patch_; }

  /// The largest diffuse and specular coefficient, in 8-bit steps with 5 fraction bits.
  [[nodiscard]] constexpr std::uint32_t most_diffuse() const { return largest_channel(diffuse_); }
  [[nodiscard]] constexpr std::uint32_t most_specular() const { return largest_channel(specular_); }
  [[nodiscard]] constexpr const PowerTable& power() const { return power_; }
  [[nodiscard]] constexpr std::uint32_t shininess() const { return shininess_; }
  /// Per channel, in 8-bit steps with 5 fraction bits.
  [[nodiscard]] constexpr const std::array<std::uint32_t, 3>& specular() const { return specular_; }
  /// A bound of any channel's second derivative by the normal's angle along a great circle, in 8-bit steps
  /// with 5 fraction bits: |cos''| <= 1, |(cos^n)''| <= n, and R turns by twice the angle.
  [[nodiscard]] constexpr std::uint32_t most_curvature() const { return most_curvature_; }
  /// Whether a channel's sum can exceed 255 and be clamped, with highlights or without.
  [[nodiscard]] constexpr bool may_clamp(bool shines) const {
    for (std::size_t c = 0; c < 3; ++c) {
      // 5 fraction bits.
      const std::uint32_t lit =
          (diffuse_[c] + (shines ? specular_[c] : 0)) * static_cast<std::uint32_t>(Lights);
      if ((ambient_[c] >> 15) + lit >= 255u << 5) return true;
    }
    return false;
  }

  /// The same in 256ths of a step, always by multiplication.
  [[nodiscard]] constexpr DeepColour deep_colour(const Scalars& scalars) const {
    const Light light = gather(scalars);
    return {deep_level(0, light), deep_level(1, light), deep_level(2, light)};
  }

 private:
  static constexpr int kRampBits = 8;

  /// Sums over the lights with 15 fraction bits, 0...4 each.
  struct Light {
    std::uint32_t diffuse = 0;
    std::uint32_t specular = 0;
  };

  /// A ramp colour plus the highlight, each channel clamped.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb with_highlight(PackedRgb ramp, std::uint32_t power) const {
    const auto share = [power](std::uint32_t coefficient) { return (coefficient * power) >> 18; };
    if (white_specular_ != 0) return ramp.plus(PackedRgb::grey(share(white_specular_)));
    return ramp.plus(PackedRgb::of(share(specular_[0]), share(specular_[1]), share(specular_[2])));
  }

  /// A scalar of at most 1 as 15 bits; negative becomes 0.
  [[nodiscard]] static constexpr std::uint32_t clamped(Cosine scalar) {
    const std::int32_t raw = scalar.raw() >> 15;
    return raw <= 0 ? 0u : raw > 32768 ? 32768u : static_cast<std::uint32_t>(raw);
  }

  /// (1 - c) / 2 of the cosine c that the highlight is a power of, 30 fraction bits. `other` is the light's
  /// N·H or N·V. Phong's c is R·V = 2 (N·L)(N·V) - L·V, so this is (1 + L·V) / 2 - (N·L)(N·V).
  [[nodiscard]] constexpr std::int32_t highlight_distance(Cosine normal_light, Cosine other,
                                                          std::size_t light) const {
    if constexpr (Model == Highlight::kBlinn) {
      return (std::int32_t{1} << (Cosine::kFraction - 1)) - (other.raw() >> 1);
    } else {
      // 15 rounded bits each: truncated ones would shift a highlight of n = 64 by up to two 8-bit steps.
      const std::int32_t product =
          wrap_mul(round_shift(normal_light.raw(), 15), round_shift(other.raw(), 15));
      return wrap_sub(half_one_plus_light_eye_[light], product);
    }
  }

  [[nodiscard]] constexpr Light gather(const Scalars& scalars) const {
    Light light;
    unrolled<Lights>([&](auto i) {
      const std::uint32_t diffuse = clamped(scalars[i]);
      if (diffuse == 0) return;
      const Cosine other = scalars[Model == Highlight::kBlinn ? Lights + i : Lights];
      const std::int32_t half_distance = highlight_distance(scalars[i], other, i);
      const std::uint32_t specular = half_distance < power_.half_reach() ? power_(half_distance) : 0;
      if constexpr (Lights == 1) {
        light = {diffuse, specular};
      } else {
        light.diffuse += (diffuse * strength_[i] + (1u << 14)) >> 15;
        light.specular += (specular * strength_[i] + (1u << 14)) >> 15;
      }
    });
    return light;
  }

  /// A channel with 20 fraction bits: coefficients have 5 beside the 8-bit step, light has 15. At most
  /// 255 * (1 + 4 + 4) * 2^20 < 2^32.
  [[nodiscard]] constexpr std::uint32_t channel(std::size_t c, const Light& light) const {
    return ambient_[c] + diffuse_[c] * light.diffuse + specular_[c] * light.specular;
  }
  [[nodiscard]] constexpr std::uint32_t level(std::size_t c, const Light& light) const {
    const std::uint32_t rounded = (channel(c, light) + (std::uint32_t{1} << 19)) >> 18;
    return rounded > 1023 ? 1023 : rounded;
  }
  [[nodiscard]] constexpr std::int32_t deep_level(std::size_t c, const Light& light) const {
    const std::uint32_t rounded = (channel(c, light) + (1u << 11)) >> 12;
    return static_cast<std::int32_t>(rounded > 65280 ? 65280 : rounded);
  }

  constexpr void make_ramp();

  /// ambient + diffuse * (i + 1/2) / 256; one light only. First, so that an index reaches it.
  std::array<PackedRgb, Lights == 1 ? 256 : 0> ramp_{};
  std::array<Direction, kScalars> axes_{};
  std::array<std::uint32_t, 3> ambient_{};
  std::array<std::uint32_t, 3> diffuse_{};
  std::array<std::uint32_t, 3> specular_{};
  std::array<std::uint32_t, Lights> strength_{};
  std::array<std::int32_t, Lights> half_one_plus_light_eye_{};
  PowerTable power_{};
  std::uint32_t widest_patch_ = 0;
  std::uint32_t most_curvature_ = 0;
  std::uint32_t shininess_ = 1;
  std::uint32_t white_specular_ = 0;  ///< the three specular coefficients if they are the same, else 0
};

}  // namespace arcspan

#include <arcspan/lighting/make_illumination.hpp>
#include <arcspan/target.hpp>
