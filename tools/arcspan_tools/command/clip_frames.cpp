// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/clip_frames.hpp>
#include <arcspan_tools/fixed_point/unit_box.hpp>
#include <arcspan_tools/mesh/plain/crease.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace arcspan::tools {

ClipFrames::ClipFrames(const Model& model, const ClipLength& clip, std::vector<double> times,
                       std::optional<double> crease_degrees, const std::string& subject)
    : model_(model),
      runtime_(model, subject),
      clip_(clip.name),
      times_(std::move(times)),
      crease_degrees_(crease_degrees),
      subject_(subject) {}

FixedModel ClipFrames::frame(std::size_t frame) const {
  FixedModel posed = runtime_.posed(clip_, times_[frame]);
  if (!crease_degrees_) return posed;
  const FixedMeshes meshes(posed);
  return to_fixed(with_crease(posed_like(model_, posed), *crease_degrees_, subject_),
                  box_of_units(meshes.centre(), meshes.unit()));
}

FixedMesh ClipFrames::positions() const {
  constexpr std::size_t kMostFrames = 64;
  const std::size_t count = std::min(size(), kMostFrames);
  FixedMesh all;
  for (std::size_t i = 0; i < count; ++i) {
    const FixedModel model = runtime_.posed(clip_, times_[i * size() / count]);
    for (const FixedMesh& mesh : model.meshes)
      all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
    all.unit = model.meshes[0].unit;
    all.centre = model.meshes[0].centre;
  }
  return all;
}

std::vector<double> looped_times(const ClipLength& clip, std::size_t frames, double seconds) {
  const double plays = clip.seconds > 0 ? std::max(1.0, std::round(seconds / clip.seconds)) : 1;
  std::vector<double> times;
  for (std::size_t i = 0; i < frames; ++i) {
    const double played = plays * static_cast<double>(i) / static_cast<double>(frames);
    times.push_back((played - std::floor(played)) * clip.seconds);
  }
  return times;
}

}  // namespace arcspan::tools
