// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/compile/stored_rig.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {
namespace {

/// Poses are looked at at so many times per interval of two keys: between keys a vertex may be farther out.
constexpr std::size_t kParts = 16;

/// By how much a volume must be larger to count as larger.
constexpr double kLarger = 1.01;

/// The joints that move vertices of each instance; without any, or a skin, the first.
std::vector<std::set<std::size_t>> used_joints(const Rig& rig) {
  std::vector<std::set<std::size_t>> used(rig.instances.size());
  for (const RigVertex& vertex : rig.vertices) {
    for (std::size_t i = 0; i < kMostWeights; ++i) {
      if (vertex.weights[i] > 0) used[vertex.instance].insert(vertex.joints[i]);
    }
  }
  for (std::set<std::size_t>& joints : used) {
    if (joints.empty()) joints.insert(0);
  }
  return used;
}

double volume(const Affine& a) { return std::abs(a.determinant()); }

/// Replaces `place` by the largest of the places of joints, by volume, if that is more than `factor` times as
/// large. Of those within 1 % the first is taken.
void take_larger(Affine& place, const RigPoser& poser, std::size_t instance,
                 const std::set<std::size_t>& joints, double factor) {
  double most = volume(place) * factor;
  for (const std::size_t joint : joints) {
    const Affine other = poser.place(instance, joint);
    if (volume(other) <= most) continue;
    place = other;
    most = volume(other) * kLarger;
  }
}

}  // namespace

std::vector<Affine> storage_places(const Rig& rig) {
  constexpr double kFar = 16 * 16 * 16;
  constexpr std::size_t kMostTimes = 64;
  const Affine nowhere{{}, {}, {}, {}};
  const std::vector<std::set<std::size_t>> joints = used_joints(rig);
  std::vector<Affine> places(rig.instances.size(), nowhere);
  const auto take = [&](const RigPose& pose, double factor) {
    const RigPoser poser(rig, pose);
    for (std::size_t i = 0; i < places.size(); ++i) take_larger(places[i], poser, i, joints[i], factor);
  };
  take(rest_pose(rig), 1);
  for (const RigClip& clip : rig.clips) {
    for (const double time : times_between(key_times(clip), 1, kMostTimes))
      take(pose_at(rig, clip, time), kFar);
  }
  for (Affine& place : places) {
    if (!inverse(place)) place = Affine{};
  }
  return places;
}

std::set<double> key_times(const RigClip& clip) {
  std::set<double> keys;
  for (const RigChannel& channel : clip.channels) keys.insert(channel.times.begin(), channel.times.end());
  return keys;
}

std::vector<double> times_between(const std::set<double>& keys, std::size_t parts, std::size_t most) {
  const std::size_t fitting = most / std::max<std::size_t>(keys.size(), 1);
  parts = std::clamp<std::size_t>(fitting, 1, parts);
  std::vector<double> times;
  for (const double key : keys) {
    const double before = times.empty() ? key : times.back();
    for (std::size_t i = 1; i < parts && before < key; ++i)
      times.push_back(before + (key - before) * static_cast<double>(i) / static_cast<double>(parts));
    times.push_back(key);
  }
  std::vector<double> some;
  const std::size_t wanted = std::min(most, times.size());
  for (std::size_t i = 0; i < wanted; ++i) some.push_back(times[i * times.size() / wanted]);
  return some;
}

void WeightRange::extend(double weight) {
  low = std::min(low, weight);
  high = std::max(high, weight);
}

namespace {

/// A cubic curve lies between its ends and what its tangents reach in a third of the time (Bezier's points).
void extend(std::vector<WeightRange>& ranges, const RigChannel& channel) {
  const bool cubic = channel.interpolation == Interpolation::kCubic;
  for (std::size_t key = 0; key < channel.keys(); ++key) {
    const double* const value = channel.value(key);
    const double before = key == 0 ? 0 : channel.times[key] - channel.times[key - 1];
    const double after = key + 1 == channel.keys() ? 0 : channel.times[key + 1] - channel.times[key];
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      ranges[i].extend(value[i]);
      if (!cubic) continue;
      ranges[i].extend(value[i] - before / 3 * (value - ranges.size())[i]);
      ranges[i].extend(value[i] + after / 3 * (value + ranges.size())[i]);
    }
  }
}

}  // namespace

std::vector<WeightRange> weight_ranges(const Rig& rig, std::size_t instance) {
  const RigInstance& of = rig.instances[instance];
  std::vector<WeightRange> ranges(of.morph_weights.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) ranges[i].extend(of.morph_weights[i]);
  for (const RigClip& clip : rig.clips) {
    for (const RigChannel& channel : clip.channels) {
      if (channel.node == of.node && channel.path == ChannelPath::kMorphWeights) extend(ranges, channel);
    }
  }
  return ranges;
}

void widen(Box& box, Vec3 delta, const WeightRange& range) {
  const Vec3 a = delta * range.low;
  const Vec3 b = delta * range.high;
  box.low = box.low + Vec3{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
  box.high = box.high + Vec3{std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

namespace {

void extend(Box& box, Vec3 p) {
  box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
  box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
}

/// Makes `box` hold the vertices of `model` in a pose.
void extend(Box& box, const Model& model, const RigPose& pose) {
  const RigPoser poser(*model.rig, pose);
  for (const ModelPart& part : model.parts) {
    for (const std::uint32_t source : part.mesh.sources) {
      if (source != kNoSource) extend(box, poser.position(model.rig->vertices[source]));
    }
  }
}

/// Makes `box` hold what has 16 bits, too, before joints move it: the shapes that morph targets make of the
/// stored vertices, and what each target adds. `places` are the storage_places().
void extend_by_morphs(Box& box, const Rig& rig, const std::vector<Affine>& places) {
  std::vector<std::vector<WeightRange>> ranges;
  for (std::size_t i = 0; i < rig.instances.size(); ++i) ranges.push_back(weight_ranges(rig, i));
  double most_added = 0;
  for (const RigVertex& vertex : rig.vertices) {
    if (vertex.deltas.empty()) continue;
    const Affine& place = places[vertex.instance];
    const Vec3 stored = place.point(vertex.position);
    Box shapes{stored, stored};
    for (std::size_t i = 0; i < vertex.deltas.size(); ++i) {
      const Vec3 added = place.direction(vertex.deltas[i].position);
      widen(shapes, added, ranges[vertex.instance][i]);
      most_added = std::max({most_added, std::abs(added.x), std::abs(added.y), std::abs(added.z)});
    }
    extend(box, shapes.low);
    extend(box, shapes.high);
  }
  const Vec3 middle = (box.low + box.high) * 0.5;
  for (const double sign : {-1.0, 1.0}) extend(box, middle + Vec3{sign, 0, 0} * most_added);
}

using Moments = std::vector<RigMoment>;

/// Some moments of each clip; first rest, as a clip of one moment.
std::vector<Moments> moments_of(const Rig& rig) {
  constexpr std::size_t kMost = 8;  // of a clip
  std::vector<Moments> clips = {{{}}};
  for (const RigClip& clip : rig.clips) {
    Moments moments;
    for (const double time : times_between(key_times(clip), 1, kMost)) moments.push_back({&clip, time});
    clips.push_back(moments);
  }
  return clips;
}

/// Makes `box` hold the vertices in fades between two clips, from at most `most` pairs of their moments.
void extend_by_fades(Box& box, const Model& model, const Moments& from, const Moments& to, std::size_t most) {
  const std::size_t all = from.size() * to.size();
  const std::size_t taken = std::min(all, most);
  for (std::size_t i = 0; i < taken; ++i) {
    const std::size_t pair = i * all / taken;
    const std::size_t row = pair / to.size();
    // In a table of all pairs each row is rotated by one more, so that few pairs have all moments of both.
    const RigMoment& other = to[(pair + row) % to.size()];
    for (const double weight : {0.25, 0.5, 0.75})
      extend(box, model, faded_pose(*model.rig, from[row], other, weight));
  }
}

/// Makes `box` hold the vertices in some fades between all clips, each with each and with itself.
void extend_by_fades(Box& box, const Model& model) {
  constexpr std::size_t kMostPosed = 1'000'000;  // vertices and nodes for each weight, aimed at
  const std::vector<Moments> clips = moments_of(*model.rig);
  const std::size_t pairs = clips.size() * (clips.size() + 1) / 2;
  const std::size_t most = kMostPosed / (model.vertex_count() + model.rig->nodes.size()) / pairs;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    for (std::size_t k = i; k < clips.size(); ++k)
      extend_by_fades(box, model, clips[i], clips[k], std::max<std::size_t>(most, 1));
  }
}

/// Whether 16-bit positions made for `box` hold `needed`. They span a cube of the longest side of `box`,
/// beyond which `needed` may reach by 1/256: a pixel of a model of 256 pixels.
bool has_room(const Box& box, const Box& needed) {
  const Vec3 sides = box.high - box.low;
  const double side = std::max({sides.x, sides.y, sides.z});
  const Vec3 room = Vec3{side, side, side} * 0.5;
  const Vec3 middle = (box.low + box.high) * 0.5;
  const Vec3 low = needed.low - (middle - room);
  const Vec3 high = middle + room - needed.high;
  return std::min({low.x, low.y, low.z, high.x, high.y, high.z}) >= -side / 256;
}

Box with_margin(const Box& box) {
  constexpr double kMarginShare = 0.02;  // of the extent, on each side
  const Vec3 margin = (box.high - box.low) * kMarginShare;
  return {box.low - margin, box.high + margin};
}

/// A box around the stored vertices and poses of all clips, and around fades if it has no room for them.
Box reach_of(const Model& model, const std::vector<Affine>& places) {
  constexpr std::size_t kMostPosed = 4'000'000;
  const Vec3 any = model.parts[0].mesh.positions[0];
  Box box{any, any};
  for (const ModelPart& part : model.parts) {
    for (const Vec3& p : part.mesh.positions) extend(box, p);
  }
  extend(box, model, rest_pose(*model.rig));
  const std::size_t clips = std::max<std::size_t>(model.rig->clips.size(), 1);
  const std::size_t most = std::max<std::size_t>(kMostPosed / (model.vertex_count() * clips), 16);
  for (const RigClip& clip : model.rig->clips) {
    for (const double time : times_between(key_times(clip), kParts, most))
      extend(box, model, pose_at(*model.rig, clip, time));
  }
  extend_by_morphs(box, *model.rig, places);
  Box faded = box;
  extend_by_fades(faded, model);
  return with_margin(has_room(with_margin(box), faded) ? box : faded);
}

}  // namespace

Model as_stored(const Model& model) {
  Model out = model;
  if (model.rig == nullptr) return out;
  const Rig& rig = *model.rig;
  const std::vector<Affine> places = storage_places(rig);
  const RigPoser rest(rig, rest_pose(rig));
  for (ModelPart& part : out.parts) {
    MeshData& mesh = part.mesh;
    for (std::size_t i = 0; i < mesh.sources.size(); ++i) {
      if (mesh.sources[i] == kNoSource) continue;
      const RigVertex& vertex = rig.vertices[mesh.sources[i]];
      const Affine& place = places[vertex.instance];
      mesh.positions[i] = place.point(vertex.position);
      const Vec3 normal = stored_normal(vertex, mesh.normals[i], rest);
      mesh.normals[i] = normalised(place.direction(carried_normal(rest, vertex, normal)));
    }
  }
  out.reach = reach_of(out, places);
  return out;
}

}  // namespace arcspan::tools
