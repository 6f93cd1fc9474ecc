// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/illumination.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/linear_walk.hpp>

namespace arcspan {

/// Gouraud shading: the full illumination at the vertices, colour linear on the screen.
template <class Illumination>
struct Gouraud {
  using Object = Illumination;
  struct Face {};
  using Vertex = DeepColour;
  struct Prepared {
    LinearPlane r;
    LinearPlane g;
    LinearPlane b;
    bool middle_left;
  };
  static constexpr bool kNeedsFaceNormal = false;

  [[nodiscard]] static Vertex shade_vertex(const Object& object, const Direction& normal) {
    return object.deep_colour(object.scalars(normal));
  }
  [[nodiscard]] static constexpr Face shade_face(const Object&, const Direction&) { return {}; }
  [[nodiscard]] static constexpr Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    const auto mix = [t](std::int32_t from, std::int32_t to) {
      return from + round_shift(wrap_mul(to - from, t.raw() >> 1), 14);
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
  }
  [[nodiscard]] static constexpr bool too_wide(const Vertex&, const Vertex&) { return false; }

  static constexpr void prepare(const Object&, const TriangleFrame<Gouraud>& frame, const Face&,
                                Prepared& prepared) {
    const Vertex& top = frame.top->shade;
    const Vertex& middle = frame.middle->shade;
    const Vertex& bottom = frame.bottom->shade;
    prepared.r = make_linear_plane(frame, top.r, middle.r, bottom.r);
    prepared.g = make_linear_plane(frame, top.g, middle.g, bottom.g);
    prepared.b = make_linear_plane(frame, top.b, middle.b, bottom.b);
    prepared.middle_left = frame.middle_left;
  }

  struct Run {
    Linear r;
    Linear g;
    Linear b;
    Linear dr;
    Linear dg;
    Linear db;

    [[nodiscard]] constexpr PackedRgb colour(const Object&) const {
      return PackedRgb::of(level(r), level(g), level(b));
    }
    constexpr void next() {
      r += dr;
      g += dg;
      b += db;
    }

   private:
    /// 8 and 2 bits, half a step added; gradients have errors, so that a value may leave 0...255 by a little.
    [[nodiscard]] static constexpr std::uint32_t level(Linear value) {
      constexpr int kDrop = Linear::kFraction + 6;
      const std::int32_t rounded = wrap_add(value.raw(), std::int32_t{1} << (kDrop + 1)) >> kDrop;
      return static_cast<std::uint32_t>(rounded < 0 ? 0 : rounded > 1023 ? 1023 : rounded);
    }
  };

  class Walker {
   public:
    using Run = Gouraud::Run;
    static constexpr std::int32_t kLongestRun = 2 * kGuardBand;
    constexpr explicit Walker(Prepared& prepared) : p_(&prepared) {}
    [[nodiscard]] constexpr Run row(const RowStart& start) const {
      return {linear_at(p_->r, start),
              linear_at(p_->g, start),
              linear_at(p_->b, start),
              p_->r.dx,
              p_->g.dx,
              p_->b.dx};
    }
    constexpr void next_row() {
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
};

}  // namespace arcspan
