// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/one_colour.hpp>
#include <arcspan/shading/unlit.hpp>

#include <concepts>
#include <cstdint>

namespace arcspan {

/// How much nearer lines and points are drawn than they are, in units of the 16-bit depth. A line has the
/// depth of its own points, a pixel of a surface that of the pixel's centre: without a bias, a surface hides
/// about half of the pixels of its edges. It shows an edge wherever the surface's depth changes by less than
/// twice the bias per pixel.
struct DepthBias {
  static constexpr std::uint16_t kDefault = 256;

  std::uint16_t units = kDefault;
};

/// A shading method that draws the edges of triangles as lines of one colour instead of their areas:
///
///     draw_mesh<Wireframe<>>(mesh, transform, Wireframe<>::Lighting(Unlit::lighting(white)), frame, depth);
///
/// Front faces only, or all faces with DrawOptions::two_sided. `Colour` is Unlit, with operations or without.
/// An edge of two faces is drawn by both, with equal depth: with a depth buffer the second one changes
/// nothing, not even where lines are blended.
template <OneColour Colour = Unlit>
struct Wireframe : Colour {
  static constexpr bool kDrawsEdges = true;

  /// The lighting of `Colour` with the bias.
  struct Lighting : Colour::Lighting {
    using Base = typename Colour::Lighting;
    constexpr Lighting() = default;
    constexpr explicit Lighting(const Base& colour, DepthBias nearer = {}) : Base(colour), bias(nearer) {}
    /// Changes the bias, or another part of the material (PreparedMaterial::with).
    constexpr void set(DepthBias nearer) { bias = nearer; }
    template <class Part>
    requires requires(Base& base, const Part& part) { {base.set(part)}; }
    constexpr void set(const Part& part) { Base::set(part); }

    DepthBias bias;
  };
};

}  // namespace arcspan
