// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/method.hpp>

#include <type_traits>

namespace arcspan {

/// A method that draws a whole object in one colour: Unlit, with operations or without. Lines and points are
/// drawn by such methods.
template <class M>
concept OneColour = ShadingMethod<M> && std::is_empty_v<typename M::Vertex> &&
    std::is_empty_v<typename M::Face> && std::is_empty_v<typename M::Prepared> && !bool{M::kNeedsFaceNormal};

}  // namespace arcspan
