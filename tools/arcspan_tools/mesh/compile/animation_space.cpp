// SPDX-License-Identifier: MIT
#include <arcspan_tools/fixed_point/rounding.hpp>
#include <arcspan_tools/mesh/compile/animation_space.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {
namespace {

constexpr std::size_t kMostNodes = 4096;
constexpr int kLengthBits = 8;
constexpr int kScaleBits = 16;
constexpr int kMatrixBits = 24;
constexpr std::int32_t kMostLength = (1 << 30) - 1;
constexpr std::int32_t kMostScale = 1 << 22;
constexpr std::int32_t kMostEntry = 0x7FFFFFFF;

/// The geometric mean of a scale.
double mean_of(Vec3 s) { return std::cbrt(std::abs(s.x) * std::abs(s.y) * std::abs(s.z)); }

/// The size of a scale: its mean, or 1 if a factor is 0.
double size_of(Vec3 s) {
  const double size = mean_of(s);
  return size > 0 && std::isfinite(size) ? size : 1;
}

/// The size of a node's scale: that at rest, or of a node that grows far beyond it the largest in a clip.
double size_of(const Rig& rig, std::size_t node, Vec3 rest) {
  constexpr double kFar = 16;  // scales are below 64
  double largest = 0;
  for (const RigClip& clip : rig.clips) {
    for (const RigChannel& channel : clip.channels) {
      if (channel.node != node || channel.path != ChannelPath::kScale) continue;
      for (std::size_t key = 0; key < channel.keys(); ++key) {
        const double* const s = channel.value(key);
        largest = std::max(largest, mean_of({s[0], s[1], s[2]}));
      }
    }
  }
  const bool grows = largest > kFar * mean_of(rest) && std::isfinite(largest);
  return grows ? largest : size_of(rest);
}

}  // namespace

std::array<std::int16_t, 4> fixed_rotation(Quaternion q) {
  const Quaternion unit = unit_length(q);
  std::array<std::int16_t, 4> raw{};
  const std::array<double, 4> components = {unit.x, unit.y, unit.z, unit.w};
  for (std::size_t i = 0; i < raw.size(); ++i)
    raw[i] = static_cast<std::int16_t>(rounded(components[i] * 32767));
  return raw;
}

AnimationSpace::AnimationSpace(const Rig& rig, double unit, Vec3 centre, const std::string& subject)
    : rig_(rig),
      unit_(unit),
      centre_(centre),
      subject_(subject),
      needed_(rig.nodes.size()),
      moves_(rig.nodes.size()),
      rest_(RigPoser(rig, rest_pose(rig)).nodes()),
      numbers_(rig.nodes.size()) {
  choose_nodes();
  leave_out_far_nodes();
  for (std::size_t i = 0; i < rig.nodes.size(); ++i) {
    if (needed_[i] && moves_[i]) add(i);
  }
}

void AnimationSpace::choose_nodes() {
  for (const RigSkin& skin : rig_.skins) {
    for (const std::size_t joint : skin.joints) needed_[joint] = moves_[joint] = true;
  }
  for (const RigInstance& instance : rig_.instances) {
    if (!instance.skin) needed_[instance.node] = true;
  }
  for (const RigClip& clip : rig_.clips) {
    for (const RigChannel& channel : clip.channels) {
      if (channel.path != ChannelPath::kMorphWeights) moves_[channel.node] = true;
    }
  }
  for (std::size_t i = rig_.nodes.size(); i > 0; --i) {
    const std::optional<std::size_t> parent = rig_.nodes[i - 1].parent;
    if (parent && needed_[i - 1]) needed_[*parent] = true;
  }
  // What hangs on a node that is needed and moves may carry another object.
  for (std::size_t i = 0; i < rig_.nodes.size(); ++i) {
    const std::optional<std::size_t> parent = rig_.nodes[i].parent;
    if (!parent || !moves_[*parent]) continue;
    moves_[i] = true;
    needed_[i] = needed_[i] || needed_[*parent];
  }
}

/// A joint that moves no vertex may be too far away for the format; nothing is lost without it.
void AnimationSpace::leave_out_far_nodes() {
  std::vector<bool> is_used = followed_nodes(rig_);
  for (std::size_t i = rig_.nodes.size(); i > 0; --i) {
    const std::optional<std::size_t> parent = rig_.nodes[i - 1].parent;
    if (parent && is_used[i - 1]) is_used[*parent] = true;
  }
  std::vector<bool> is_left_out(rig_.nodes.size());
  for (std::size_t i = 0; i < rig_.nodes.size(); ++i) {
    const std::optional<std::size_t> parent = rig_.nodes[i].parent;
    const double away = length(rest_[i].translation - centre_) / unit_;
    is_left_out[i] =
        !is_used[i] && (away > std::ldexp(kMostLength, -kLengthBits) || (parent && is_left_out[*parent]));
    if (is_left_out[i]) needed_[i] = false;
  }
}

void AnimationSpace::fail(std::size_t node, const char* what) const {
  throw Failure(subject_, "the node " + std::to_string(node) + " '" + rig_.nodes[node].name + "' " + what +
                              "; --pose leaves the nodes out");
}

std::int32_t AnimationSpace::raw(double value, int fraction_bits, std::int32_t most, const char* what,
                                 const std::string& name) const {
  const double number = rounded(std::ldexp(value, fraction_bits));
  if (!(std::abs(number) <= most)) {
    throw Failure(subject_, std::string("a ") + what + formatted(" (%g) of the node '", value) + name +
                                formatted("' is out of range (the limit is %g); --pose leaves the nodes out",
                                          std::ldexp(most, -fraction_bits)));
  }
  return static_cast<std::int32_t>(number);
}

double AnimationSpace::scale_of_parent(std::size_t node) const {
  return scales_[*nodes_[*numbers_[node]].parent];
}

std::size_t AnimationSpace::root(std::optional<std::size_t> still) {
  const auto [at, is_new] = roots_.try_emplace(still, nodes_.size());
  if (!is_new) return at->second;
  const Affine place = still ? rest_[*still] : Affine{};
  const std::optional<NodeTransform> parts = split(place);
  if (!parts) {  // the node alone may be neither
    add(*still);
    return at->second = *numbers_[*still];
  }
  FixedNode node;
  node.name = still ? rig_.nodes[*still].name : "";
  scales_.push_back(size_of(parts->scale));
  const Vec3 t = (parts->translation - centre_) * (1 / unit_);
  const Vec3 s = parts->scale * (1 / scales_.back());
  node.translation = {raw(t.x, kLengthBits, kMostLength, "translation", node.name),
                      raw(t.y, kLengthBits, kMostLength, "translation", node.name),
                      raw(t.z, kLengthBits, kMostLength, "translation", node.name)};
  node.rotation = fixed_rotation(parts->rotation);
  node.scale = {raw(s.x, kScaleBits, kMostScale, "scale", node.name),
                raw(s.y, kScaleBits, kMostScale, "scale", node.name),
                raw(s.z, kScaleBits, kMostScale, "scale", node.name)};
  nodes_.push_back(node);
  return at->second;
}

void AnimationSpace::add(std::size_t node) {
  const RigNode& of = rig_.nodes[node];
  const std::optional<NodeTransform> parts = of.matrix ? split(*of.matrix) : of.rest;
  if (!parts) fail(node, "is flat or sheared");
  FixedNode fixed;
  fixed.name = of.name;
  const bool hangs_on_moving = of.parent && numbers_[*of.parent];
  fixed.parent = hangs_on_moving ? *numbers_[*of.parent] : root(of.parent);
  fixed.rotation = fixed_rotation(parts->rotation);
  numbers_[node] = nodes_.size();
  scales_.push_back(scales_[*fixed.parent] * size_of(rig_, node, parts->scale));
  nodes_.push_back(fixed);
  nodes_.back().translation = translation(node, parts->translation);
  nodes_.back().scale = scale(node, parts->scale);
  if (nodes_.size() > kMostNodes) fail(node, "is one of more than 4096 nodes that move vertices");
}

std::array<std::int32_t, 3> AnimationSpace::translation(std::size_t node, Vec3 t) const {
  const double factor = scale_of_parent(node) / unit_;
  const std::string& name = rig_.nodes[node].name;
  return {raw(t.x * factor, kLengthBits, kMostLength, "translation", name),
          raw(t.y * factor, kLengthBits, kMostLength, "translation", name),
          raw(t.z * factor, kLengthBits, kMostLength, "translation", name)};
}

std::array<std::int32_t, 3> AnimationSpace::scale(std::size_t node, Vec3 s) const {
  const double factor = scale_of_parent(node) / scale_of(node);
  const std::string& name = rig_.nodes[node].name;
  return {raw(s.x * factor, kScaleBits, kMostScale, "scale", name),
          raw(s.y * factor, kScaleBits, kMostScale, "scale", name),
          raw(s.z * factor, kScaleBits, kMostScale, "scale", name)};
}

FixedJoint AnimationSpace::joint(std::optional<std::size_t> node, const Affine& map) {
  FixedJoint joint;
  Affine from_mesh = map;
  if (node && numbers_[*node]) {
    joint.node = *numbers_[*node];
  } else {  // a node that nothing moves is part of the map
    if (node) from_mesh = rest_[*node] * map;
    joint.node = root(std::nullopt);
  }
  const double k = scales_[joint.node];
  const Vec3 t = from_mesh.point(centre_) * (k / unit_);
  const std::string& name = nodes_[joint.node].name;
  const auto row = [&](double x, double y, double z, double offset) -> std::array<std::int32_t, 4> {
    return {raw(x * k, kMatrixBits, kMostEntry, "matrix", name),
            raw(y * k, kMatrixBits, kMostEntry, "matrix", name),
            raw(z * k, kMatrixBits, kMostEntry, "matrix", name),
            raw(offset, kLengthBits, kMostLength, "matrix", name)};
  };
  joint.rows = {row(from_mesh.x.x, from_mesh.y.x, from_mesh.z.x, t.x),
                row(from_mesh.x.y, from_mesh.y.y, from_mesh.z.y, t.y),
                row(from_mesh.x.z, from_mesh.y.z, from_mesh.z.z, t.z)};
  return joint;
}

}  // namespace arcspan::tools
