// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <tests/frames/stage_set.hpp>

/// The frames that the LM3S6965's OLED shows: a torus, turned a little further from frame to frame.
namespace arcspan::scenes {

inline constexpr std::int32_t kOledWidth = 128;
inline constexpr std::int32_t kOledHeight = 64;
inline constexpr std::int32_t kOledFrames = 4;
inline constexpr auto kOledTorus = make_torus<24, 12>();

/// `depths` holds one frame's. `frame_number` 0...kOledFrames - 1.
[[nodiscard]] inline Status draw_oled_frame(std::int32_t frame_number, hal::Framebuffer<Gray4>& frame,
                                            std::span<std::uint16_t> depths) {
  MeshView mesh;
  const Status valid = kOledTorus.view(mesh);
  if (!ok(valid)) return valid;
  StageSet stage;
  const Turn turn{static_cast<std::uint16_t>(frame_number * 1500)};
  const Status set = set_stage({kOledWidth, kOledHeight}, 31, turn, stage);
  if (!ok(set)) return set;
  DepthBuffer depth(depths, kOledWidth, kOledHeight);
  depth.clear();
  frame.clear({0, 0, 34});
  return draw_mesh<Arc<Light>>(mesh, stage.transform, stage.light, frame, depth).status;
}

}  // namespace arcspan::scenes
