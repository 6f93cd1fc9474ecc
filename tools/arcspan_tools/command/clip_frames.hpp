// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/command/runtime_model.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// A model at several times of a clip, posed by the library. All poses have one unit and one centre, so that
/// a camera sees the model move.
class ClipFrames {
 public:
  /// `times` in seconds. With `crease_degrees` the normals of each pose are made anew. `subject` names the
  /// model in a Failure.
  ClipFrames(const Model& model, const ClipLength& clip, std::vector<double> times,
             std::optional<double> crease_degrees, const std::string& subject);

  [[nodiscard]] std::size_t size() const { return times_.size(); }
  [[nodiscard]] double time(std::size_t frame) const { return times_[frame]; }
  [[nodiscard]] FixedModel frame(std::size_t frame) const;
  /// The positions of all frames, of many frames those of 64 evenly spaced ones; without triangles. A camera
  /// that sees them all sees the whole clip.
  [[nodiscard]] FixedMesh positions() const;

 private:
  Model model_;
  RuntimeModel runtime_;
  std::string clip_;
  std::vector<double> times_;
  std::optional<double> crease_degrees_;
  std::string subject_;
};

/// The times of `frames` pictures of a clip that is played a whole number of times in `seconds`, at about its
/// own speed, so that the last picture leads to the first.
[[nodiscard]] std::vector<double> looped_times(const ClipLength& clip, std::size_t frames, double seconds);

}  // namespace arcspan::tools
