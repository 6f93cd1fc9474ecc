// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer_window.hpp>
#include <arcspan/scene.hpp>

#include <arcspan_c/view.hpp>

#include <cstddef>
#include <span>

namespace arcspan::c {

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
  return draw_prepared_scene(view.memory, window, depth).status;
}

}  // namespace arcspan::c
