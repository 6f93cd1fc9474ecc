// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/lighting/illumination.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// Light in steps (Illumination::set_toon()), for programs that include this header.
namespace arcspan {

inline constexpr std::int32_t kMostToonSteps = 16;

constexpr void HighlightTable::harden() {
  const std::uint32_t peak = value(reach_) >> 16;
  set_lines([&](std::uint32_t i) {
    const std::uint32_t soft = value(static_cast<std::int32_t>(i << kIntervalBits)) >> 16;
    return 2 * soft > peak ? peak : 0u;
  });
}

/// Cartoon light: the colours of `steps` lights, evenly spaced from none to all, in place of a gradual
/// change. The edge between two of them is 1/64 of the ramp wide, about a pixel, so that it is smooth. It
/// takes no time per pixel.
template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr Status Illumination<Lights, Model, Features>::set_toon(std::int32_t steps) requires(
    Lights == 1 || !Features.coloured_lights) {
  if (steps < 2 || steps > kMostToonSteps) return Status::kInvalidArgument;
  if (power_.half_reach() != 0) {  // make() was called
    make_ramp();                   // an earlier call has changed both
    highlights_ = HighlightTable(power_, specular_);
  }
  const auto count = static_cast<std::size_t>(steps);
  std::array<Rgb8, kMostToonSteps> colours;
  for (std::size_t k = 0; k < count; ++k) colours[k] = ramp_[k * (kRampSize - 1) / (count - 1)].rgb8();
  // The parts of an entry are as many as steps.
  const auto edge = static_cast<std::uint32_t>(count * (kRampSize / 64));
  for (std::size_t i = 0; i < kRampSize; ++i) {
    const std::size_t step = i * count / kRampSize;
    const auto inside = static_cast<std::uint32_t>(i * count % kRampSize);
    const Rgb8 to = colours[step];
    const Rgb8 from = step == 0 ? to : colours[step - 1];
    const std::uint32_t share = inside < edge ? inside : edge;
    const auto level = [edge, share](std::uint32_t a, std::uint32_t b) {  // as PackedRgb::of() takes it
      return (a * (edge - share) + b * share) * 4 / edge + 2;
    };
    ramp_[i] = PackedRgb::of(level(from.r, to.r), level(from.g, to.g), level(from.b, to.b));
  }
  highlights_.harden();
  return Status::kOk;
}

}  // namespace arcspan
