// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/shading/textured/small_texture.hpp>
#include <arcspan/shading/textured/texel_light.hpp>
#include <arcspan/shading/textured/texel_sampling.hpp>
#include <arcspan/shading/textured/texture_row.hpp>
#include <arcspan/shading/textured/texture_triangle.hpp>
#include <arcspan/target.hpp>
#include <arcspan/texture/texture.hpp>

#include <cstdint>
#include <type_traits>

/// The pixels and the rows of textured triangles: their texels, each under the light of its pixel.
namespace arcspan {

/// The current pixel of a row of a textured triangle. `Lit` is the run of the method that lights it;
/// `Mapping` is LinearTexture or PerspectiveTexture.
template <class Lit, class Mapping, TexelFormat Texels, TexelLight Colours, TextureFilter Filter>
struct TexturedPixel {
  Lit light_run;
  Mapping mapping;
  const typename Texels::Word* words;  ///< of the mip level
  const std::uint16_t* palette;

  template <class Lighting>
  [[nodiscard]] ARCSPAN_INLINE constexpr auto colour(const Lighting& lighting) const {
    const SampledTexel shown = Filter == TextureFilter::kBilinear
                                   ? bilinear_texel<Texels>(words, palette, mapping.steps())
                                   : nearest_texel<Texels>(words, palette, mapping.steps());
    if constexpr (Texels::ColourFormat::kAlphaBits == 0) {
      return lit(lighting, shown.rgb565);
    } else {
      using Opaque = decltype(lit(lighting, shown.rgb565));
      constexpr bool kIsMask = Texels::ColourFormat::kAlphaBits == 1 && Filter == TextureFilter::kNearest;
      return AlphaTexel<Opaque, kIsMask>{lit(lighting, shown.rgb565), shown.opacity};
    }
  }
  ARCSPAN_INLINE constexpr void next() {
    mapping.next();
    if constexpr (Colours != TexelLight::kNone && !Mapping::kHasLevel) light_run.next();
  }
  [[nodiscard]] constexpr const auto& steps() const { return mapping.steps(); }

  /// A texel under the current pixel's light, given as its parts and as factor and shine. Compilers leave out
  /// what the pixel format does not take (LitTexel).
  template <class Lighting>
  [[nodiscard]] ARCSPAN_INLINE constexpr auto lit(const Lighting& lighting, std::uint16_t texel) const {
    if constexpr (Colours == TexelLight::kNone) {
      return UnlitTexel(texel);
    } else if constexpr (Mapping::kHasLevel) {
      return LitTexel<Colours>{
          texel, {PackedRgb::grey(steps().packed_level()), {}}, steps().light_factor(), 0};
    } else {
      const PixelLight parts = light(lighting);
      if constexpr (Colours == TexelLight::kColoured &&
                    requires { lighting.channel_light(light_run.scalars()); }) {
        const auto channels = lighting.channel_light(light_run.scalars());
        return LitTexel<Colours>{texel, parts, channels.factors, channels.shine};
      } else {
        return LitTexel<Colours>{texel, parts, factor(lighting, parts), shine(lighting, parts)};
      }
    }
  }

  /// The factor of a LitTexel.
  template <class Lighting>
  [[nodiscard]] ARCSPAN_INLINE constexpr auto factor(const Lighting& lighting,
                                                     const PixelLight& parts) const {
    if constexpr (Colours == TexelLight::kGrey && requires { light_run.light_factor(); }) {
      return light_run.light_factor();
    } else if constexpr (Colours == TexelLight::kGrey &&
                         requires { lighting.factor_at(light_run.diffuse_scalar(lighting)); }) {
      return lighting.factor_at(light_run.diffuse_scalar(lighting));
    } else {
      return LitTexel<Colours>::factor_of(parts.diffuse);
    }
  }
  /// The highlight as a wide_spread().
  template <class Lighting>
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t shine(const Lighting& lighting,
                                                             const PixelLight& parts) const {
    if constexpr (requires { lighting.shine_at(lighting, light_run.scalars()); }) {
      return lighting.shine_at(lighting, light_run.scalars());
    } else {
      return LitTexel<Colours>::shine_of(parts.highlight);
    }
  }
  template <class Lighting>
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    if constexpr (LightRun<Lit, Lighting>) {
      return light_run.light(lighting);
    } else if constexpr (requires { light_run.colour(lighting).packed(); }) {
      return {light_run.colour(lighting).packed(), {}};
    } else {
      return {light_run.colour(lighting), {}};
    }
  }
};

/// The pixels of a row of a textured triangle (PiecewiseRun).
template <class Lit, class Mapping, TexelFormat Texels, TexelLight Colours, TextureFilter Filter>
struct TexturedRun : TexturedPixel<Lit, Mapping, Texels, Colours, Filter> {
  using Pixel = TexturedPixel<Lit, Mapping, Texels, Colours, Filter>;
  static constexpr bool kStartsAnywhere = !Mapping::kInPerspective;
  std::uint32_t first;  ///< texel of the mip level

  /// Starts a row.
  template <class LightWalker>
  ARCSPAN_INLINE constexpr TexturedRun(const LightWalker& light, TextureTriangle& triangle,
                                       const RowStart& row)
      : Pixel{light.row(row), Mapping(triangle, row), nullptr, nullptr}, first(triangle.first) {}

  /// Begins a piece and returns its number of pixels, at most `left`: in perspective a piece of the texture,
  /// otherwise the rest of the row. The light must not have pieces of its own.
  template <class Lighting>
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t enter(const Lighting& lighting, std::int32_t left) {
    static_assert(!PiecewiseRun<Lit, Lighting>);
    std::int32_t count = left;
    std::uint32_t texel = first;
    if constexpr (Mapping::kInPerspective) {
      count = this->mapping.enter(left);
      texel = this->mapping.first();
    }
    this->words = lighting.texture.at(texel);
    hide_value(this->words);  // otherwise compilers add `texel` to the index of every pixel
    this->palette = lighting.texture.palette();
    return count;
  }
};

/// The rows of a small textured triangle: `Light` is the type of its light's rows, `Part` Textured::Small.
template <class Light, class Part, class Steps, TexelFormat Texels, TexelLight Colours, TextureFilter Filter>
struct TexturedSmall {
  using Run = TexturedPixel<typename Light::Run, LinearTexture<Steps, false>, Texels, Colours, Filter>;
  const Part& part;

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(std::int32_t y, std::int32_t b, std::int32_t c) const {
    return {light().row(y, b, c), part.texture.row(b, c), hidden(part.words), part.palette};
  }

 private:
  [[nodiscard]] ARCSPAN_INLINE constexpr Light light() const {
    if constexpr (std::is_empty_v<Light>) {
      return {};
    } else {
      return Light{part.light};
    }
  }
};

/// The walker of a light whose level LinearTexture holds.
struct LevelWalker {
  struct Run {};
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart&) const { return {}; }
  constexpr void next_row() {}
  constexpr void enter_lower() {}
};

/// Steps a textured triangle from row to row (RowWalker), with the walker of its light.
template <class LightWalker, class Mapping, TexelFormat Texels, TexelLight Colours, TextureFilter Filter>
class TexturedWalker {
 public:
  using Run = TexturedRun<typename LightWalker::Run, Mapping, Texels, Colours, Filter>;

  constexpr TexturedWalker(const LightWalker& light, TextureTriangle& triangle)
      : light_(light), triangle_(&triangle) {}
  // Member by member, because compilers call memcpy for the whole on small cores.
  ARCSPAN_INLINE constexpr TexturedWalker(const TexturedWalker& other)
      : light_(other.light_), triangle_(other.triangle_) {}

  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    return Run(light_, *triangle_, start);
  }
  ARCSPAN_INLINE constexpr void next_row() {
    light_.next_row();
    triangle_->template next_row<Mapping>();
  }
  constexpr void enter_lower() {
    light_.enter_lower();
    triangle_->template enter_lower<Mapping>();
  }

 private:
  LightWalker light_;
  TextureTriangle* triangle_;
};

}  // namespace arcspan
