// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace arcspan {

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
ARCSPAN_INLINE constexpr PackedRgb Illumination<Lights, Model, Features>::highlight(
    std::uint32_t power) const {
  const auto share = [power](std::uint32_t coefficient) {
    const std::uint32_t level = (coefficient * power) >> 18;
    return Lights == 1 || level < 1023 ? level : 1023u;  // several highlights may coincide
  };
  if constexpr (kHasWideRegisters && Lights == 1) {
    // One test for both: the share is 0 if the highlight is not white.
    const std::uint32_t level = share(white_specular_);
    if (level != 0) [[likely]]
      return PackedRgb::grey(level);
  } else {
    if (white_specular_ != 0) return PackedRgb::grey(share(white_specular_));
  }
  return PackedRgb::of(share(specular_[0]), share(specular_[1]), share(specular_[2]));
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
ARCSPAN_INLINE constexpr PixelLight Illumination<Lights, Model, Features>::light(
    const Scalars& scalars) const {
  if constexpr (Lights == 1) {
    const PackedRgb ramp = diffuse_colour(scalars[0]);
    const std::int32_t half_distance = highlight_distance(scalars[0], scalars[1], 0);
    if (half_distance >= power_.half_reach() || scalars[0].raw() <= 0) return {ramp, {}};
    return {ramp, highlight(fade()(power_(half_distance), scalars[0]))};
  } else if constexpr (kHasRamp) {
    GreySums sums;
    add_grey_lights(scalars, sums, std::make_index_sequence<Lights>{});
    const PackedRgb ramp = diffuse_colour(Cosine::from_raw(static_cast<std::int32_t>(sums.diffuse)));
    return {ramp, sums.power == 0 ? PackedRgb{} : highlight(sums.power)};
  } else {
    return {colour(scalars), {}};
  }
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
template <class Format, class Table>
ARCSPAN_INLINE constexpr typename Format::Encoded Illumination<Lights, Model, Features>::encoded_at(
    Cosine normal_light, std::int32_t half_distance, const Table& table) const requires(Lights == 1) {
  // The common case of a lit pixel takes one comparison per scalar, after which nothing needs clamping.
  std::uint32_t power = 0;
  if (static_cast<std::uint32_t>(half_distance) < static_cast<std::uint32_t>(power_.half_reach()))
      [[likely]] {
    power = power_.at_distance(static_cast<std::uint32_t>(half_distance));
  } else {
    if (half_distance >= 0) return table[normal_light];
    power = power_.at_distance(0);
  }
  const auto light = static_cast<std::uint32_t>(normal_light.raw());
  constexpr std::uint32_t kFull = std::uint32_t{1} << Cosine::kFraction;
  PackedRgb ramp = ramp_.back();
  if (light - 1u < kFull - 1u) [[likely]] {
    ramp = ramp_[light >> (Cosine::kFraction - kRampBits)];
  } else if (normal_light.raw() <= 0) {
    return table[normal_light];
  }
  return encode_varying<Format>(ramp.plus(highlight(fade()(power, normal_light))));
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
template <class Format, class Run, class Table>
ARCSPAN_INLINE constexpr typename Format::Encoded Illumination<Lights, Model, Features>::encoded_by_tables(
    const Run& run, const Table& table) const requires(kHasTables) {
  const std::int32_t half_distance = wrap_add(half_one_plus_light_eye_[0], run.minus_product());
  if (static_cast<std::uint32_t>(half_distance) < tables().white_reach()) [[likely]] {
    const std::uint32_t power = tables().power(static_cast<std::uint32_t>(half_distance));
    const std::uint32_t white = (white_specular_ * fade()(power, run.lower())) >> 18;
    const PackedRgb lit = tables().lit(run.lower());
    const PackedRgb highlight = PackedRgb::grey(white);
    PackedRgb sum{};
    const bool is_lit =
        lit.add_to(highlight, sum, [&run] { return PhongTables::is_lit(run.again().lower()); });
    if (is_lit) [[likely]]
      return encode_varying<Format>(sum);
  } else if (half_distance >= power_.half_reach()) {
    return table[run.again().lower()];
  }
  // Read again, so that the common case keeps nothing for this one.
  const Illumination* same = this;
  hide_value(same);
  return same->template encoded<Format>(run.again().scalars(), table);
}

}  // namespace arcspan
