// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/command/clip_frames.hpp>
#include <arcspan_tools/command/render_options.hpp>

#include <cstddef>
#include <optional>

namespace arcspan::tools {

/// The model that options ask for in each picture: always the same, or with --clip at times of a
/// clip.
class PlayedModel {
 public:
  /// Loads the model by load_drawn_model() of `options`, which must outlive the object, for so many pictures;
  /// 0: for as many as the clip takes. Without --clip there is one, whatever is asked.
  PlayedModel(RenderOptions& options, std::size_t frames, double frames_per_second);

  [[nodiscard]] std::size_t frames() const { return clip_ ? clip_->size() : 1; }

  /// The model in a picture, until the next call.
  [[nodiscard]] const FixedModel& frame(std::size_t frame);
  /// What a camera has to see: the model, or its positions in all frames.
  [[nodiscard]] FixedMeshes extent() const { return clip_ ? FixedMeshes(positions_) : FixedMeshes(current_); }

 private:
  const RenderOptions& options_;
  Model model_;
  FixedModel current_;
  std::optional<ClipFrames> clip_;
  FixedMesh positions_;
};

}  // namespace arcspan::tools
