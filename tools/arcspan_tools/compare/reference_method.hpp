// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/row_pixel.hpp>
#include <arcspan/shading/method.hpp>

#include <arcspan_tools/compare/reference.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {

/// The normal at the fraction t between a and b: S0 eq. 2 of unit vectors, or their chord, not normalised.
[[nodiscard]] inline Vec3 between_normals(ReferenceKind kind, Vec3 a, Vec3 b, double t) {
  const double angle = kind == ReferenceKind::kSlerp ? std::atan2(length(cross(a, b)), dot(a, b)) : 0;
  const double sine = std::sin(angle);
  if (sine < 1e-9) return a * (1 - t) + b * t;
  return a * (std::sin((1 - t) * angle) / sine) + b * (std::sin(t * angle) / sine);
}

/// A shading method like those of the pipeline, and driven by it, so that it colours exactly the same pixels;
/// but its normals and colours are doubles. Its colour() hands out the number of a sample.
struct ReferenceMethod {
  struct Lighting {
    ReferenceKind kind = ReferenceKind::kPhong;
    ReferenceIllumination illumination;
    std::vector<ReferenceSample>* samples = nullptr;
  };
  struct Face {};
  struct Vertex {
    Vec3 normal;
    ReferenceKind kind = ReferenceKind::kPhong;
  };
  /// A vertex on the screen, in pixels.
  struct Corner {
    double x = 0;
    double y = 0;
    Vec3 normal;
  };
  struct Prepared {
    Corner top;
    Corner middle;
    Corner bottom;
    double first_y = 0;  ///< of the first row's centres
    ReferenceKind kind = ReferenceKind::kPhong;
  };
  static constexpr bool kNeedsFaceNormal = false;

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return {normalised(to_vec3(normal)), lighting.kind};
  }
  [[nodiscard]] static Face shade_face(const Lighting&, const Direction&) { return {}; }
  [[nodiscard]] static Vertex between(const Vertex& a, const Vertex& b, Factor t) {
    return {between_normals(a.kind, a.normal, b.normal, std::ldexp(t.raw(), -Factor::kFraction)), a.kind};
  }

  static void prepare(const Lighting&, const TriangleFrame<ReferenceMethod>& frame, const Face&,
                      Prepared& prepared) {
    const auto corner = [](const RasterVertex<ReferenceMethod>& v) {
      return Corner{v.position.x / 16.0, v.position.y / 16.0, v.shade.normal};
    };
    prepared.top = corner(*frame.top);
    prepared.middle = corner(*frame.middle);
    prepared.bottom = corner(*frame.bottom);
    prepared.first_y = (frame.top->position.y + frame.long_edge.offset) / 16.0;
    prepared.kind = frame.top->shade.kind;
  }

  class Run {
   public:
    Run(ReferenceKind kind, Vec3 left, Vec3 right, double at, double step)
        : kind_(kind), left_(left), right_(right), at_(at), step_(step) {}

    [[nodiscard]] PackedRgb colour(const Lighting& lighting) const {
      const double t = std::clamp(at_, 0.0, 1.0);
      const Vec3 normal = normalised(between_normals(kind_, left_, right_, t));
      const LightLevels light = lighting.illumination.light(normal);
      lighting.samples->push_back({normal, light.reflected(), light});
      return {static_cast<std::uint32_t>(lighting.samples->size())};
    }
    void next() { at_ += step_; }

   private:
    ReferenceKind kind_;
    Vec3 left_;
    Vec3 right_;
    double at_;
    double step_;
  };

  class Walker {
   public:
    using Run = ReferenceMethod::Run;
    explicit Walker(Prepared& prepared) : triangle_(prepared), y_(prepared.first_y) {}

    [[nodiscard]] Run row(const RowStart& start) const {
      const Corner far = crossing(triangle_.top, triangle_.bottom);
      const Corner near =
          lower_ ? crossing(triangle_.middle, triangle_.bottom) : crossing(triangle_.top, triangle_.middle);
      const Corner& left = far.x <= near.x ? far : near;
      const Corner& right = far.x <= near.x ? near : far;
      const double width = std::max(right.x - left.x, 1e-6);
      const literature::RowPixel pixel = literature::row_pixel(start);
      const double inside = std::ldexp(pixel.inside, -pixel.bits);
      return {triangle_.kind, left.normal, right.normal, inside / width, 1 / width};
    }
    void next_row() { y_ += 1; }
    void enter_lower() { lower_ = true; }

   private:
    /// Where the row's centre line meets an edge.
    [[nodiscard]] Corner crossing(const Corner& from, const Corner& to) const {
      const double height = to.y - from.y;
      const double t = height > 0 ? std::clamp((y_ - from.y) / height, 0.0, 1.0) : 0;
      return {from.x + t * (to.x - from.x), y_, between_normals(triangle_.kind, from.normal, to.normal, t)};
    }

    Prepared triangle_;
    double y_;
    bool lower_ = false;
  };

  template <class Draw>
  [[nodiscard]] static Status walk(Prepared& prepared, Draw&& draw) {
    return draw(Walker(prepared));
  }
};

static_assert(ShadingMethod<ReferenceMethod>);

}  // namespace arcspan::tools
