// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/shading/literature/linear_normal.hpp>

namespace arcspan {

/// Classic Phong shading (S0 [2]), for comparison: the normal is interpolated linearly on the screen and
/// normalised at every pixel by a root and three divisions, then come the products with L, H or V and the
/// power. It divides in the span stage, which is what the other methods are there to avoid.
template <class Illumination>
struct Phong {
  using Lighting = Illumination;
  struct Face {};
  using Vertex = Direction;
  struct Prepared {
    NormalPlane normal;
    bool middle_left;
  };
  static constexpr bool kNeedsFaceNormal = false;

  [[nodiscard]] static Vertex shade_vertex(const Lighting&, const Direction& normal) { return normal; }
  [[nodiscard]] static constexpr Face shade_face(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    return between_normalised(a, b, t);
  }
  [[nodiscard]] static constexpr bool too_wide(const Vertex&, const Vertex&) { return false; }

  static constexpr void prepare(const Lighting&, const TriangleFrame<Phong>& frame, const Face&,
                                Prepared& prepared) {
    make_normal_plane(frame, frame.top->shade, frame.middle->shade, frame.bottom->shade, prepared.normal);
    prepared.middle_left = frame.middle_left;
  }

  struct Run {
    LinearNormal normal;
    LinearNormal step;

    [[nodiscard]] constexpr PackedRgb colour(const Lighting& lighting) const {
      return lighting.colour(lighting.scalars(normalised_by_division(normal)));
    }
    constexpr void next() { normal.advance(step); }

   private:
    /// n / |n|, 15 fraction bits a component; the zero vector stays zero.
    [[nodiscard]] static constexpr Direction normalised_by_division(const LinearNormal& n) {
      const std::int32_t x = round_shift(n.x.raw(), Linear::kFraction);
      const std::int32_t y = round_shift(n.y.raw(), Linear::kFraction);
      const std::int32_t z = round_shift(n.z.raw(), Linear::kFraction);
      const std::int32_t square = wrap_add(wrap_add(wrap_mul(x, x), wrap_mul(y, y)), wrap_mul(z, z));
      const auto root = static_cast<std::int32_t>(nearest_root(static_cast<std::uint32_t>(square)));
      const std::int32_t length = root + static_cast<std::int32_t>(root == 0);
      const auto divided = [length](std::int32_t c) {
        const std::int32_t half = c < 0 ? -(length >> 1) : length >> 1;
        return DirectionComponent::from_raw(wrap_add(wrap_shl(c, 15), half) / length);
      };
      return {divided(x), divided(y), divided(z)};
    }
  };

  class Walker {
   public:
    using Run = Phong::Run;
    static constexpr std::int32_t kLongestRun = 2 * kGuardBand;
    constexpr explicit Walker(Prepared& prepared) : p_(&prepared) {}
    [[nodiscard]] constexpr Run row(const RowStart& start) const {
      return {p_->normal.at(start), p_->normal.step()};
    }
    constexpr void next_row() { p_->normal.next_row(); }
    constexpr void enter_lower() { p_->normal.enter_lower(p_->middle_left); }

   private:
    Prepared* p_;
  };

  template <class Draw>
  [[nodiscard]] static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    return draw(Walker(prepared));
  }
};

}  // namespace arcspan
