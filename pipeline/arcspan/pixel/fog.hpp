// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/pixel_operation.hpp>
#include <arcspan/pixel/spread_rgb565.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

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

/// Fog: the share of its colour grows linearly with the distance, from 0 at `start` to 1 at `end`. Each
/// pixel has the share of its depth, which is right on large triangles too. Fog needs a depth buffer.
///
/// Depths are divided into layers of equal share, in steps of 1/128, for 5-6-5 pixels of 1/32. Rows are
/// drawn in pieces that lie within a layer, where fog is a constant.
///
/// Made once per camera, which takes 23,000 instructions on a Cortex-M3; the colour may change in each
/// frame. An operation refers to it, so it must outlive drawing.
class Fog {
 public:
  static constexpr std::uint32_t kFull = 128;  ///< the share of fog that hides everything

  /// No fog.
  constexpr Fog() {
    for (std::uint32_t share = 1; share < kFull + 3; ++share) first(share) = kNever;
  }

  /// Returns kInvalidArgument, and does not change `fog`, if the range is not as FogRange states.
  static constexpr Status make(const FogRange& range, Rgb8 colour, Fog& fog) {
    if (range.near_plane <= 0 || range.near_plane >= range.far_plane || range.start >= range.end) {
      return Status::kInvalidArgument;
    }
    for (std::uint32_t share = 1; share <= kFull; ++share)
      fog.first(share) = first_depth_at(range, distance_of(range, share));
    fog.set_colour(colour);
    return Status::kOk;
  }

  /// Another colour at the same distances, as at nightfall. Takes a few instructions.
  constexpr void set_colour(Rgb8 colour) {
    colour_ = PackedRgb::of(colour);
    spread_ = detail::spread(detail::colour565(colour_));
  }
  [[nodiscard]] constexpr PackedRgb colour() const { return colour_; }
  /// The colour as a spread 5-6-5 pixel.
  [[nodiscard]] constexpr std::uint32_t spread_colour() const { return spread_; }

  /// The share of the fog at a depth, 0...kFull. Against the distance of that depth it is off by at most
  /// 1.5/255 if far_plane is at most 1000 near_plane, and end - start at least 1/1000 of `end`.
  [[nodiscard]] constexpr std::uint32_t share(std::uint16_t depth) const { return layer<kFull>(depth); }

  /// The layer of a depth, 0...Layers: the share in steps of 1/Layers. Layers is kFull or kFull / 4.
  template <std::uint32_t Layers>
  [[nodiscard]] constexpr std::uint32_t layer(std::int32_t depth) const {
    return depth >= first_depth<Layers>(Layers) ? Layers : layer_from<Layers, Layers / 2>(0, depth);
  }
  /// The first depth of a layer, 0...Layers + 1: half a step before its share is reached, so that shares are
  /// rounded; 5/8 of a step with fewer layers than kFull.
  template <std::uint32_t Layers>
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t first_depth(std::uint32_t layer) const {
    constexpr std::uint32_t kStep = kFull / Layers;
    static_assert(kStep == 1 || kStep / 2 == kBefore);
    const std::uint32_t entry = kBefore - kStep / 2 + layer * kStep;
    return firsts_[static_cast<std::size_t>(entry)];
  }

 private:
  static constexpr std::int32_t kNearest = 256;  ///< depths of the planes: ClipTransform::kDepthMargin
  static constexpr std::int32_t kSpan = 65535 - 2 * kNearest;
  static constexpr std::uint16_t kNever = 65535;
  static constexpr std::uint32_t kBefore = 2;  ///< entries before that of share 0, for first_depth()

  /// The layer of a depth, one of the 2 Step layers from `from` on: by halves, without a loop.
  template <std::uint32_t Layers, std::uint32_t Step>
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t layer_from(std::uint32_t from,
                                                                  std::int32_t depth) const {
    if (depth >= first_depth<Layers>(from + Step)) from += Step;
    if constexpr (Step == 1) {
      return from;
    } else {
      return layer_from<Layers, Step / 2>(from, depth);
    }
  }
  [[nodiscard]] constexpr std::uint16_t& first(std::uint32_t share) {
    const std::uint32_t entry = kBefore + share;
    return firsts_[static_cast<std::size_t>(entry)];
  }
  /// The distance from which a share is the nearest one, 8 fraction bits.
  [[nodiscard]] static constexpr std::int64_t distance_of(const FogRange& range, std::uint32_t share) {
    const std::int64_t halves = 2 * std::int64_t{share} - 1;
    return std::int64_t{range.start} * 256 + (std::int64_t{range.end} - range.start) * halves;
  }
  /// The first depth at a distance of 8 fraction bits or beyond.
  [[nodiscard]] static constexpr std::uint16_t first_depth_at(const FogRange& range, std::int64_t distance) {
    const std::int64_t nearest = std::int64_t{range.near_plane} << 8;
    const std::int64_t farthest = std::int64_t{range.far_plane} << 8;
    if (distance <= nearest) return 0;
    if (distance > farthest) return kNever;
    // By ClipTransform::depth(): 256 + 65023 (1 - near / w) / (1 - near / far). Thin fog needs many bits.
    int bits = 40;
    while (!range.orthographic && nearest >> (62 - bits) != 0) --bits;
    const auto beyond = [&](std::int64_t w) {
      return range.orthographic ? w - nearest : (std::int64_t{1} << bits) - (nearest << bits) / w;
    };
    const std::int64_t all = beyond(farthest);
    return static_cast<std::uint16_t>(kNearest + (beyond(distance) * kSpan + all - 1) / all);
  }

  /// Entry kBefore + n is the first depth whose share is at least n/128.
  std::array<std::uint16_t, kBefore + kFull + 3> firsts_{};
  PackedRgb colour_{};
  std::uint32_t spread_ = 0;
};

/// The pixel operation of fog.
struct Fogged {
  const Fog* fog = nullptr;

  template <class C>
  struct Result;

  /// The fog in a layer, for 5-6-5 pixels or for a PackedRgb.
  struct Constant {
    std::uint32_t rest;  ///< the share of the surface: 0...32, or 0...Fog::kFull
    std::uint32_t part;  ///< the fog's spread colour times its share, plus half a step; or its colour

    template <class C>
    [[nodiscard]] ARCSPAN_INLINE constexpr auto operator()(const C& surface) const {
      static_assert(!BlendedColour<C>, "Opacity is the last operation");
      return Result<C>{{surface}, *this};
    }
  };

  /// A surface in fog. Only one of packed() and rgb565() is right: that for which its Constant was made.
  template <class C>
  struct Result : WrappedColour<C> {
    Constant fog;

    [[nodiscard]] constexpr std::uint32_t alpha() const requires AlphaColour<C> {
      return this->colour.alpha();
    }
    [[nodiscard]] constexpr PackedRgb packed() const {
      return detail::by_channel(
          detail::packed_colour(this->colour), PackedRgb{fog.part}, [this](std::uint32_t a, std::uint32_t b) {
            return (a * fog.rest + b * (Fog::kFull - fog.rest) + Fog::kFull / 2) / Fog::kFull;
          });
    }
    [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t rgb565() const {
      const std::uint32_t surface = detail::spread(detail::colour565(this->colour));
      return detail::joined(((surface * fog.rest + fog.part) >> 5) & detail::kSpreadMask);
    }
  };

  /// The layer that pixels of a triangle are in.
  class Layer {
   public:
    constexpr Layer() {}  // not trivial, or compilers would call memset for the object

    /// Enters the layer of a pixel of depth `z`, the first of `left` in a row. Returns how many of them, at
    /// least one, are in it, and sets the fog there.
    template <bool As565>
    [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t enter(const Fogged& operation, Linear z, Linear dz,
                                                              std::int32_t left, Constant& here) {
      // Hidden, or gcc would share a shift with the loop over pixels, which then takes two instructions.
      const Linear first = Linear::from_raw(hidden(z.raw()));
      if (!holds(first) || !holds(behind(first, dz, left - 1)))
        left = find_and_count<As565>(*operation.fog, first, dz, left);
      here = here_;
      return left;
    }

   private:
    [[nodiscard]] ARCSPAN_INLINE static constexpr Linear behind(Linear z, Linear dz, std::int32_t pixels) {
      return z + Linear::from_raw(wrap_mul(dz.raw(), pixels));
    }
    [[nodiscard]] ARCSPAN_INLINE constexpr bool holds(Linear z) const {
      return static_cast<std::uint32_t>(depth_of(z) - first_) < thickness_;
    }
    /// enter() where the layer is another one, or ends within the row.
    template <bool As565>
    [[nodiscard]] ARCSPAN_OUTLINE constexpr std::int32_t find_and_count(const Fog& layers, Linear z,
                                                                        Linear dz, std::int32_t left) {
      if (!holds(z)) find<As565>(layers, depth_of(z));
      if (holds(behind(z, dz, left - 1))) return left;
      std::int32_t count = 1;
      std::int32_t step = 1;
      for (; count + step < left && holds(behind(z, dz, count + step - 1)); step *= 2) count += step;
      for (; step != 0; step /= 2) {
        if (count + step < left && holds(behind(z, dz, count + step - 1))) count += step;
      }
      return count;
    }
    /// Sets the layer of a depth.
    template <bool As565>
    ARCSPAN_INLINE constexpr void find(const Fog& layers, std::int32_t depth) {
      constexpr std::uint32_t kLayers = As565 ? Fog::kFull / 4 : Fog::kFull;
      const std::uint32_t found = layers.layer<kLayers>(depth);
      first_ = layers.first_depth<kLayers>(found);
      thickness_ = static_cast<std::uint32_t>(layers.first_depth<kLayers>(found + 1) - first_);
      const std::uint32_t part =
          As565 ? layers.spread_colour() * found + detail::kSpreadHalf : layers.colour().lanes;
      here_ = {kLayers - found, part};
    }

    std::int32_t first_ = 0;       ///< depth
    std::uint32_t thickness_ = 0;  ///< in depths; 0 before the first pixel
    Constant here_;                ///< set with thickness_
  };
  /// The fog of a row, which Layer::enter() sets before its first pixel.
  [[nodiscard]] ARCSPAN_INLINE static constexpr Constant in_row(std::int32_t, std::int32_t) { return {}; }

  /// The fog at a depth, in front of a colour that becomes a 5-6-5 pixel without dither (`As565`), or a
  /// PackedRgb.
  template <bool As565>
  [[nodiscard]] constexpr Constant at_depth(std::uint16_t depth) const {
    Layer layer;
    Constant here{};
    (void)layer.enter<As565>(*this, Linear::from_raw(std::int32_t{depth} << Linear::kFraction), {}, 1, here);
    return here;
  }
};

}  // namespace arcspan
