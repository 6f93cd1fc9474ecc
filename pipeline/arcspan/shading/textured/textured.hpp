// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/shading/relight.hpp>
#include <arcspan/shading/textured/border_steps.hpp>
#include <arcspan/shading/textured/level_arc.hpp>
#include <arcspan/shading/textured/light_tables.hpp>
#include <arcspan/shading/textured/small_texture.hpp>
#include <arcspan/shading/textured/texel_light.hpp>
#include <arcspan/shading/textured/texture_row.hpp>
#include <arcspan/shading/textured/texture_triangle.hpp>
#include <arcspan/shading/textured/textured_rows.hpp>
#include <arcspan/shading/unlit.hpp>
#include <arcspan/target.hpp>
#include <arcspan/texture/texture.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// The light of `Method` on a texture: coloured where its type says that it may be, by coloured lights or by
/// the colours of vertices.
template <class Method>
[[nodiscard]] consteval TexelLight texel_light_of() {
  if (std::same_as<Method, Unlit>) return TexelLight::kNone;
  bool coloured = TakesVertexData<Method>;
  if constexpr (requires { Method::Lighting::kFeatures.coloured_lights; })
    coloured = coloured || Method::Lighting::kFeatures.coloured_lights;
  return coloured ? TexelLight::kColoured : TexelLight::kGrey;
}

/// The method that lights a texture by `Method`: by Arc it has levels.
template <class Method, TexelLight Colours>
struct LightOnTexture {
  using Type = Method;
};
/// By Arc under grey light.
template <class Illumination>
requires(Illumination::kHasRamp) struct LightOnTexture<Arc<Illumination>, TexelLight::kGrey> {
  using Type = LevelArc<Illumination>;
};
template <class Method, TexelLight Colours>
using LightOn = typename LightOnTexture<Method, Colours>::Type;

/// A method's part of a small triangle; empty if it does not draw them.
template <class M>
struct SmallPart {
  struct Type {};
};
/// That of one that does.
template <DrawsSmallTriangles M>
struct SmallPart<M> {
  using Type = typename M::Small;
};

/// In place of LightTables, where there are none.
struct NoTables {};
/// The tables of the light of a method: LightTables of one that is interpolated by scalars (Arc).
template <class M, TexelLight Colours>
struct TablesFor {
  using Type = NoTables;
};
/// Those of a method of scalars.
template <class M, TexelLight Colours>
requires(Colours != TexelLight::kNone && M::Lighting::kHasRamp && M::kScalars == M::Lighting::kScalars) &&
    requires(const typename M::Lighting& light) {
  light.ramp();
}
struct TablesFor<M, Colours> {
  using Type = LightTables<typename M::Lighting, Colours>;
};
template <class M, TexelLight Colours>
using TablesOf = typename TablesFor<M, Colours>::Type;

/// A shading method with a texture: each pixel shows a texel, times the light that `Method` (Unlit, Flat,
/// Gouraud, Arc, VertexColoured) computes for it. Phong's highlights are added afterwards; those of
/// Gouraud and Flat are part of the light. The diffuse coefficients of a textured material are usually 1
/// (white).
///
/// Texels are shown of the mip level whose texels are about as large as the triangle's pixels.
/// Perspective is correct within half a texel and two pixels: a triangle is mapped linearly where that is
/// exact enough, elsewhere in the longest pieces of a row that are.
template <class Method, TexelFormat Texels, TexelLight Colours = texel_light_of<Method>(),
          TextureFilter Filter = TextureFilter::kNearest, TextureBorders Borders = TextureBorders::kRepeat>
struct Textured : LightOn<Method, Colours> {
  using Light = LightOn<Method, Colours>;
  /// The illumination of `Method` with the texture.
  struct Lighting : TablesOf<Light, Colours>, Light::Lighting {
    constexpr Lighting() = default;
    /// `light`: what Method::Lighting is made of, usually an Illumination.
    template <class L>
    requires std::constructible_from<typename Light::Lighting, const L&>
    constexpr explicit Lighting(const L& light, const Texture<Texels>& picture = {})
        : Light::Lighting(light), texture(picture) {
      make_tables();
    }
    /// Changes the texture (PreparedMaterial::with).
    constexpr void set(const Texture<Texels>& picture) { texture = picture; }
    /// Changes the light and keeps the texture.
    template <class L>
    constexpr void relight(const L& light) {
      detail::relight(static_cast<typename Light::Lighting&>(*this), light);
      make_tables();
    }
    /// Illumination::set_toon(), in the tables, too.
    constexpr Status set_toon(std::int32_t steps) requires requires(typename Light::Lighting& light) {
      light.set_toon(steps);
    }
    {
      const Status status = Light::Lighting::set_toon(steps);
      make_tables();
      return status;
    }
    /// Whether the texture is shown as its sampler says.
    [[nodiscard]] constexpr bool shows_borders() const {
      return Borders == TextureBorders::kOfTexture || texture.sampler().repeats();
    }
    Texture<Texels> texture;

   private:
    constexpr void make_tables() {
      using Tables = TablesOf<Light, Colours>;
      if constexpr (std::constructible_from<Tables, const typename Light::Lighting&>) {
        static_cast<Tables&>(*this) = Tables(static_cast<const typename Light::Lighting&>(*this));
      }
    }
  };
  using Steps = std::conditional_t<Borders == TextureBorders::kOfTexture, BorderSteps, TexelSteps>;
  using typename Light::Face;
  using DrawsSmallTrianglesAs = std::conditional_t<DrawsSmallTriangles<Light>, Textured, void>;
  struct Vertex : Light::Vertex {
    MappedPoint point;
  };
  struct Prepared {
    typename Light::Prepared light;
    TextureTriangle texture;

    constexpr void move_columns(std::int32_t pixels) { texture.move_columns<Steps>(pixels); }
  };
  /// The part of a small triangle.
  struct Small {
    typename SmallPart<Light>::Type light;
    SmallTexture<Steps> texture;
    const typename Texels::Word* words;
    const std::uint16_t* palette;
  };
  static constexpr bool kNeedsNearOverW = true;
  /// The light of triangles may be a level, that of grey light.
  static constexpr bool kHasLevels =
      Colours == TexelLight::kGrey && requires(typename Light::Prepared & light) {
    Light::has_levels(light);
  };
  /// Where u and v are linear on the screen, it is stepped with them.
  static constexpr bool kJoinsLevel = kHasLevels && !Steps::kHasBorders;

  [[nodiscard]] static Vertex shade_vertex(const Lighting& lighting, const Direction& normal) {
    return {Light::shade_vertex(lighting, normal), {}};
  }
  /// Sets what a vertex has in the mesh besides its normal (TakesVertexData).
  static constexpr void set_vertex_data(const MeshView& mesh, std::size_t i, Vertex& vertex) {
    if constexpr (TakesVertexData<Light>) Light::set_vertex_data(mesh, i, vertex);
    const TexturePoint point = mesh.texture_point(i);
    const int shift = 16 - mesh.texture_scale().fraction_bits;
    vertex.point = {wrap_shl(point.u, shift), wrap_shl(point.v, shift)};
  }
  [[nodiscard]] static constexpr Vertex between(const Vertex& a, const Vertex& b, CutFraction t) {
    return {Light::between(a, b, t), {t.between(a.point.u, b.point.u), t.between(a.point.v, b.point.v)}};
  }

  template <class Frame>
  static constexpr void prepare(const Lighting& lighting, Frame& frame, const Face& face,
                                Prepared& prepared) {
    if constexpr (Steps::kHasBorders) prepared.texture.set_wraps(lighting.texture.sampler());
    const TextureCorners corners{
        {frame.top->shade.point, frame.middle->shade.point, frame.bottom->shade.point},
        {frame.top->near_over_w.value, frame.middle->near_over_w.value, frame.bottom->near_over_w.value}};
    const TextureSize& size = lighting.texture.size();
    if constexpr (kHasLevels) {
      CornerLevels levels;
      const bool has = Light::find_levels(lighting, frame, face, prepared.light, levels);
      prepare_texture<Filter, Steps>(frame, size, corners, kJoinsLevel && has ? &levels : nullptr,
                                     prepared.texture);
      if (has && (!kJoinsLevel || prepared.texture.piece != 0))
        Light::prepare_levels(frame, levels, prepared.light);
    } else {
      Light::prepare(lighting, frame, face, prepared.light);
      prepare_texture<Filter, Steps>(frame, size, corners, nullptr, prepared.texture);
    }
  }

  template <class Draw>
  [[nodiscard]] ARCSPAN_INLINE static constexpr Status walk(Prepared& prepared, Draw&& draw) {
    if constexpr (kJoinsLevel) {
      if (prepared.texture.piece == 0 && Light::has_levels(prepared.light)) {
        return draw(TexturedWalker<LevelWalker, LinearTexture<Steps, true>, Texels, Colours, Filter>(
            {}, prepared.texture));
      }
    }
    return Light::walk(prepared.light, [&](auto walker) {
      using LightWalker = decltype(walker);
      constexpr bool kIsLevel = requires(const typename LightWalker::Run& run) { run.light_factor(); };
      if constexpr (!kJoinsLevel || !kIsLevel) {
        if (prepared.texture.piece == 0) {
          return draw(TexturedWalker<LightWalker, LinearTexture<Steps, false>, Texels, Colours, Filter>(
              walker, prepared.texture));
        }
      }
      return draw(TexturedWalker<LightWalker, PerspectiveTexture<Steps, Filter>, Texels, Colours, Filter>(
          walker, prepared.texture));
    });
  }

  /// Prepares a small triangle (DrawsSmallTriangles), unless its texture is seen in perspective.
  template <class Raster>
  [[nodiscard]] ARCSPAN_INLINE static constexpr bool prepare_small(const Lighting& lighting,
                                                                   const Raster& top, const Raster& middle,
                                                                   const Raster& bottom, const Face& face,
                                                                   const SmallTriangle& triangle,
                                                                   Small& part) {
    if constexpr (Steps::kHasBorders) part.texture.set_wraps(lighting.texture.sampler());
    if (!part.texture.template prepare<Filter>(top, middle, bottom, lighting.texture.size(), triangle))
      return false;
    part.words = lighting.texture.at(part.texture.first);
    part.palette = lighting.texture.palette();
    return Light::prepare_small(lighting, top, middle, bottom, face, triangle, part.light);
  }
  template <class Draw>
  [[nodiscard]] static constexpr Status walk_small(const Small& part, Draw&& draw) {
    return Light::walk_small(part.light, [&](const auto& light) {
      using LightRows = std::remove_cvref_t<decltype(light)>;
      return draw(TexturedSmall<LightRows, Small, Steps, Texels, Colours, Filter>{part});
    });
  }
};

}  // namespace arcspan
