// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>
#include <arcspan_tools/mesh/plain/rig.hpp>

#include <set>
#include <vector>

namespace arcspan::tools {

/// For each instance of a rig, the transform from the mesh to the space that its vertices are stored in: the
/// RigPoser::place() at rest of its node or, with a skin, of its largest joint that moves vertices. If a
/// joint is more than 16 times as large at one of up to 64 keys of a clip, its place there. So a model whose
/// skin is not used stands upright and has its size.
[[nodiscard]] std::vector<Affine> storage_places(const Rig& rig);

/// `model` with its vertices as they are stored for its rig, in place of the pose at rest, and with `reach`:
/// a box around them, and around the poses at all keys of all clips and at times between, with a margin for
/// poses that programs make; also around fades between some of these poses if it had no room for them.
[[nodiscard]] Model as_stored(const Model& model);

/// The least and the largest weight of a morph target.
struct WeightRange {
  double low = 0;
  double high = 1;

  void extend(double weight);
};

/// The ranges of the weights of an instance's morph targets: 0...1, with those at rest and of all clips.
[[nodiscard]] std::vector<WeightRange> weight_ranges(const Rig& rig, std::size_t instance);

/// Extends `box` by all that a morph target can add to its points: `delta` times a weight in `range`.
void widen(Box& box, Vec3 delta, const WeightRange& range);

/// The times of the keys of all channels of a clip.
[[nodiscard]] std::set<double> key_times(const RigClip& clip);

/// `keys`, and times that divide each gap into `parts` equal parts; if these are more than `most`, fewer
/// parts, then only some of the keys.
[[nodiscard]] std::vector<double> times_between(const std::set<double>& keys, std::size_t parts,
                                                std::size_t most);

}  // namespace arcspan::tools
