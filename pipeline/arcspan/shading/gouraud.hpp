// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/pixel/fine_rgb.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/small_level.hpp>
#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

/// Gouraud shading: computes the full illumination per vertex and interpolates the colour linearly on the
/// screen.
template <class Illumination>
struct Gouraud {
  using Lighting = Illumination;
  struct Face {};
  using Vertex = DeepColour;
  using DrawsSmallTrianglesAs = Gouraud;
  struct Prepared {
    FullLinearPlane r;
    FullLinearPlane g;
    FullLinearPlane b;
    bool middle_left;
  };
  static constexpr bool kNeedsFaceNormal = false;

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return lighting.deep_colour(lighting.scalars(normal));
  }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static constexpr Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    const auto mix = [t](std::int32_t from, std::int32_t to) {
      return from + round_shift(wrap_mul(to - from, t.raw() >> 1), 14);
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
  }

  template <class Frame>
  static constexpr void prepare(const Lighting&, const Frame& frame, const Face&, Prepared& prepared) {
    const Vertex& top = frame.top->shade;
    const Vertex& middle = frame.middle->shade;
    const Vertex& bottom = frame.bottom->shade;
    make_plane(frame, top.r, middle.r, bottom.r, prepared.r);
    make_plane(frame, top.g, middle.g, bottom.g, prepared.g);
    make_plane(frame, top.b, middle.b, bottom.b, prepared.b);
    prepared.middle_left = frame.middle_left;
  }

  struct Run {
    FineRgb at;
    FineRgb step;

    [[nodiscard]] constexpr FineRgb colour(const Lighting&) const { return at; }
    constexpr void next() { at.advance(step); }
  };

  class Walker {
   public:
    using Run = Gouraud::Run;
    constexpr explicit Walker(Prepared& prepared) : p_(&prepared) {}
    [[nodiscard]] constexpr Run row(const RowStart& start) const {
      return {FineRgb::of(raw_bits(linear_at(p_->r, start)), raw_bits(linear_at(p_->g, start)),
                          raw_bits(linear_at(p_->b, start))),
              FineRgb::of(raw_bits(p_->r.dx), raw_bits(p_->g.dx), raw_bits(p_->b.dx))};
    }
    ARCSPAN_INLINE constexpr void next_row() {
      reload_from_memory(p_->r.left.at);
      reload_from_memory(p_->g.left.at);
      reload_from_memory(p_->b.left.at);
      p_->r.next_row();
      p_->g.next_row();
      p_->b.next_row();
    }
    constexpr void enter_lower() {
      p_->r.enter_lower(p_->middle_left);
      p_->g.enter_lower(p_->middle_left);
      p_->b.enter_lower(p_->middle_left);
    }

   private:
    Prepared* p_;
  };

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return draw(Walker(prepared));
  }

  /// The colour of a small triangle.
  struct Small {
    SmallLevel r;
    SmallLevel g;
    SmallLevel b;
  };
  /// The rows of a small triangle.
  struct SmallRows {
    using Run = Gouraud::Run;
    const Small& part;
    [[nodiscard]] ARCSPAN_INLINE constexpr Run row(std::int32_t, std::int32_t b, std::int32_t c) const {
      return {FineRgb::of(raw_bits(part.r.at(b, c)), raw_bits(part.g.at(b, c)), raw_bits(part.b.at(b, c))),
              FineRgb::of(raw_bits(part.r.step), raw_bits(part.g.step), raw_bits(part.b.step))};
    }
  };
  template <class Raster>
  [[nodiscard]] static constexpr bool prepare_small(const Lighting&, const Raster& top, const Raster& middle,
                                                    const Raster& bottom, const Face&,
                                                    const SmallTriangle& triangle, Small& part) {
    const Vertex& a = top.shade;
    const Vertex& b = middle.shade;
    const Vertex& c = bottom.shade;
    part.r.prepare(a.r, b.r, c.r, kHalf, triangle);
    part.g.prepare(a.g, b.g, c.g, kHalf, triangle);
    part.b.prepare(a.b, b.b, c.b, kHalf, triangle);
    return true;
  }
  template <class Draw>
  [[nodiscard]] static constexpr Status walk_small(const Small& part, Draw&& draw) {
    return draw(SmallRows{part});
  }

 private:
  /// Half an 8-bit step, so that dropping bits rounds. It is larger than the errors of a plane and of a
  /// SmallLevel, so no value leaves 0...256 8-bit steps and no pixel is clamped.
  static constexpr auto kHalf = FullLinear::from_raw(std::int32_t{1} << (FineRgb::kFraction - 1));
  [[nodiscard]] static constexpr std::uint32_t raw_bits(FullLinear value) {
    return static_cast<std::uint32_t>(value.raw());
  }
  template <class Frame>
  static constexpr void make_plane(const Frame& frame, std::int32_t top, std::int32_t middle,
                                   std::int32_t bottom, FullLinearPlane& plane) {
    make_linear_plane(frame, top, middle, bottom, plane);
    plane.left.at += kHalf;
    plane.lower.at += kHalf;
  }
};

}  // namespace arcspan
