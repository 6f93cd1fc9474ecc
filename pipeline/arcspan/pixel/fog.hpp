// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/pixel_operation.hpp>
#include <arcspan/pixel/spread_rgb565.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// Where fog begins and where it hides everything: distances in front of the camera, with its planes; all are
/// raw values of ObjectLength, or all of WorldLength. 0 < near_plane < far_plane, start < end.
struct FogRange {
  std::int32_t near_plane = 0;
  std::int32_t far_plane = 0;
  std::int32_t start = 0;
  std::int32_t end = 0;
  bool orthographic = false;  ///< whether the camera has an orthographic lens
};

/// Fog: the share of its colour grows linearly with the distance, from 0 at `start` to 1 at `end`. The share
/// is looked up by the depth of each pixel, so that it is right on large triangles too. It needs a depth
/// buffer.
///
/// The farther away, the more distance a step of depth stands for. So the table has its finest entries near
/// the depth where the fog ends. It is indexed by d = end depth - depth: an entry for each d below 128, and
/// 128 entries for each doubling of d + 128.
///
/// Made once per camera, which takes about 500,000 instructions; the colour may change in each frame. An
/// operation refers to it, so it must outlive drawing.
class Fog {
 public:
  /// No fog.
  constexpr Fog() = default;

  /// Returns kInvalidArgument, and does not change `fog`, if the range is not as FogRange states.
  static constexpr Status make(const FogRange& range, Rgb8 colour, Fog& fog) {
    if (range.near_plane <= 0 || range.near_plane >= range.far_plane || range.start >= range.end) {
      return Status::kInvalidArgument;
    }
    fog.end_ = end_depth(range);
    const auto at = [&](std::uint32_t difference) {
      const std::int64_t share = share_at(range, fog.end_ - static_cast<std::int32_t>(difference));
      return static_cast<std::uint32_t>(share < 0 ? 0 : share < kFull ? share : kFull);
    };
    for (unsigned i = 0; i < kPerOctave * kOctaves; ++i) {
      // The mean of the first and the last depth of the entry.
      const unsigned octave = kOctaves - 1 - i / kPerOctave;
      const std::uint32_t first = (std::uint32_t{kPerOctave + i % kPerOctave} << octave) - kPerOctave;
      const std::uint32_t both = at(first) + at(first + (std::uint32_t{1} << octave) - 1);
      fog.shares_[i] = static_cast<std::uint8_t>((both * 255 + (1u << kShareBits)) >> (kShareBits + 1));
    }
    fog.set_colour(colour);
    return Status::kOk;
  }

  /// Another colour at the same distances, as at nightfall. Takes a few instructions.
  constexpr void set_colour(Rgb8 colour) {
    colour_ = PackedRgb::of(colour);
    spread_ = detail::spread(detail::colour565(colour_));
  }

  /// The share of the fog at a 16-bit depth, 0...255, and 255 from `end` on. Its error is at most 1.5 if
  /// far_plane is at most 1000 near_plane, and end - start at least 1/1000 of `end`.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t share(std::uint32_t depth) const {
    const std::uint32_t biased =
        clamped_unsigned<16, 0>(end_ - static_cast<std::int32_t>(depth)) + kPerOctave;
    const unsigned octave = octave_of(biased);
    // The highest eight bits are 128...255.
    const std::uint32_t entry = octave * kPerOctave + (biased << octave >> 8);
    return shares_[static_cast<std::size_t>(entry)];
  }
  [[nodiscard]] constexpr PackedRgb colour() const { return colour_; }
  /// The colour as a spread 5-6-5 pixel.
  [[nodiscard]] constexpr std::uint32_t spread_colour() const { return spread_; }

 private:
  static constexpr std::int32_t kNearest = 256;  ///< depths of the planes: ClipTransform::kDepthMargin
  static constexpr std::int32_t kFarthest = 65535 - 256;
  static constexpr unsigned kPerOctave = 128;
  static constexpr unsigned kOctaves = 10;  ///< of a difference plus 128: 128...65407
  static constexpr int kShareBits = 14;
  static constexpr std::int64_t kFull = 1 << kShareBits;

  /// How many zeros a word of 16 bits, 128...65535, begins with: by a table where counting them takes a call.
  [[nodiscard]] ARCSPAN_INLINE static constexpr unsigned octave_of(std::uint32_t word) {
    if constexpr ((kCountsLeadingZeros && kHasManyRegisters) || kOptimisedForSize) {
      return static_cast<unsigned>(std::countl_zero(word)) - 16;
    } else {
      return detail::kByteLeadingZeros[static_cast<std::size_t>(word >> 8)] - 24u;
    }
  }
  /// The distance of a depth, 16 fraction bits.
  [[nodiscard]] static constexpr std::int64_t distance_at(const FogRange& range, std::int32_t depth) {
    constexpr std::int64_t kSpan = kFarthest - kNearest;
    const std::int64_t far_plane = range.far_plane;
    const std::int64_t beyond = (depth - kNearest) * (far_plane - range.near_plane);  // of the near plane
    if (range.orthographic) return (std::int64_t{range.near_plane} << 16) + (beyond << 16) / kSpan;
    // By ClipTransform::depth(): near/w = 1 - (depth - 256) / 65023 * (1 - near/far), so that
    // w = near far span / (far span - beyond), with far span below 2^47. Thin fog needs 32 fraction bits.
    const std::int64_t divisor = far_plane * kSpan - beyond;
    const std::int64_t dividend = (far_plane * kSpan) << 16;
    const std::int64_t ratio =
        ((dividend / divisor) << 16) + ((dividend % divisor) << 16) / divisor;  // w / near
    return (range.near_plane * ratio) >> 16;
  }
  /// The share at a depth, kShareBits fraction bits, not clamped: below 0 where the fog has not begun.
  [[nodiscard]] static constexpr std::int64_t share_at(const FogRange& range, std::int32_t depth) {
    const std::int64_t in_fog = distance_at(range, depth) - (std::int64_t{range.start} << 16);
    return (in_fog >> (16 - kShareBits)) / (std::int64_t{range.end} - range.start);
  }
  /// The first depth at which the fog hides everything; that of the far plane if there is none.
  [[nodiscard]] static constexpr std::int32_t end_depth(const FogRange& range) {
    std::int32_t clear = kNearest - 1;
    for (std::int32_t bit = std::int32_t{1} << 15; bit != 0; bit >>= 1) {
      const std::int32_t further = clear + bit;
      if (further < kFarthest && share_at(range, further) < kFull) clear = further;
    }
    return clear + 1;
  }

  std::int32_t end_ = 0;  ///< no fog
  /// Shares in 255ths. With end_ - depth + 128 = m 2^k, m in 128...255, a depth has entry
  /// 128 (9 - k) + m - 128.
  std::array<std::uint8_t, kPerOctave * kOctaves> shares_{};
  PackedRgb colour_{};
  std::uint32_t spread_ = 0;
};

/// The pixel operation of fog.
struct Fogged {
  const Fog* fog = nullptr;

  /// A colour in fog of a known depth.
  template <class C>
  struct InFog : WrappedColour<C> {
    const Fog* fog;
    std::uint32_t share;  ///< 0...255

    [[nodiscard]] constexpr PackedRgb packed() const {
      const std::uint32_t of_256 = share + (share >> 7);
      return detail::by_channel(detail::packed_colour(this->colour), fog->colour(),
                                [of_256](std::uint32_t a, std::uint32_t b) {
                                  return (a * (256 - of_256) + b * of_256 + 128) >> 8;
                                });
    }
    [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t rgb565() const {
      return detail::joined(detail::mixed_spread(detail::spread(detail::colour565(this->colour)),
                                                 fog->spread_colour(), (share + 4) >> 3));
    }
  };

  /// A colour in fog whose depth is not known yet (DepthColour).
  template <class C>
  struct Result : WrappedColour<C> {
    const Fog* fog;

    [[nodiscard]] constexpr std::uint32_t alpha() const requires AlphaColour<C> {
      return this->colour.alpha();
    }
    [[nodiscard]] ARCSPAN_INLINE constexpr auto at_depth(std::uint32_t depth) const {
      if constexpr (DepthColour<C>) {
        const auto nearer = this->colour.at_depth(depth);
        return InFog<std::remove_const_t<decltype(nearer)>>{{nearer}, fog, fog->share(depth)};
      } else {
        return InFog<C>{{this->colour}, fog, fog->share(depth)};
      }
    }
    /// Without fog, for runs that have no depth.
    [[nodiscard]] constexpr PackedRgb packed() const { return detail::packed_colour(this->colour); }
  };

  template <class C>
  [[nodiscard]] ARCSPAN_INLINE constexpr auto operator()(const C& colour) const {
    static_assert(!BlendedColour<C>, "Opacity is the last operation");
    return Result<C>{{colour}, fog};
  }
};

}  // namespace arcspan
