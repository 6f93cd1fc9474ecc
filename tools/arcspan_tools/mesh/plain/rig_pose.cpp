// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/rig_pose.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <utility>

namespace arcspan::tools {
namespace {

void move(NodeTransform& node, const RigChannel& channel, double time) {
  const std::vector<double> v = channel.at(time);
  if (channel.path == ChannelPath::kTranslation) node.translation = {v[0], v[1], v[2]};
  if (channel.path == ChannelPath::kRotation) node.rotation = {v[0], v[1], v[2], v[3]};
  if (channel.path == ChannelPath::kScale) node.scale = {v[0], v[1], v[2]};
}

/// All nodes at a moment; those with a matrix, which no clip moves, are left as they are.
std::vector<NodeTransform> transforms_at(const Rig& rig, const RigMoment& moment) {
  std::vector<NodeTransform> transforms;
  for (const RigNode& node : rig.nodes) transforms.push_back(node.rest);
  if (moment.clip == nullptr) return transforms;
  for (const RigChannel& channel : moment.clip->channels) {
    if (channel.path != ChannelPath::kMorphWeights) move(transforms[channel.node], channel, moment.time);
  }
  return transforms;
}

NodeTransform between(const NodeTransform& a, const NodeTransform& b, double weight) {
  return {a.translation * (1 - weight) + b.translation * weight,
          slerp(unit_length(a.rotation), unit_length(b.rotation), weight),
          a.scale * (1 - weight) + b.scale * weight};
}

}  // namespace

RigPose rest_pose(const Rig& rig) {
  RigPose pose;
  for (const RigNode& node : rig.nodes) pose.nodes.push_back(node.matrix ? *node.matrix : node.rest.affine());
  for (const RigInstance& instance : rig.instances) pose.morph_weights.push_back(instance.morph_weights);
  return pose;
}

RigPose pose_at(const Rig& rig, const RigClip& clip, double time) {
  RigPose pose = rest_pose(rig);
  const std::vector<NodeTransform> moved = transforms_at(rig, {&clip, time});
  for (const RigChannel& channel : clip.channels) {
    if (channel.path != ChannelPath::kMorphWeights) {
      pose.nodes[channel.node] = moved[channel.node].affine();
      continue;
    }
    for (std::size_t i = 0; i < rig.instances.size(); ++i) {
      if (rig.instances[i].node == channel.node) pose.morph_weights[i] = channel.at(time);
    }
  }
  return pose;
}

RigPose faded_pose(const Rig& rig, const RigMoment& from, const RigMoment& to, double weight) {
  const auto pose_of = [&rig](const RigMoment& moment) {
    return moment.clip == nullptr ? rest_pose(rig) : pose_at(rig, *moment.clip, moment.time);
  };
  RigPose pose = pose_of(from);
  const RigPose other = pose_of(to);
  const std::vector<NodeTransform> a = transforms_at(rig, from);
  const std::vector<NodeTransform> b = transforms_at(rig, to);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!rig.nodes[i].matrix) pose.nodes[i] = between(a[i], b[i], weight).affine();
  }
  for (std::size_t i = 0; i < pose.morph_weights.size(); ++i) {
    std::vector<double>& weights = pose.morph_weights[i];
    for (std::size_t k = 0; k < weights.size(); ++k)
      weights[k] = weights[k] * (1 - weight) + other.morph_weights[i][k] * weight;
  }
  return pose;
}

RigPoser::RigPoser(const Rig& rig, const RigPose& pose) : rig_(rig), morph_weights_(pose.morph_weights) {
  for (std::size_t i = 0; i < rig.nodes.size(); ++i) {
    const std::optional<std::size_t> parent = rig.nodes[i].parent;
    nodes_.push_back(parent ? nodes_[*parent] * pose.nodes[i] : pose.nodes[i]);
  }
  for (const RigSkin& skin : rig.skins) {
    std::vector<Affine>& joints = joints_.emplace_back();
    for (std::size_t i = 0; i < skin.joints.size(); ++i)
      joints.push_back(nodes_[skin.joints[i]] * skin.inverse_bind[i]);
  }
}

Affine RigPoser::place(const RigVertex& vertex) const {
  const RigInstance& instance = rig_.instances[vertex.instance];
  if (!instance.skin) return nodes_[instance.node];
  const std::vector<Affine>& joints = joints_[*instance.skin];
  Affine sum{{}, {}, {}, {}};
  for (std::size_t i = 0; i < kMostWeights; ++i) {
    if (vertex.weights[i] != 0) add_weighted(sum, joints[vertex.joints[i]], vertex.weights[i]);
  }
  return sum;
}

Affine RigPoser::place(std::size_t instance, std::size_t joint) const {
  const RigInstance& of = rig_.instances[instance];
  return of.skin ? joints_[*of.skin][joint] : nodes_[of.node];
}

Vec3 RigPoser::shaped_position(const RigVertex& vertex) const {
  Vec3 sum = vertex.position;
  const std::vector<double>& weights = morph_weights_[vertex.instance];
  for (std::size_t i = 0; i < vertex.deltas.size(); ++i) sum = sum + vertex.deltas[i].position * weights[i];
  return sum;
}

Vec3 RigPoser::shaped_normal(const RigVertex& vertex) const {
  Vec3 sum = vertex.normal;
  const std::vector<double>& weights = morph_weights_[vertex.instance];
  for (std::size_t i = 0; i < vertex.deltas.size(); ++i) sum = sum + vertex.deltas[i].normal * weights[i];
  return sum;
}

Vec3 carried_normal(const RigPoser& rest, const RigVertex& vertex, Vec3 normal) {
  const Affine joint = rest.place(vertex.instance, vertex.joints[0]);
  const std::optional<Affine> back = inverse(joint);
  return back ? back->direction(joint.normal(normal)) : normal;
}

Vec3 posed_normal(const RigPoser& rest, const RigPoser& poser, const RigVertex& vertex) {
  const Affine place = poser.place(vertex);
  const Vec3 shaped = poser.shaped_normal(vertex);
  const bool follows_joints = vertex.weights[0] > 0;
  return follows_joints ? place.direction(carried_normal(rest, vertex, shaped)) : place.normal(shaped);
}

std::vector<bool> mirrored_vertices(const Rig& rig, const RigPose& pose) {
  const RigPoser rest(rig, rest_pose(rig));
  const RigPoser poser(rig, pose);
  std::vector<bool> mirrored;
  mirrored.reserve(rig.vertices.size());
  for (const RigVertex& vertex : rig.vertices)
    mirrored.push_back(poser.place(vertex).mirrors() != rest.place(vertex).mirrors());
  return mirrored;
}

Vec3 stored_normal(const RigVertex& vertex, Vec3 at_rest, const RigPoser& rest) {
  if (vertex.normal != Vec3{}) return vertex.normal;
  const Affine place = rest.place(vertex);
  const Vec3 back{dot(place.x, at_rest), dot(place.y, at_rest), dot(place.z, at_rest)};
  return length(back) > 0 ? normalised(back) : at_rest;
}

Model posed(const Model& model, const RigPose& pose, const std::string& subject) {
  Model out = model;
  out.rig = nullptr;
  if (model.rig == nullptr) return out;
  const RigPoser rest(*model.rig, rest_pose(*model.rig));
  const RigPoser poser(*model.rig, pose);
  const std::vector<bool> mirrored = mirrored_vertices(*model.rig, pose);
  for (ModelPart& part : out.parts) {
    MeshData& mesh = part.mesh;
    for (std::size_t i = 0; i < mesh.sources.size(); ++i) {
      if (mesh.sources[i] == kNoSource) continue;
      RigVertex vertex = model.rig->vertices[mesh.sources[i]];
      vertex.normal = stored_normal(vertex, mesh.normals[i], rest);
      mesh.positions[i] = poser.position(vertex);
      if (!finite(mesh.positions[i]) || length(mesh.positions[i]) > kMostCoordinate)
        throw Failure(subject, "a coordinate of the pose is not a number up to 1e30");
      const Vec3 normal = posed_normal(rest, poser, vertex);
      // A joint of no size leaves no normal, and none is seen.
      if (finite(normal) && length(normal) > 0) mesh.normals[i] = normalised(normal);
    }
    for (std::array<std::uint32_t, 3>& t : mesh.triangles) {
      const std::uint32_t source = mesh.sources.empty() ? kNoSource : mesh.sources[t[0]];
      if (source != kNoSource && mirrored[source]) std::swap(t[1], t[2]);
    }
    mesh.sources.clear();
  }
  return out;
}

}  // namespace arcspan::tools
