// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination_features.hpp>
#include <arcspan/lighting/power_table.hpp>
#include <arcspan/lighting/triangle_light.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

/// On which triangles planes and quadratic surfaces are as accurate as an illumination wants.
namespace arcspan {

namespace detail {

/// Returns the squared chord, 28 fraction bits, up to which an equilateral triangle with a highlight may be
/// quadratic, so that the highlight differs by at most 1.4 8-bit steps. The difference grows with the
/// exponent and with `height`, the height of the highlights of all lights together (8-bit steps, 5 fraction
/// bits, at most four times 255).
[[nodiscard]] constexpr std::uint32_t widest_patch(Highlight model, std::uint32_t shininess,
                                                   std::uint32_t height) {
  // Entry i is for the exponent 2^i and white highlights by R·V: 23, 23, 23, 20, 17, 14.5, 11, 9, 7.5,
  // 6.3, 5.2 degrees. Blunt highlights would allow 29, but they end abruptly where N·L = 0, so its error
  // counts too. Sharp ones show rounding as well, which leaves less for the surface.
  constexpr std::array<std::uint32_t, 11> kChords{42678632, 42678632, 42678632, 32377278, 23458706, 17100605,
                                                  9863831,  6609772,  4593005,  3241999,  2209600};
  constexpr std::uint32_t kWhiteHeight = 255u << 5;
  // N·H turns by half the angle of R·V, so its highlights are as wide as those of a quarter of the exponent.
  const std::uint32_t exponent = shininess << (model == Highlight::kPhong ? 8 : 6);
  // The exponent of a white highlight that is as sharp, 8 fraction bits.
  const std::uint32_t sharpness = exponent * height / kWhiteHeight;
  if (sharpness <= 256) return kChords[0];
  const int doublings = static_cast<int>(std::bit_width(sharpness)) - 9;
  const std::uint32_t beyond = (sharpness >> doublings) - 256;
  const auto index = static_cast<std::size_t>(doublings);
  if (beyond == 0) return kChords[index];
  constexpr std::size_t kSharp = 4;  // n = 16: beyond it, surfaces between two entries are less accurate
  if (index >= kSharp) return kChords[index + 1];
  // log2(1 + x) = x + 0.344 x (1 - x), error below 0.008; 8 fraction bits
  const std::uint32_t share = beyond + ((beyond * (256 - beyond) * 88) >> 16);
  return kChords[index] - ((kChords[index] - kChords[index + 1]) >> 8) * share;
}

/// Returns x^(2/3), 8 fraction bits, for x of 0...2^16 with 8 fraction bits.
[[nodiscard]] constexpr std::uint32_t two_thirds_power(std::uint32_t x) {
  const std::uint64_t square = (std::uint64_t{x} * x) << 8;  // 24 fraction bits
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 18; bit != 0; bit >>= 1) {
    const std::uint64_t r = root | bit;
    if (r * r * r <= square) root = r;
  }
  return static_cast<std::uint32_t>(root);
}

/// Returns the squared chord at which a quadratic surface has the error `allowed`, from the squared chord
/// `limit` at which it has `error`; both have 5 fraction bits. Errors grow with the cube of the angle.
[[nodiscard]] constexpr std::uint32_t limit_at_error(std::uint32_t limit, std::uint32_t error,
                                                     std::uint32_t allowed) {
  const std::uint32_t factor = two_thirds_power((allowed << 8) / (error == 0 ? 1 : error));
  const std::uint64_t wider = (std::uint64_t{limit} * factor) >> 8;
  return static_cast<std::uint32_t>(wider < kWidestQuadratic ? wider : kWidestQuadratic);
}

/// The error of N·L, in 8-bit steps of full light with 5 fraction bits, that planes and quadratic surfaces
/// may have without tolerance: 0.2.
inline constexpr std::uint32_t kExactEnough = 6;
/// The squared chord at which a quadratic surface of full light has that error: 17.8 degrees.
inline constexpr std::uint32_t kWidestExact = 25690112u;
/// The error of a highlight at widest_patch(), 1.4 8-bit steps.
inline constexpr std::uint32_t kHighlightError = 45;
/// Entry i is (16 / (i + 1))^(2/3) with 4 fraction bits, rounded down. Not a variable of the function,
/// because gcc would copy it to the stack.
inline constexpr std::array<std::uint8_t, 16> kWiderAtSlope{101, 64, 48, 40, 34, 30, 27, 25,
                                                            23,  21, 20, 19, 18, 17, 16, 16};

}  // namespace detail

/// Returns the squared chord (28 fraction bits, as `limit`) at which a surface under highlights of this slope
/// (0...15) has the error that it has at `limit` under the brightest: `limit` times 1...6.3. The error of a
/// highlight is that of its cosine, which grows with the cube of the angle, times the slope.
[[nodiscard]] constexpr std::uint32_t limit_at_slope(std::uint32_t limit, std::uint8_t slope) {
  return (limit >> 4) * detail::kWiderAtSlope[slope];
}

/// The limits of an illumination, by which light_over() chooses. Squared chords have 28 fraction bits.
struct AccuracyLimits {
  std::int32_t tolerance = 0;  ///< Illumination::set_tolerance()
  /// The change of the largest diffuse channel from no light to all, and the height of the highlights of all
  /// lights together, in 8-bit steps with 5 fraction bits.
  std::uint32_t light_height = 0;
  std::uint32_t highlight_height = 0;
  std::uint32_t widest_patch = 0;   ///< squared chord of quadratic surfaces under the brightest highlight
  std::uint32_t sharpness = 0;      ///< the change of all highlights with s/12 (light_over()), in half steps
  std::uint32_t allowed_light = 0;  ///< 12 times the error of planes, 8-bit steps, 5 fraction bits
  std::uint32_t allowed_highlight = 0;  ///< that of highlights
  std::int32_t shine_reach = 0;      ///< least half distance at which highlights are below half the tolerance
  std::uint32_t widest_diffuse = 0;  ///< squared chord of quadratic surfaces without highlight
  std::uint32_t widest_highlight = 0;  ///< widest_patch with the tolerance

  /// Sets the others by the first four and the highlight's model, exponent and power.
  constexpr void set(Highlight model, std::uint32_t shininess, const PowerTable& power) {
    const std::uint32_t more = static_cast<std::uint32_t>(tolerance) << 5;
    const std::uint32_t turns = model == Highlight::kBlinn ? 1 : 4;  // R turns twice as fast as N
    sharpness = (highlight_height * shininess * turns) >> 6;         // below 2^20
    // Between normals that are 60 degrees apart planes are off by 1.7 times the s/12 of light_over(): there
    // by one step and the tolerance.
    const std::uint32_t wide = ((32 + more) * 10 + 8) / 17;
    allowed_light = 12 * (detail::kExactEnough + more < wide ? detail::kExactEnough + more : wide);
    allowed_highlight = 12 * (detail::kHighlightError + more);
    const std::uint32_t exact = (detail::kExactEnough * light_height) / (255u << 5);
    widest_diffuse = detail::limit_at_error(detail::kWidestExact, exact, detail::kExactEnough + more);
    widest_highlight =
        detail::limit_at_error(widest_patch, detail::kHighlightError, detail::kHighlightError + more);
    // The least distance at which the highlights of all lights together are below half the tolerance: any,
    // even one below 0, as bounds may be, if they are so at their peak.
    const std::uint32_t height = highlight_height;  // a copy, which stores do not change
    shine_reach = INT32_MIN;
    if (height * power(0) <= more << 14) return;
    std::int32_t reach = 0;
    for (std::int32_t bit = std::int32_t{1} << 29; bit != 0; bit >>= 1) {
      const std::int32_t further = reach | bit;
      if (further < power.half_reach() && height * power(further) > more << 14) reach = further;
    }
    shine_reach = reach + 1;
  }
};

}  // namespace arcspan
