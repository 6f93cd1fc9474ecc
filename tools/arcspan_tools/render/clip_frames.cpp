// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>
#include <arcspan_tools/render/clip_frames.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {

ClipFrames::ClipFrames(const Model& model, const RigClip& clip, std::vector<double> times,
                       std::optional<double> crease_degrees, const std::string& subject)
    : model_(model),
      clip_(clip),
      times_(std::move(times)),
      crease_degrees_(crease_degrees),
      subject_(subject),
      box_(box_of(posed_at(0))) {
  for (std::size_t i = 1; i < size(); ++i) box_ = joined(box_, box_of(posed_at(i)));
}

Model ClipFrames::posed_at(std::size_t frame) const {
  return posed(model_, pose_at(*model_.rig, clip_, times_[frame]), subject_);
}

FixedModel ClipFrames::frame(std::size_t frame) const {
  const Model model = posed_at(frame);
  return to_fixed(crease_degrees_ ? with_crease(model, *crease_degrees_, subject_) : model, box_);
}

FixedMesh ClipFrames::positions() const {
  constexpr std::size_t kMostFrames = 64;
  const std::size_t count = std::min(size(), kMostFrames);
  FixedMesh all;
  for (std::size_t i = 0; i < count; ++i) {
    const FixedModel model = to_fixed(posed_at(i * size() / count), box_);
    for (const FixedMesh& mesh : model.meshes)
      all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
    all.unit = model.meshes[0].unit;
    all.centre = model.meshes[0].centre;
  }
  return all;
}

std::vector<double> looped_times(const RigClip& clip, std::size_t frames, double seconds) {
  const double duration = clip.duration();
  const double plays = duration > 0 ? std::max(1.0, std::round(seconds / duration)) : 1;
  std::vector<double> times;
  for (std::size_t i = 0; i < frames; ++i) {
    const double played = plays * static_cast<double>(i) / static_cast<double>(frames);
    times.push_back((played - std::floor(played)) * duration);
  }
  return times;
}

}  // namespace arcspan::tools
