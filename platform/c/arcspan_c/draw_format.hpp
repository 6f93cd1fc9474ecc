// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/scene.hpp>

#include <arcspan_c/view.hpp>

#include <cstddef>
#include <span>

namespace arcspan::c {

/// Inks and smooths the outlines of what was drawn, with the status of draw_scene().
template <class Window>
[[nodiscard]] Status finish_outlines(const ViewOutlines& outlines, Window& window, const DepthBuffer& depth) {
  using Format = typename Window::Format;
  using Gap = OutlineGap<Format>;
  static_assert(sizeof(Gap) <= kGapBytes && alignof(Gap) <= kGapAlignment);
  [[maybe_unused]] const std::span<Gap> gaps(static_cast<Gap*>(static_cast<void*>(outlines.gaps.data())),
                                             outlines.gaps.size() / kGapBytes);
  Status status = outlines.status;
#if ARCSPAN_C_INK
  if (outlines.ink.width != 0) {
    const Status inked = ink_outlines(outlines.edges, outlines.ink, window, depth, gaps);
    if (ok(status)) status = inked;
    if constexpr (!arcspan::detail::kCanBlend<Format>) return status;
  }
#endif
#if ARCSPAN_C_MARKED_OUTLINES
  const Status smoothed = smooth_outlines(outlines.edges, window, depth);
#else
  const Status smoothed = smooth_outlines(outlines.edges, window, depth, gaps);
#endif
  return ok(status) ? smoothed : status;
}

/// arcspan_draw() for the format F.
template <PixelFormat F>
[[nodiscard]] Status draw_format(arcspan_view& view, const arcspan_target& target) {
  if (!ok(view.status)) return view.status;
  const Rect held = rect_of(target.held);
  hal::FramebufferWindow<F> window({static_cast<std::byte*>(target.pixels), target.bytes}, held,
                                   target.stride);
  DepthBuffer depth({target.depth, target.depth_words}, held);
  if (!ok(window.status())) return window.status();
  if (!ok(depth.status())) return depth.status();
  depth.clear();
  if (target.background != nullptr) {
    window.clear({target.background->r, target.background->g, target.background->b});
  }
#if ARCSPAN_C_CURVED_OUTLINES
  const Status drawn = draw_prepared_scene(view.memory, window, depth, view.outlines.curves).status;
#else
  const Status drawn = draw_prepared_scene(view.memory, window, depth).status;
#endif
#if ARCSPAN_C_OUTLINES
  if (ok(drawn) && !view.outlines.sides.empty()) return finish_outlines(view.outlines, window, depth);
#endif
  return drawn;
}

}  // namespace arcspan::c
