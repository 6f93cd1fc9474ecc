// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/pixel_operation.hpp>
#include <arcspan/pixel/spread_rgb565.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// Where fog begins and where it hides everything: distances before the camera, in one unit with the planes
/// of the camera, 0 < near_plane < far_plane and start < end. Raw values of ObjectLength or WorldLength.
struct FogRange {
  std::int32_t near_plane = 0;
  std::int32_t far_plane = 0;
  std::int32_t start = 0;
  std::int32_t end = 0;
};

/// Fog: the share of its colour grows linearly with the distance, from 0 at `start` to 1 at `end`. The share
/// is looked up by the depth of each pixel, so that it is right on large triangles too. It needs a depth
/// buffer.
///
/// Made once per camera. An operation refers to it, so it must outlive drawing.
class Fog {
 public:
  static constexpr std::size_t kEntries = 256;

  /// No fog.
  constexpr Fog() = default;

  /// Returns kInvalidArgument, and does not change `fog`, if the range is not as FogRange states.
  static constexpr Status make(const FogRange& range, Rgb8 colour, Fog& fog) {
    if (range.near_plane <= 0 || range.near_plane >= range.far_plane || range.start >= range.end) {
      return Status::kInvalidArgument;
    }
    for (std::size_t i = 0; i <= kEntries; ++i)
      fog.shares_[i] = share_at(range, static_cast<std::int32_t>(i) * 256);
    fog.colour_ = PackedRgb::of(4u * colour.r + 2, 4u * colour.g + 2, 4u * colour.b + 2);
    fog.spread_ = detail::spread(detail::colour565(fog.colour_));
    return Status::kOk;
  }

  /// The share of the fog at a 16-bit depth, 0...256.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t share(std::uint16_t depth) const {
    const std::uint32_t from = shares_[depth >> 8];
    const std::uint32_t to = shares_[(depth >> 8) + 1u];
    return (from * 256 + (to - from) * (depth & 255u) + 32768u) >> 16;  // `to` is not below `from`
  }
  [[nodiscard]] constexpr PackedRgb colour() const { return colour_; }
  /// The colour as a spread 5-6-5 pixel.
  [[nodiscard]] constexpr std::uint32_t spread_colour() const { return spread_; }

 private:
  /// The share at a depth of up to 65536, 8 fraction bits of 0...256.
  [[nodiscard]] static constexpr std::uint16_t share_at(const FogRange& range, std::int32_t depth) {
    // By ClipTransform::depth(): near/w = 1 - (depth - 256) / 65023 * (1 - near/far).
    constexpr std::int64_t kSpan = 65535 - 2 * 256;
    const std::int64_t near_plane = range.near_plane;
    const std::int64_t far_plane = range.far_plane;
    const std::int64_t beyond = depth < 256 ? 0 : depth - 256 > kSpan ? kSpan : depth - 256;
    // w = near far span / (far span - beyond (far - near)), with far span below 2^47.
    const std::int64_t divisor = far_plane * kSpan - beyond * (far_plane - near_plane);
    const std::int64_t ratio =
        ((far_plane * kSpan) << 12) / (divisor < 1 ? 1 : divisor);  // w / near, 12 bits
    const std::int64_t w = (near_plane * ratio) >> 12;
    const std::int64_t share = ((w - range.start) << 16) / (std::int64_t{range.end} - range.start);
    return static_cast<std::uint16_t>(share < 0 ? 0 : share > 65280 ? 65280 : share);
  }

  std::array<std::uint16_t, kEntries + 1> shares_{};
  PackedRgb colour_{};
  std::uint32_t spread_ = 0;
};

/// The pixel operation of fog.
struct Fogged {
  const Fog* fog = nullptr;

  /// A colour in fog whose depth is not known yet (DepthColour).
  template <class C>
  struct Result : WrappedColour<C> {
    const Fog* fog;

    [[nodiscard]] constexpr std::uint32_t alpha() const requires AlphaColour<C> {
      return this->colour.alpha();
    }

    /// The colour in fog of a known depth.
    struct InFog : WrappedColour<C> {
      const Fog* fog;
      std::uint32_t share;  ///< 0...256

      [[nodiscard]] constexpr PackedRgb packed() const {
        return detail::by_channel(
            detail::packed_colour(this->colour), fog->colour(),
            [this](std::uint32_t a, std::uint32_t b) { return (a * (256 - share) + b * share + 128) >> 8; });
      }
      [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t rgb565() const {
        return detail::joined(detail::mixed_spread(detail::spread(detail::colour565(this->colour)),
                                                   fog->spread_colour(), (share + 4) >> 3));
      }
    };
    [[nodiscard]] ARCSPAN_INLINE constexpr InFog at_depth(std::uint16_t depth) const {
      return {{this->colour}, fog, fog->share(depth)};
    }
    /// Without fog, for runs that have no depth.
    [[nodiscard]] constexpr PackedRgb packed() const { return detail::packed_colour(this->colour); }
  };

  template <class C>
  [[nodiscard]] ARCSPAN_INLINE constexpr auto operator()(const C& colour) const {
    return Result<C>{{colour}, fog};
  }
};

}  // namespace arcspan
