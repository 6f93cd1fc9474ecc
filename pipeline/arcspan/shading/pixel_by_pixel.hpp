// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>

namespace arcspan {

/// Optional part of a method that draws some triangles in segments (SegmentedRun): `PixelByPixel` is the same
/// method without them. Methods that change each pixel derive from that one.
template <class M>
concept MixesSegments = ShadingMethod<typename M::PixelByPixel>;

namespace detail {

template <class M>
struct PixelByPixelOf {
  using Type = M;
};
template <MixesSegments M>
struct PixelByPixelOf<M> {
  using Type = typename M::PixelByPixel;
};

}  // namespace detail

/// @cond an alias of something in `detail`
/// The method `M` without segments, where it can do without them.
template <class M>
using PixelByPixel = typename detail::PixelByPixelOf<M>::Type;
/// @endcond

namespace detail {

/// Refuses, where it is compiled, a walker whose runs are segments.
template <class Walker>
constexpr void require_pixels() {
  static_assert(
      !SegmentedRun<typename Walker::Run>,
      "Textured and WithOperation change single pixels: not those of a method that draws segments only");
}

}  // namespace detail

}  // namespace arcspan
