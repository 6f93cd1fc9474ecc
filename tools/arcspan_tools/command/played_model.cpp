// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/command/played_model.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {
namespace {

constexpr double kMostFrames = 100'000;

}  // namespace

PlayedModel::PlayedModel(RenderOptions& options, std::size_t frames, double frames_per_second)
    : options_(options), model_(load_drawn_model(options)) {
  if (options.clip.empty()) {
    current_ = to_fixed(model_, options);
    return;
  }
  const ClipLength clip = find_clip(model_, options.clip, options.mesh, "--clip");
  if (frames == 0) {
    const double all = std::round(clip.seconds * frames_per_second);
    if (!(all <= kMostFrames)) throw Failure("--clip", "takes more than 100,000 pictures: see --fps");
    frames = static_cast<std::size_t>(std::max(all, clip.seconds > 0 ? 2.0 : 1.0));
  }
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
