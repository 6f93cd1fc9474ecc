// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/fog.hpp>
#include <arcspan/pixel/pixel_operation.hpp>
#include <arcspan/shading/textured/texel_light.hpp>
#include <arcspan/span/draw_pixels.hpp>

#include <cstdint>

// The pixel operations of the library, chosen at run time. A method with SurfaceOperation passes all that is
// known of a pixel to the sink (SurfacePixel); the sink, which knows the pixel format, applies the library's
// operations to it. So one instantiation of a method serves all combinations, and their pixels are those of
// firmware that names the combination at compile time.
namespace arcspan::tools {

/// How a surface shows what is behind it.
enum class Transparency : std::uint8_t { kNone, kAlpha, kAdd, kMultiply, kScreenDoor };

/// Whether surfaces of this kind are mixed with what was drawn before them, so that they are to be drawn last
/// and without writing depths.
[[nodiscard]] constexpr bool is_blended(Transparency kind) {
  return kind == Transparency::kAlpha || kind == Transparency::kAdd || kind == Transparency::kMultiply;
}

struct SurfaceOperation;

/// A pixel of a surface before its operations (PackableColour).
struct SurfacePixel {
  PackedRgb colour;
  std::uint16_t pixel = 0;     ///< the colour as a 5-6-5 pixel
  std::uint16_t depth = 0;     ///< of the surface
  std::uint32_t opacity = 16;  ///< of its texel, 0...16
  const SurfaceOperation* operation = nullptr;

  [[nodiscard]] constexpr PackedRgb packed() const { return colour; }
  [[nodiscard]] constexpr std::uint16_t rgb565() const { return pixel; }
  [[nodiscard]] constexpr std::uint32_t alpha() const { return opacity; }
};

/// The operation of a method that is drawn into a SurfaceSink.
struct SurfaceOperation {
  const Fog* fog = nullptr;
  Transparency transparency = Transparency::kNone;
  std::uint8_t opacity = 32;  ///< 0...32; of ScreenDoor 0...8
  bool is_textured = false;   ///< false if the texture is there only because the method has one
  bool grey_light = false;    ///< as TexelLight::kGrey

  /// A colour before it is a SurfacePixel.
  template <class C>
  struct Result {
    C colour;
    const SurfaceOperation* operation;
    std::uint16_t depth;

    [[nodiscard]] bool covers(std::int32_t x, std::int32_t y) const {
      if (is_blended(operation->transparency)) return share() != 0;
      if (texel_opacity() < 8) return false;
      return operation->transparency != Transparency::kScreenDoor ||
             ScreenDoor{operation->opacity}.in_row(x, y)(packed()).covers(x, y);
    }
    [[nodiscard]] SurfacePixel pixel() const {
      return {packed(), rgb565(), depth, texel_opacity(), operation};
    }
    [[nodiscard]] PackedRgb packed() const { return arcspan::detail::packed_colour(colour); }

   private:
    [[nodiscard]] std::uint32_t texel_opacity() const {
      if constexpr (AlphaColour<C>) return colour.alpha();
      return 16;
    }
    [[nodiscard]] std::uint32_t share() const { return (operation->opacity * texel_opacity() + 8) >> 4; }
    [[nodiscard]] std::uint16_t rgb565() const {
      if constexpr (requires {
                      colour.texel;
                      colour.shine;
                    }) {
        if (!operation->is_textured) return arcspan::detail::colour565(packed());
        if (operation->grey_light) {
          const PixelLight light(colour.light);
          const std::uint32_t factor = arcspan::detail::light_factor(grey_level(light.diffuse));
          return LitTexel<TexelLight::kGrey>(colour.texel, light, factor, colour.shine).rgb565();
        }
      }
      return arcspan::detail::colour565(colour);
    }
  };

  /// The operation on pixels of one depth.
  struct Constant {
    const SurfaceOperation* operation = nullptr;
    std::uint16_t depth = 0;

    template <class C>
    [[nodiscard]] auto operator()(const C& colour) const {
      return Result<C>{colour, operation, depth};
    }
  };
  [[nodiscard]] static Constant in_row(std::int32_t, std::int32_t) { return {}; }

  /// Every pixel is a layer of its own, because a SurfacePixel has a depth.
  struct Layer {
    template <bool As565>
    [[nodiscard]] static std::int32_t enter(const SurfaceOperation& operation, Linear z, Linear, std::int32_t,
                                            Constant& here) {
      here = {&operation, depth_of(z)};
      return 1;
    }
  };
};

/// The pixel of a surface at (x, y) of the picture, over `below`, as the library draws it.
template <PixelFormat Format>
[[nodiscard]] typename Format::Encoded operated_pixel(const SurfacePixel& surface,
                                                      typename Format::Encoded below, std::int32_t x,
                                                      std::int32_t y) {
  const SurfaceOperation& operation = *surface.operation;
  const auto drawn = [&](const auto& colour) {
    return arcspan::detail::operated<Format>(colour, below, x, y);
  };
  const auto blended = [&](const auto& colour) {
    switch (operation.transparency) {
      case Transparency::kAlpha:
        return drawn(Opacity<Blend::kAlpha>{operation.opacity}(colour));
      case Transparency::kAdd:
        return drawn(Opacity<Blend::kAdd>{operation.opacity}(colour));
      case Transparency::kMultiply:
        return drawn(Opacity<Blend::kMultiply>{operation.opacity}(colour));
      case Transparency::kScreenDoor:  // covers() has chosen the pixels
      case Transparency::kNone:
        break;
    }
    return drawn(colour);
  };
  if (operation.fog == nullptr) return blended(surface);
  const Fogged fogged{operation.fog};
  return blended(fogged.at_depth<arcspan::detail::kOperates565<Format>>(surface.depth)(surface));
}

}  // namespace arcspan::tools
