// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/scene/camera.hpp>
#include <arcspan/scene/scene_memory.hpp>

#include <arcspan_c/compiled_methods.hpp>
#include <arcspan_c/scene.hpp>

#include <cstddef>
#include <span>

namespace arcspan::c {

/// Of a gap, in every format.
inline constexpr std::size_t kGapBytes = 16;
inline constexpr std::size_t kGapAlignment = 4;

/// What arcspan_smooth_outlines() gives a view; without sides nothing is smoothed.
struct ViewOutlines {
  std::span<TriangleSide> sides{};
  OutlineList edges{{}};
  std::span<std::byte> gaps{};
  Status status = Status::kOk;  ///< of finding the outlines of the frame
#if ARCSPAN_C_INK
  OutlineInk ink{{}, 0, false};  ///< of width 0: none
#endif
#if ARCSPAN_C_CURVED_OUTLINES
  bool is_curved = false;
  CurvedOutlines curves{{}, {}, {}};
#endif
};

}  // namespace arcspan::c

/// The type that arcspan.h declares.
struct arcspan_view {
  arcspan_scene& scene;
  arcspan::Camera camera;
  arcspan::SceneMemoryView<arcspan::c::CompiledMethods> memory;
  arcspan::Status status;  ///< of the last arcspan_prepare()
#if ARCSPAN_C_OUTLINES
  arcspan::c::ViewOutlines outlines{};
#endif
};

namespace arcspan::c {

[[nodiscard]] constexpr Rect rect_of(const arcspan_rect& r) { return {r.left, r.top, r.right, r.bottom}; }

/// Draws into a target of one format.
using DrawFunction = Status (*)(arcspan_view& view, const arcspan_target& target);

// Each is defined in a source of its own, of formats/, if the format is compiled: several in one source
// cost 1.8 % of every frame, because the compiler inlines less.
Status draw_rgb565(arcspan_view& view, const arcspan_target& target);
Status draw_rgb565_swapped(arcspan_view& view, const arcspan_target& target);
Status draw_rgb888(arcspan_view& view, const arcspan_target& target);
Status draw_bgr888(arcspan_view& view, const arcspan_target& target);
Status draw_xrgb8888(arcspan_view& view, const arcspan_target& target);
Status draw_argb8888(arcspan_view& view, const arcspan_target& target);
Status draw_gray8(arcspan_view& view, const arcspan_target& target);
Status draw_gray4(arcspan_view& view, const arcspan_target& target);
Status draw_mono(arcspan_view& view, const arcspan_target& target);

}  // namespace arcspan::c
