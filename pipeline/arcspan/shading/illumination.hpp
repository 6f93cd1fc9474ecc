// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/direction.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/shading/power_table.hpp>
#include <arcspan/status.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Which cosine the highlight is a power of: Blinn's N·H (S0 eq. 12) or Phong's R·V (S0 eq. 1).
enum class Highlight : std::uint8_t { kBlinn, kPhong };

/// One value per colour channel, each 0...1.
struct ChannelCoefficients {
  Coefficient r;
  Coefficient g;
  Coefficient b;
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
  std::int32_t r = 0;
  std::int32_t g = 0;
  std::int32_t b = 0;
};

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
  using Scalars = std::array<Unit, kScalars>;

  constexpr Illumination() = default;

  /// `lights` and `to_eye` (the unit vector to the eye) in object space. kInvalidArgument if a coefficient or
  /// a strength is outside 0...1 or the shininess outside 1...256.
  static Status make(const Material& material, const std::array<DirectionalLight, Lights>& lights,
                     const Direction& to_eye, Illumination& illumination);

  /// The scalars of a unit normal.
  [[nodiscard]] Scalars scalars(const Direction& normal) const {
    Scalars result;
    for (std::size_t i = 0; i < kScalars; ++i) result[i] = dot(normal, axes_[i]);
    return result;
  }

  /// pixel = ambient + diffuse * sum(strength * max(0, N·L)) + specular * sum(strength * factor^n), where N·L
  /// > 0.
  [[nodiscard]] constexpr Rgb8 colour(const Scalars& scalars) const {
    const Light light = gather(scalars);
    return {level(0, light), level(1, light), level(2, light)};
  }

  /// The same in 256ths of a step.
  [[nodiscard]] constexpr DeepColour deep_colour(const Scalars& scalars) const {
    const Light light = gather(scalars);
    return {deep_level(0, light), deep_level(1, light), deep_level(2, light)};
  }

 private:
  /// Sums over the lights with 15 fraction bits, 0...4 each.
  struct Light {
    std::uint32_t diffuse = 0;
    std::uint32_t specular = 0;
  };

  /// A scalar of at most 1 as 15 bits; negative becomes 0.
  [[nodiscard]] static constexpr std::uint32_t clamped(Unit scalar) {
    const std::int32_t raw = scalar.raw() >> 15;
    return raw <= 0 ? 0u : raw > 32768 ? 32768u : static_cast<std::uint32_t>(raw);
  }

  /// R·V = 2 (N·L)(N·V) - L·V.
  [[nodiscard]] constexpr Unit reflected(Unit normal_light, Unit normal_eye, std::size_t light) const {
    const std::int32_t product =
        wrap_mul(normal_light.raw() >> 15, normal_eye.raw() >> 15);  // 30 fraction bits
    const std::int32_t half = wrap_sub(product, light_eye_[light].raw() >> 1);
    constexpr std::int32_t kHalfOne = 1 << 29;
    return Unit::from_raw(half >= kHalfOne ? 2 * kHalfOne : half <= -kHalfOne ? -2 * kHalfOne : 2 * half);
  }

  [[nodiscard]] constexpr Light gather(const Scalars& scalars) const {
    Light light;
    for (std::size_t i = 0; i < Lights; ++i) {
      const std::uint32_t diffuse = clamped(scalars[i]);
      if (diffuse == 0) continue;
      const Unit cosine = Model == Highlight::kBlinn ? scalars[(Lights + i) % kScalars]
                                                     : reflected(scalars[i], scalars[Lights], i);
      const std::uint32_t specular = power_(cosine);
      if constexpr (Lights == 1) {
        light = {diffuse, specular};
      } else {
        light.diffuse += (diffuse * strength_[i] + (1u << 14)) >> 15;
        light.specular += (specular * strength_[i] + (1u << 14)) >> 15;
      }
    }
    return light;
  }

  /// A channel with 20 fraction bits: coefficients have 5 beside the 8-bit step, light has 15. At most
  /// 255 * (1 + 4 + 4) * 2^20 < 2^32.
  [[nodiscard]] constexpr std::uint32_t channel(std::size_t c, const Light& light) const {
    return ambient_[c] + diffuse_[c] * light.diffuse + specular_[c] * light.specular;
  }
  [[nodiscard]] constexpr std::uint8_t level(std::size_t c, const Light& light) const {
    const std::uint32_t rounded = (channel(c, light) + (1u << 19)) >> 20;
    return static_cast<std::uint8_t>(rounded > 255 ? 255 : rounded);
  }
  [[nodiscard]] constexpr std::int32_t deep_level(std::size_t c, const Light& light) const {
    const std::uint32_t rounded = (channel(c, light) + (1u << 11)) >> 12;
    return static_cast<std::int32_t>(rounded > 65280 ? 65280 : rounded);
  }

  std::array<Direction, kScalars> axes_{};
  std::array<std::uint32_t, 3> ambient_{};
  std::array<std::uint32_t, 3> diffuse_{};
  std::array<std::uint32_t, 3> specular_{};
  std::array<std::uint32_t, Lights> strength_{};
  std::array<Unit, Lights> light_eye_{};
  PowerTable power_{};
};

}  // namespace arcspan
