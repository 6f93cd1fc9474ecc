// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/checked.hpp>
#include <arcspan/lighting/check_light.hpp>
#include <arcspan/lighting/directional_light.hpp>
#include <arcspan/lighting/material.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/unit_vector.hpp>
#include <arcspan/scene/world.hpp>
#include <arcspan/status.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

inline constexpr Coefficient kFull = Coefficient::of(1.0);
inline constexpr ChannelCoefficients kWhite{kFull, kFull, kFull};

/// A light in world space.
class SceneLight {
 public:
  /// A light so far away that its direction is the same everywhere. `towards` is the unit vector to it.
  [[nodiscard]] static constexpr SceneLight directional(const Direction& towards,
                                                        Coefficient strength = kFull,
                                                        const ChannelCoefficients& colour = kWhite) {
    ARCSPAN_CHECK(detail::is_unit(towards), "SceneLight::directional: the direction is not a unit vector");
    return {towards, {}, {}, strength, colour};
  }
  /// A light at a point. An object of the scene sees it in one direction and with one strength, those at the
  /// middle of its bounding sphere: strength * half / (distance + half), which is S1's 1 / (d + K) with
  /// K = half, scaled to `strength` at no distance. At the distance `half` half of it is left. Scenes with a
  /// light whose `half` is not above 0 are refused (kInvalidArgument).
  [[nodiscard]] static constexpr SceneLight point(const WorldPoint& position, WorldLength half,
                                                  Coefficient strength = kFull,
                                                  const ChannelCoefficients& colour = kWhite) {
    return {{}, position, half.raw() > 0 ? half : WorldLength::from_raw(-1), strength, colour};
  }

  /// The light as an object sees it: `at` is the middle of its bounding sphere, and `rotation` turns object
  /// space to world space. `towards` is in object space. A point light at `at` itself shines nowhere.
  [[nodiscard]] constexpr DirectionalLight seen_from(const WorldPoint& at, const Rotation& rotation) const {
    if (!is_point()) return {rotation.to_object(towards_), strength_, colour_};
    const std::array<std::int64_t, 3> to_light = detail::difference(at, position_);
    // The largest component has at most 31 bits, so that the sum of squares fits 64.
    const int down =
        static_cast<int>((magnitude(to_light[0]) | magnitude(to_light[1]) | magnitude(to_light[2])) >> 31);
    std::uint64_t square = 0;
    for (const std::int64_t c : to_light) square += (magnitude(c) >> down) * (magnitude(c) >> down);
    const std::uint64_t distance = std::uint64_t{wide_integer_root(square)} << down;
    const auto half = static_cast<std::uint64_t>(half_.raw());
    const auto left =
        static_cast<std::int32_t>(static_cast<std::uint64_t>(strength_.raw()) * half / (distance + half));
    return {rotation.to_object(normalised_wide(to_light[0], to_light[1], to_light[2])),
            Coefficient::from_raw(left), colour_};
  }

  /// True if the strength and the colour are in 0...1, and the half distance of a point light above 0.
  [[nodiscard]] constexpr bool valid() const {
    return half_.raw() >= 0 && detail::in_unit_range(strength_) && detail::in_unit_range(colour_);
  }
  [[nodiscard]] constexpr bool is_point() const { return half_.raw() > 0; }
  [[nodiscard]] constexpr Coefficient strength() const { return strength_; }
  [[nodiscard]] constexpr const ChannelCoefficients& colour() const { return colour_; }

 private:
  constexpr SceneLight(const Direction& towards, const WorldPoint& position, WorldLength half,
                       Coefficient strength, const ChannelCoefficients& colour)
      : towards_(towards), position_(position), half_(half), strength_(strength), colour_(colour) {}

  Direction towards_;
  WorldPoint position_;
  WorldLength half_;  ///< 0 for directional lights; -1 for a point light that was given none above 0
  Coefficient strength_;
  ChannelCoefficients colour_;
};

/// The lights of a scene: up to as many as the shading methods take, and the colour of the ambient light,
/// which is multiplied with the ambient colours of materials when they are prepared (see Use).
/// Highlights are those of an eye that is far away: its direction is the camera's axis for all objects.
struct LightList {
  std::span<const SceneLight> lights;
  ChannelCoefficients ambient = kWhite;
};

namespace detail {

/// Whether a method of so many lights can have these.
[[nodiscard]] constexpr Status check_lights(const LightList& lights, std::size_t most) {
  if (lights.lights.size() > most) return Status::kTooManyLights;
  for (const SceneLight& light : lights.lights) {
    if (!light.valid()) return Status::kInvalidArgument;
  }
  return in_unit_range(lights.ambient) ? Status::kOk : Status::kInvalidArgument;
}

}  // namespace detail

}  // namespace arcspan
