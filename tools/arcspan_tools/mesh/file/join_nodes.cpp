// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/join_nodes.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace arcspan::tools {
namespace {

Quaternion product(Quaternion a, Quaternion b) {
  const Vec3 u{a.x, a.y, a.z};
  const Vec3 v{b.x, b.y, b.z};
  const Vec3 axis = v * a.w + u * b.w + cross(u, v);
  return {axis.x, axis.y, axis.z, a.w * b.w - dot(u, v)};
}

Vec3 product(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// The transform of a node at rest, and which of its properties a clip moves.
struct NodeMotion {
  NodeTransform rest{};
  bool translates = false;
  bool rotates = false;
  bool scales = false;
};

std::optional<NodeMotion> motion_of(const Rig& rig, std::size_t node) {
  const RigNode& of = rig.nodes[node];
  const std::optional<NodeTransform> rest = of.matrix ? split(*of.matrix) : of.rest;
  if (!rest) return std::nullopt;
  NodeMotion found{*rest};
  for (const RigClip& clip : rig.clips) {
    for (const RigChannel& channel : clip.channels) {
      if (channel.node != node) continue;
      found.translates = found.translates || channel.path == ChannelPath::kTranslation;
      found.rotates = found.rotates || channel.path == ChannelPath::kRotation;
      found.scales = found.scales || channel.path == ChannelPath::kScale;
    }
  }
  return found;
}

bool can_join(const NodeMotion& first, const NodeMotion& next) {
  constexpr double kSmall = 1e-6;
  const Vec3& s = first.rest.scale;
  const double size = std::abs(s.x);
  const Quaternion& q = next.rest.rotation;
  const bool is_turned = next.rotates || length(Vec3{q.x, q.y, q.z}) > kSmall * std::sqrt(inner(q, q));
  const bool is_even =
      !first.scales && std::abs(s.y - s.x) <= kSmall * size && std::abs(s.z - s.x) <= kSmall * size;
  const bool is_away = next.translates || next.rest.translation != Vec3{};
  const bool is_both = (first.translates && next.translates) || (first.rotates && next.rotates) ||
                       (first.scales && next.scales);
  return !is_both && (is_even || !is_turned) && !((first.rotates || first.scales) && is_away);
}

/// Applies `change` to the keys of a node's property, which become those of another node.
template <class Change>
void move_keys(Rig& rig, std::size_t from, ChannelPath path, std::size_t to, const Change& change) {
  for (RigClip& clip : rig.clips) {
    for (RigChannel& channel : clip.channels) {
      if (channel.node != from || channel.path != path) continue;
      channel.node = to;
      for (std::size_t key = 0; key < channel.keys(); ++key)
        change(&channel.values[key * channel.components]);
    }
  }
}

void join(Rig& rig, std::size_t parent, std::size_t child, const NodeMotion& first, const NodeMotion& next) {
  const Affine place = first.rest.affine();
  const NodeTransform& a = first.rest;
  const NodeTransform& b = next.rest;
  const auto store = [](double* v, Vec3 value) {
    v[0] = value.x;
    v[1] = value.y;
    v[2] = value.z;
  };
  const auto store_turn = [](double* v, Quaternion q) {
    v[0] = q.x;
    v[1] = q.y;
    v[2] = q.z;
    v[3] = q.w;
  };
  const auto turn = [](const double* v) { return Quaternion{v[0], v[1], v[2], v[3]}; };
  const auto vector = [](const double* v) { return Vec3{v[0], v[1], v[2]}; };
  // Those of the child first: afterwards it has the parent's, too.
  move_keys(rig, child, ChannelPath::kTranslation, child,
            [&](double* v) { store(v, place.point(vector(v))); });
  move_keys(rig, child, ChannelPath::kRotation, child,
            [&](double* v) { store_turn(v, product(a.rotation, turn(v))); });
  move_keys(rig, child, ChannelPath::kScale, child,
            [&](double* v) { store(v, product(a.scale, vector(v))); });
  const Vec3 offset = place.direction(b.translation);
  move_keys(rig, parent, ChannelPath::kTranslation, child, [&](double* v) { store(v, vector(v) + offset); });
  move_keys(rig, parent, ChannelPath::kRotation, child,
            [&](double* v) { store_turn(v, product(turn(v), b.rotation)); });
  move_keys(rig, parent, ChannelPath::kScale, child,
            [&](double* v) { store(v, product(vector(v), b.scale)); });
  RigNode& node = rig.nodes[child];
  node.rest = {place.point(b.translation), product(a.rotation, b.rotation), product(a.scale, b.scale)};
  node.matrix.reset();
  node.parent = rig.nodes[parent].parent;
}

/// Takes nodes out of a rig.
std::vector<std::size_t> without(Rig& rig, const std::vector<std::optional<std::size_t>>& child_of_gone) {
  std::vector<std::size_t> numbers(rig.nodes.size());
  std::vector<RigNode> left;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (child_of_gone[i]) continue;
    numbers[i] = left.size();
    left.push_back(rig.nodes[i]);
  }
  for (std::size_t i = numbers.size(); i > 0; --i) {
    if (child_of_gone[i - 1]) numbers[i - 1] = numbers[*child_of_gone[i - 1]];
  }
  for (RigNode& node : left) {
    if (node.parent) node.parent = numbers[*node.parent];
  }
  for (RigClip& clip : rig.clips) {
    for (RigChannel& channel : clip.channels) channel.node = numbers[channel.node];
  }
  rig.nodes = std::move(left);
  return numbers;
}

}  // namespace

std::vector<std::size_t> join_pivot_nodes(Rig& rig, const std::vector<bool>& kept) {
  std::vector<std::vector<std::size_t>> children(rig.nodes.size());
  for (std::size_t i = 0; i < rig.nodes.size(); ++i) {
    if (rig.nodes[i].parent) children[*rig.nodes[i].parent].push_back(i);
  }
  std::vector<std::optional<std::size_t>> child_of_gone(rig.nodes.size());
  for (std::size_t i = rig.nodes.size(); i > 0; --i) {
    const std::size_t node = i - 1;
    // The loader library puts this into the names of the nodes that it makes.
    if (rig.nodes[node].name.find("_$AssimpFbx$_") == std::string::npos) continue;
    if (kept[node] || children[node].size() != 1) continue;
    std::size_t child = children[node][0];
    while (child_of_gone[child]) child = *child_of_gone[child];
    const std::optional<NodeMotion> first = motion_of(rig, node);
    const std::optional<NodeMotion> next = motion_of(rig, child);
    if (!first || !next || !can_join(*first, *next)) continue;
    join(rig, node, child, *first, *next);
    child_of_gone[node] = child;
  }
  return without(rig, child_of_gone);
}

}  // namespace arcspan::tools
