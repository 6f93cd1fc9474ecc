// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/small_level.hpp>
#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The levels of light at the top, middle and bottom vertex of a triangle, 0...65280.
struct CornerLevels {
  std::int32_t at[3];
};

/// Gouraud shading of one channel, for textures under grey light: computes the full illumination per vertex
/// and interpolates its green channel, which stands for all three.
template <class Illumination>
struct GreyGouraud {
  using Lighting = Illumination;
  struct Face {};
  struct Vertex {
    std::int32_t level;  ///< 0...65280, in 256ths of an 8-bit step
  };
  using DrawsSmallTrianglesAs = GreyGouraud;
  struct Prepared {
    FullLinearPlane level;
    bool middle_left;
  };
  static constexpr bool kNeedsFaceNormal = false;

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return {lighting.deep_colour(lighting.scalars(normal)).g};
  }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static constexpr Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    return {a.level + round_shift(wrap_mul(b.level - a.level, t.raw() >> 1), 14)};
  }

  /// Sets the levels of light at the vertices.
  template <class Frame>
  [[nodiscard]] static constexpr bool find_levels(const Lighting&, const Frame& frame, const Face&, Prepared&,
                                                  CornerLevels& levels) {
    levels = {{frame.top->shade.level, frame.middle->shade.level, frame.bottom->shade.level}};
    return true;
  }
  [[nodiscard]] static constexpr bool has_levels(const Prepared&) { return true; }
  template <class Frame>
  static constexpr void prepare(const Lighting&, const Frame& frame, const Face&, Prepared& prepared) {
    prepare_levels(frame, {{frame.top->shade.level, frame.middle->shade.level, frame.bottom->shade.level}},
                   prepared);
  }
  template <class Frame>
  static constexpr void prepare_levels(const Frame& frame, const CornerLevels& levels, Prepared& prepared) {
    make_linear_plane(frame, levels.at[0], levels.at[1], levels.at[2], prepared.level);
    prepared.level.left.at += kHalf;
    prepared.level.lower.at += kHalf;
    prepared.middle_left = frame.middle_left;
  }

  /// The pixels of a row (PixelRun, LightRun).
  class Run {
   public:
    constexpr Run(FullLinear at, FullLinear step)
        : at_(static_cast<std::uint32_t>(at.raw())), step_(static_cast<std::uint32_t>(step.raw())) {}

    [[nodiscard]] constexpr PackedRgb colour(const Lighting&) const {
      return PackedRgb::grey(packed_level());
    }
    [[nodiscard]] constexpr PixelLight light(const Lighting& lighting) const {
      return {colour(lighting), {}};
    }
    /// The level as 0...64, rounded.
    [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t light_factor() const { return at_ & 0xFE000000u; }
    ARCSPAN_INLINE constexpr void next() { at_ += step_; }

   private:
    /// The level as a channel of PackedRgb: with half an 8-bit step instead of half a grey_level().
    [[nodiscard]] constexpr std::uint32_t packed_level() const {
      return (at_ - static_cast<std::uint32_t>(kHalf.raw()) + (std::uint32_t{1} << 22)) >> 21;
    }
    std::uint32_t at_;  ///< 8-bit steps with 23 fraction bits, and half a grey_level()
    std::uint32_t step_;
  };

  class Walker {
   public:
    using Run = GreyGouraud::Run;
    constexpr explicit Walker(Prepared& prepared) : p_(&prepared) {}
    [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
      return Run(linear_at(p_->level, start), p_->level.dx);
    }
    ARCSPAN_INLINE constexpr void next_row() { p_->level.next_row(); }
    constexpr void enter_lower() { p_->level.enter_lower(p_->middle_left); }

   private:
    Prepared* p_;
  };

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return draw(Walker(prepared));
  }

  using Small = SmallLevel;
  /// The rows of a small triangle.
  struct SmallRows {
    using Run = GreyGouraud::Run;
    const Small& level;
    [[nodiscard]] ARCSPAN_INLINE constexpr Run row(std::int32_t, std::int32_t b, std::int32_t c) const {
      return Run(level.at(b, c), level.step);
    }
  };
  template <class Raster>
  [[nodiscard]] ARCSPAN_INLINE static constexpr bool prepare_small(const Lighting&, const Raster& top,
                                                                   const Raster& middle, const Raster& bottom,
                                                                   const Face&, const SmallTriangle& triangle,
                                                                   Small& part) {
    part.prepare(top.shade.level, middle.shade.level, bottom.shade.level, kHalf, triangle);
    return true;
  }
  template <class Draw>
  [[nodiscard]] static constexpr Status walk_small(const Small& part, Draw&& draw) {
    return draw(SmallRows{part});
  }

 private:
  static constexpr FullLinear kHalf = FullLinear::from_raw(std::int32_t{1} << 24);  ///< half of a 64th of 256
};

}  // namespace arcspan
