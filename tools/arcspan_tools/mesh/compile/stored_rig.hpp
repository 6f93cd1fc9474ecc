// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>
#include <arcspan_tools/mesh/plain/rig.hpp>

#include <set>
#include <vector>

namespace arcspan::tools {

/// The space in which the vertices of each instance of a rig are stored, as a transform from that of its
/// mesh: the place at rest of its node or, with a skin, of the largest joint that moves vertices; if a clip
/// makes a joint more than 16 times as large, its place at that key (of 64 keys of a clip). In it a model
/// whose skin is not used stands upright and has its size.
[[nodiscard]] std::vector<Affine> storage_places(const Rig& rig);

/// `model` with its vertices as they are stored for its rig, in place of the pose at rest, and with `reach`:
/// a box around them, and around the poses at all keys of all clips and at times between, with a margin for
/// poses that programs make.
[[nodiscard]] Model as_stored(const Model& model);

/// The least and the largest weight of a morph target.
struct WeightRange {
  double low = 0;
  double high = 1;

  void extend(double weight);
};

/// The ranges of the weights of an instance's morph targets: 0...1, with those at rest and of all clips.
[[nodiscard]] std::vector<WeightRange> weight_ranges(const Rig& rig, std::size_t instance);

/// Makes `box` hold all that a morph target, which adds `delta` at weight 1, makes of its points.
void widen(Box& box, Vec3 delta, const WeightRange& range);

/// The times of the keys of all channels of a clip.
[[nodiscard]] std::set<double> key_times(const RigClip& clip);

/// `keys`, and between each two the times that divide theirs into `parts` equal parts: into fewer, or some of
/// the keys, if there would be more than `most`.
[[nodiscard]] std::vector<double> times_between(const std::set<double>& keys, std::size_t parts,
                                                std::size_t most);

}  // namespace arcspan::tools
