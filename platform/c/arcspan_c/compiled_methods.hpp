// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/scene/draw_part.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/with_operation.hpp>
#include <arcspan/texture/texel_formats.hpp>

#include <arcspan.h>
#include <arcspan_config.h>

#if ARCSPAN_C_CHARACTERS
#include <arcspan/scene/posed_material.hpp>

#include <arcspan_c/character_mesh.hpp>
#endif

#include <type_traits>

/// The shading methods that arcspan_config.h chooses, for the sources of the C interface and for models that
/// `arcspan mesh --c` has written.
namespace arcspan::c {

using Light = Illumination<ARCSPAN_C_LIGHTS, ARCSPAN_C_PHONG ? Highlight::kPhong : Highlight::kBlinn,
                           IlluminationFeatures{.coloured_lights = ARCSPAN_C_COLOURED_LIGHTS != 0}>;

/// A method, and how a program chooses it. `T` is the format of its texture, or void. With `Blends` it is for
/// translucent objects.
template <arcspan_method Number, class M, class T, bool Blends>
struct Choice {
  static constexpr arcspan_method kNumber = Number;
  static constexpr bool kBlends = Blends;
  using Method = std::conditional_t<Blends, WithOperation<M, Opacity<>>, M>;
  using Texels = T;
};

template <class... Choices>
struct ChoiceList {
#if ARCSPAN_C_CHARACTERS
  using ListedMethods =
      MethodList<typename Choices::Method..., Posed<typename Choices::Method, CharacterMesh>...>;
#else
  using ListedMethods = MethodList<typename Choices::Method...>;
#endif
};

namespace detail {

template <class T>
struct Wrapped {
  using ByArc = Textured<Arc<Light>, T>;
  // One product per pixel where all lights are grey.
  using ByGouraud =
      Textured<std::conditional_t<ARCSPAN_C_COLOURED_LIGHTS != 0, Gouraud<Light>, GreyGouraud<Light>>, T>;
  using ByFlat = Textured<Flat<Light>, T>;
};
template <>
struct Wrapped<void> {
  using ByArc = Arc<Light>;
  using ByGouraud = Gouraud<Light>;
  using ByFlat = Flat<Light>;
};

template <class... Lists>
struct Joined;
template <class... A>
struct Joined<ChoiceList<A...>> {
  using List = ChoiceList<A...>;
};
template <class... A, class... B, class... Lists>
struct Joined<ChoiceList<A...>, ChoiceList<B...>, Lists...> {
  using List = typename Joined<ChoiceList<A..., B...>, Lists...>::List;
};

template <bool Enabled, class C>
using If = std::conditional_t<Enabled, ChoiceList<C>, ChoiceList<>>;

/// The methods of one format of textures, or without texture.
template <bool Enabled, class T, bool Blends = false>
using MethodsOf = typename Joined<
    If<Enabled && ARCSPAN_C_ARC != 0, Choice<ARCSPAN_ARC, typename Wrapped<T>::ByArc, T, Blends>>,
    If<Enabled && ARCSPAN_C_GOURAUD != 0, Choice<ARCSPAN_GOURAUD, typename Wrapped<T>::ByGouraud, T, Blends>>,
    If<Enabled && ARCSPAN_C_FLAT != 0, Choice<ARCSPAN_FLAT, typename Wrapped<T>::ByFlat, T, Blends>>>::List;

/// The methods of all formats of textures and without texture.
template <bool Enabled, bool Blends>
using MethodsThat =
    typename Joined<MethodsOf<Enabled, void, Blends>,
                    MethodsOf<Enabled && ARCSPAN_C_TEXTURES_RGB565 != 0, DirectTexels<>, Blends>,
                    MethodsOf<Enabled && ARCSPAN_C_TEXTURES_PALETTE8 != 0, Palette8Texels<>, Blends>,
                    MethodsOf<Enabled && ARCSPAN_C_TEXTURES_PALETTE4 != 0, Palette4Texels<>, Blends>>::List;

}  // namespace detail

/// All that is compiled.
using AllChoices =
    detail::Joined<detail::MethodsThat<true, false>, detail::MethodsThat<ARCSPAN_C_OPACITY != 0, true>>::List;
using CompiledMethods = AllChoices::ListedMethods;

}  // namespace arcspan::c
