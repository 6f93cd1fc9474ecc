// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/command/played_model.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {

PlayedModel::PlayedModel(RenderOptions& options, std::size_t frames, double frames_per_second)
    : options_(options), model_(load_drawn_model(options)) {
  if (options.clip.empty()) {
    current_ = to_fixed(model_, options);
    return;
  }
  const ClipLength clip = find_clip(model_, options.clip, options.mesh, "--clip");
  if (frames == 0)
    frames = static_cast<std::size_t>(std::max(1.0, std::round(clip.seconds * frames_per_second)));
  const double seconds = static_cast<double>(frames) / frames_per_second;
  clip_.emplace(model_, clip, looped_times(clip, frames, seconds), options.crease_degrees, options.mesh);
  positions_ = clip_->positions();
}

const FixedModel& PlayedModel::frame(std::size_t frame) {
  // Anew for each pose: seams of the mesh may part when it moves.
  if (clip_) current_ = with_outlines(clip_->frame(frame), options_);
  return current_;
}

}  // namespace arcspan::tools
