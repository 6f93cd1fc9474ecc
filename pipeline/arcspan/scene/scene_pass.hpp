// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/scene/draw_part.hpp>
#include <arcspan/scene/object.hpp>
#include <arcspan/scene/scene_material.hpp>

#include <cstddef>
#include <type_traits>

/// A scene is drawn in one pass, or in two if some of its methods blend: a blended part needs all that is
/// opaque behind it.
namespace arcspan::detail {

/// Whether a method blends its pixels with what is there (WithOperation).
template <class Method>
inline constexpr bool kBlends = requires {
  requires Method::kBlends;
};

template <class... A, class... B>
MethodList<A..., B...> operator+(MethodList<A...>, MethodList<B...>);

/// The uses of a list that blend, or the others.
template <bool Blending, class List>
struct UsesThat;
template <bool Blending, class... Used>
struct UsesThat<Blending, MethodList<Used...>> {
  using List = decltype((
      MethodList<>() + ... +
      std::conditional_t<kBlends<typename Used::Method> == Blending, MethodList<Used>, MethodList<>>()));
};
template <class List>
using BlendedUses = typename UsesThat<true, List>::List;
template <class List>
using OpaqueUses = typename UsesThat<false, List>::List;

/// Whether a scene with these uses has two passes.
template <class List>
inline constexpr bool kHasBlended = !std::is_same_v<BlendedUses<List>, MethodList<>>;

/// Whether a material is for one of the uses.
template <class... Used>
[[nodiscard]] bool is_for(MethodList<Used...>, const SceneMaterial& material) {
  return ((material.use() == &kUseFacts<Used>) || ...);
}

/// How many parts of an object have materials for one of the uses.
template <class List>
[[nodiscard]] std::size_t count_parts(List list, const Object& object) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < object.part_count(); ++i)
    if (is_for(list, *object.part(i).material)) ++count;
  return count;
}

}  // namespace arcspan::detail
