// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/triangle_light.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/surface/order.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

/// `Arc` on textures under grey light. A triangle whose N·L is linear, and that no highlight reaches, is lit
/// as by GreyGouraud: texels are multiplied by the level of diffuse light, interpolated between the vertices,
/// without a look-up per pixel. Small triangles are drawn as by Arc.
template <class Illumination>
struct LevelArc : Arc<Illumination> {
  using Surface = Arc<Illumination>;
  using Level = GreyGouraud<Illumination>;
  using typename Surface::Face;
  using typename Surface::Vertex;
  using DrawsSmallTrianglesAs = LevelArc;
  struct Prepared {
    union {
      typename Surface::Prepared surface;
      typename Level::Prepared level;
    };
    bool has_levels;
  };

  /// Returns true and sets the levels of a triangle that has them; otherwise prepares its surface.
  template <class Lighting, class Frame>
  [[nodiscard]] static constexpr bool find_levels(const Lighting& lighting, const Frame& frame, const Face&,
                                                  Prepared& prepared, CornerLevels& levels) {
    const bool may_bend = Surface::is_bendable(frame);
    SurfaceChoice choice =
        choose_order(lighting, frame.top->shade, frame.middle->shade, frame.bottom->shade, may_bend);
    prepared.has_levels = false;
    if (choice.order == SurfaceOrder::kLinear && choice.light.reach != LightReach::kHighlight) {
      prepared.has_levels =
          set_levels(lighting, choice, frame.top->shade, frame.middle->shade, frame.bottom->shade, levels);
      if (prepared.has_levels) return true;
      choice.order = round_order(choice, may_bend);
    }
    Surface::prepare(lighting, frame, choice, prepared.surface);
    return false;
  }
  [[nodiscard]] static constexpr bool has_levels(const Prepared& prepared) { return prepared.has_levels; }
  /// Prepares a triangle that has levels, if they are not stepped with u and v.
  template <class Frame>
  static constexpr void prepare_levels(const Frame& frame, const CornerLevels& levels, Prepared& prepared) {
    Level::prepare_levels(frame, levels, prepared.level);
  }
  template <class Draw>
  [[nodiscard]] ARCSPAN_INLINE static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if (prepared.has_levels) return Level::walk(prepared.level, draw);
    return Surface::template walk<false>(prepared.surface, draw);
  }

 private:
  /// Sets the levels at the vertices. Returns false if they do not describe the light: N·L is negative at a
  /// vertex, the light is in toon steps, or only a part of the triangle has more than full light.
  template <class Lighting>
  [[nodiscard]] static constexpr bool set_levels(const Lighting& lighting, const SurfaceChoice& choice,
                                                 const Vertex& top, const Vertex& middle,
                                                 const Vertex& bottom, CornerLevels& levels) {
    constexpr std::int32_t kFullLevel = 65280;
    constexpr std::int32_t kSlack = 256;  // a step of 255: lift makes scalars a little larger
    const Cosine a = Surface::diffuse(lighting, choice, top);
    const Cosine b = Surface::diffuse(lighting, choice, middle);
    const Cosine c = Surface::diffuse(lighting, choice, bottom);
    const LinearLevel level = lighting.linear_level();
    if (choice.light.reach == LightReach::kDiffuse && !level.is_gradual) return false;
    if ((a.raw() | b.raw() | c.raw()) < 0) return false;
    levels = {{level.at(a), level.at(b), level.at(c)}};
    int full = 0;
    bool exceeds = false;
    for (std::int32_t& at : levels.at) {
      if (at < kFullLevel) continue;
      if (at > kFullLevel + kSlack) exceeds = true;
      at = kFullLevel;
      ++full;
    }
    return full == 3 || !exceeds;
  }
};

}  // namespace arcspan
