// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/dark_walker.hpp>
#include <arcspan/shading/arc/small_arc.hpp>
#include <arcspan/shading/patch/patch_limits.hpp>
#include <arcspan/shading/patch/small_patch.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// Returns the squared chords of the edges of a triangle a, b, c whose vertices are sorted by height.
[[nodiscard]] constexpr TriangleChords chords_between(const Normal& a, const Normal& b, const Normal& c) {
  return {squared_chord(a, b), squared_chord(a, c), squared_chord(b, c)};
}

/// The squared chord of 27 degrees, 28 fraction bits: up to there values of a SmallPatch with 16 fraction
/// bits differ by less than a half.
inline constexpr std::uint32_t kWidestSmallPatch = 58515427u;

/// The scalars of a triangle that no light reaches: N·L = 0.
template <class Lighting>
struct SmallDark {
  using Run = PatchRun<Lighting, 1>;
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(std::int32_t, std::int32_t, std::int32_t) const {
    return dark_run<Lighting>();
  }
};

/// SmallShading of a method that has no surface of its own.
struct NoSmallSurface {};

/// The part of `Arc` of a small triangle: darkness, a patch or arcs, of all scalars or of N·L alone. `Own` is
/// a further surface, of a method on top of `Arc`.
template <class Lighting, class Own = NoSmallSurface>
class SmallShading {
 public:
  /// The diffuse_scalar() of the vertices, if the triangle can be drawn by it.
  struct Diffuse {
    bool suffices;
    Cosine a;
    Cosine b;
    Cosine c;
  };
  /// Returns true if no light reaches a triangle with these scalars at its vertices. With all N·L of one sign
  /// at the vertices, they have it everywhere.
  template <class Scalars>
  [[nodiscard]] static constexpr bool is_dark([[maybe_unused]] const Scalars& a,
                                              [[maybe_unused]] const Scalars& b,
                                              [[maybe_unused]] const Scalars& c) {
    if constexpr (!Lighting::kHasRamp) {
      return false;
    } else {
      for (std::size_t i = 0; i < Lighting::kLights; ++i) {
        if (a[i].raw() > 0 || b[i].raw() > 0 || c[i].raw() > 0) return false;
      }
      return true;
    }
  }
  /// Prepares a triangle that is_dark(). Returns false if it is not.
  template <class Scalars>
  [[nodiscard]] constexpr bool prepare_dark(const Scalars& a, const Scalars& b, const Scalars& c) {
    path_ = Path::kDark;
    return is_dark(a, b, c);
  }

  /// Takes the method's own surface and returns it, to be prepared.
  [[nodiscard]] constexpr Own& take_own() requires(Lighting::kHasRamp) {
    path_ = Path::kOwn;
    return own_;
  }

  /// Returns a sharper lower bound of the highlight's half distance if `nearest`, that of
  /// nearest_highlight(), is below `far`. Whether it exceeds `reach` is what matters. Not of patches, which
  /// gain less than the bound costs.
  template <class Raster>
  [[nodiscard]] static constexpr std::int32_t sharper_nearest(const Lighting& lighting, std::int32_t nearest,
                                                              std::int32_t reach, std::int32_t far,
                                                              const SmallCorners<Raster>& at,
                                                              const TriangleChords& chords) {
    if (nearest >= far) return nearest;
    const std::uint32_t widest = chords.widest();
    if (is_accurate_patch(chords, widest, lighting.widest_patch())) return nearest;
    const std::int32_t sharper =
        lighting.nearest_highlight_between(reach, at.a.shade.scalars, at.b.shade.scalars, at.c.shade.scalars,
                                           chords.top_middle, chords.top_bottom, chords.middle_bottom);
    return sharper > nearest ? sharper : nearest;
  }

  /// Returns the `is_allowed` of diffuse_of() for errors up to kPatchError.
  [[nodiscard]] static constexpr auto within_patch_error(const Lighting& lighting) {
    return [&]([[maybe_unused]] std::uint32_t error) {
      if constexpr (Lighting::kHasRamp) return error * lighting.most_ramp() <= kPatchError << 20;
      return false;
    };
  }
  /// `widest`: the widest squared chord; `shines`: true if a highlight is within reach; `is_allowed`: tells
  /// whether N·L of a patch beyond kWidestDiffusePatch may have an error (20 fraction bits).
  template <class Raster, class IsAllowed>
  [[nodiscard]] static constexpr Diffuse diffuse_of(const Lighting& lighting, const SmallCorners<Raster>& at,
                                                    std::uint32_t widest, bool shines,
                                                    const IsAllowed& is_allowed) {
    if constexpr (Lighting::kHasRamp) {
      const auto& a = at.a.shade.scalars;
      const auto& b = at.b.shade.scalars;
      const auto& c = at.c.shade.scalars;
      const auto may_be_patch = [&](Cosine p, Cosine q, Cosine r) {
        return widest <= kWidestDiffusePatch ||
               (widest <= kWidestArc && is_allowed(wide_patch_error(p, q, r, widest)));
      };
      if constexpr (Lighting::kLights == 1) {
        if (!shines && may_be_patch(a[0], b[0], c[0])) return {true, a[0], b[0], c[0]};
      } else {
        std::uint32_t lit = 0;
        if (!shines && lighting.lit_throughout(a, b, c, lit)) {
          const Diffuse diffuse{true, lighting.diffuse_scalar(a, lit), lighting.diffuse_scalar(b, lit),
                                lighting.diffuse_scalar(c, lit)};
          if (may_be_patch(diffuse.a, diffuse.b, diffuse.c)) return diffuse;
        }
      }
    }
    return {};
  }

  /// Prepares the triangle; `shines` is true if a highlight is within reach. Returns false if the normals are
  /// more than 60 degrees apart, .
  template <class Raster>
  [[nodiscard]] constexpr bool prepare(const Lighting& lighting, const SmallCorners<Raster>& at,
                                       const TriangleChords& chords, bool shines, const Diffuse& diffuse,
                                       const SmallTriangle& triangle) {
    const std::uint32_t widest = chords.widest();
    if (widest > kWidestArc) return false;
    if constexpr (Lighting::kHasRamp) {
      if (diffuse.suffices) {
        path_ = Path::kDiffusePatch;
        const auto scalar = [](Cosine value) { return std::array<Cosine, 1>{value}; };
        diffuse_patch_.prepare(scalar(diffuse.a), scalar(diffuse.b), scalar(diffuse.c), chords, triangle);
        return true;
      }
    }
    if constexpr (kHasDiffuseArc) {
      if (!shines && lighting.lights() == 1) {
        path_ = Path::kDiffuseArc;
        diffuse_arc_.prepare(at, chords, triangle);
        return true;
      }
    }
    const bool is_accurate = is_accurate_patch(chords, widest, lighting.widest_patch());
    path_ = is_accurate && widest <= kWidestSmallPatch ? Path::kPatch : Path::kArc;
    if (path_ == Path::kPatch) {
      patch_.prepare(at.a.shade.scalars, at.b.shade.scalars, at.c.shade.scalars, chords, triangle);
    } else {
      arc_.prepare(at, chords, triangle);
    }
    return true;
  }

  /// Calls `draw` with the surface and returns its status.
  template <class Draw>
  [[nodiscard]] constexpr Status walk(Draw&& draw) const {
    if constexpr (Lighting::kHasRamp) {
      if (path_ == Path::kDark) return draw(SmallDark<Lighting>{});
      if constexpr (!std::is_same_v<Own, NoSmallSurface>) {
        if (path_ == Path::kOwn) return draw(own_);
      }
      if (path_ == Path::kDiffusePatch) return draw(diffuse_patch_);
    }
    if constexpr (kHasDiffuseArc) {
      if (path_ == Path::kDiffuseArc) return draw(diffuse_arc_);
    }
    return path_ == Path::kPatch ? draw(patch_) : draw(arc_);
  }

 private:
  /// Returns an estimate of the error of N·L, with these values at the vertices, as a patch up to 60 degrees,
  /// 20 fraction bits: with s the widest squared chord, 0.022 s of the values' range and 0.0073 s^2 of the
  /// largest. The patch differs from bilinear SLERP by at most 1.57 times that, where negative N·L counts as
  /// 0, and by more than the estimate only in rare shapes (decision 26).
  [[nodiscard]] static constexpr std::uint32_t wide_patch_error(Cosine a, Cosine b, Cosine c,
                                                                std::uint32_t widest) {
    const auto larger = [](std::int32_t p, std::int32_t q) { return p > q ? p : q; };
    const auto smaller = [](std::int32_t p, std::int32_t q) { return p < q ? p : q; };
    const std::int32_t most = larger(0, larger(a.raw(), larger(b.raw(), c.raw()))) >> 15;
    const std::int32_t least = smaller(a.raw(), smaller(b.raw(), c.raw())) >> 15;
    const std::uint32_t s = widest >> 13;  // 15 fraction bits, as `most` and `least`
    const std::uint32_t error = 180u * static_cast<std::uint32_t>(most - least) +
                                60u * ((s * static_cast<std::uint32_t>(most)) >> 15);  // 28 fraction bits
    return (s * (error >> 10)) >> 13;
  }
  static constexpr bool kHasDiffuseArc = [] {
    if constexpr (Lighting::kHasRamp) return kMayHaveOneLight<Lighting>;
    return false;
  }();
  enum class Path : std::uint8_t { kPatch, kDiffusePatch, kArc, kDiffuseArc, kDark, kOwn };

  union {
    SmallPatch<Lighting, 1, 15> diffuse_patch_;
    SmallPatch<Lighting, Lighting::kScalars, 16> patch_;
    SmallArc<Lighting, 1> diffuse_arc_;
    SmallArc<Lighting, Lighting::kScalars> arc_;
    Own own_;
  };
  Path path_;
};

}  // namespace arcspan
