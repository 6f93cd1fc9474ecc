// SPDX-License-Identifier: MIT
#include <arcspan/animate/morphed_mesh.hpp>
#include <arcspan/animate/pose.hpp>
#include <arcspan/animate/skinned_mesh.hpp>
#include <arcspan/mesh/packed_normal.hpp>

#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/command/runtime_model.hpp>
#include <arcspan_tools/fixed_point/unit_box.hpp>
#include <arcspan_tools/mesh/compile/make_animation.hpp>
#include <arcspan_tools/mesh/compile/stored_rig.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

namespace arcspan::tools {
namespace {

std::span<const std::uint8_t> bytes_of(const MovingBinary& binary) {
  return {reinterpret_cast<const std::uint8_t*>(binary.words.data()), binary.bytes};
}

/// The binary that `arcspan mesh` would write of a model that moves, without its textures.
std::shared_ptr<const MovingBinary> compiled(const FixedModel& model, const std::string& subject) {
  FixedModel whole = model;
  if (whole.animation == nullptr)
    whole.animation = std::make_shared<FixedAnimation>(make_animation(model, {}, subject));
  for (FixedMesh& mesh : whole.meshes) mesh.texture_points.clear();
  for (PartLook& look : whole.looks) look.material.texture.reset();
  const std::string file = model_binary_file(whole, {});
  auto binary = std::make_shared<MovingBinary>();
  binary->bytes = file.size();
  binary->words.resize(file.size() / sizeof(std::uint32_t) + 1);
  std::memcpy(binary->words.data(), file.data(), file.size());
  binary->part_numbers.resize(model.meshes.size());
  std::iota(binary->part_numbers.begin(), binary->part_numbers.end(), std::size_t{0});
  return binary;
}

void require_ok(Status status, const std::string& subject) {
  if (!ok(status)) throw Failure(subject, std::string("its animation cannot be used: ") + to_string(status));
}

/// The pose of the clip of this name, or that at rest if there is none.
RigPose pose_of(const Rig& rig, const std::string& clip, double seconds) {
  RigPose pose = rest_pose(rig);
  for (const RigClip& known : rig.clips) {
    if (known.name == clip) pose = pose_at(rig, known, seconds);
  }
  return pose;
}

/// Exchanges two corners of each triangle whose first vertex is mirrored. `sources` are the vertices of the
/// rig that those of the mesh are made of.
void turn_mirrored(const std::vector<std::uint32_t>& sources, const std::vector<bool>& mirrored,
                   std::vector<std::uint16_t>& indices) {
  for (std::size_t i = 0; !sources.empty() && i < indices.size(); i += 3) {
    const std::uint32_t source = sources[indices[i]];
    if (source != kNoSource && mirrored[source]) std::swap(indices[i + 1], indices[i + 2]);
  }
}

template <class Mesh>
void take_vertices(const Mesh& mesh, FixedMesh& posed) {
  for (std::size_t i = 0; i < posed.positions.size(); ++i) {
    posed.positions[i] = mesh.position(i);
    const Direction n = mesh.direction(i);
    posed.normals[i] = pack_normal(n.x.raw(), n.y.raw(), n.z.raw());
  }
}

template <class Rest>
Status take_skinned(const Rest& rest, const StoredAnimation& animation, std::size_t part,
                    std::span<const JointMatrix> joints, FixedMesh& posed) {
  BasicSkinnedMesh<Rest> mesh;
  const Status status = BasicSkinnedMesh<Rest>::make(rest, animation, part, joints, mesh);
  if (ok(status)) take_vertices(mesh, posed);
  return status;
}

}  // namespace

std::vector<ClipLength> clips_of(const Model& model) {
  std::vector<ClipLength> clips;
  if (model.rig != nullptr) {
    for (const RigClip& clip : model.rig->clips) clips.push_back({clip.name, clip.duration()});
  }
  StoredModel stored;
  StoredAnimation animation;
  if (model.binary != nullptr && ok(view_model_binary(bytes_of(*model.binary), stored)) &&
      ok(view_animation(stored, animation))) {
    for (std::size_t i = 0; i < animation.clip_count(); ++i)
      clips.push_back({animation.clip(i).name(), animation.clip(i).duration() / 1e6});
  }
  return clips;
}

RuntimeModel::RuntimeModel(const Model& model, const std::string& subject)
    : subject_(subject), stored_(to_fixed(as_stored(model))), rig_(model.rig), binary_(model.binary) {
  try {
    if (binary_ == nullptr) binary_ = compiled(stored_, subject);
  } catch (const Failure& failure) {
    warn(subject, std::string("posed in doubles, because a device cannot: ") + failure.what());
    in_doubles_ = model;
    return;
  }
  view_binary();
}

RuntimeModel::RuntimeModel(const FixedModel& model, const std::string& subject)
    : subject_(subject), stored_(model), binary_(compiled(model, subject)) {
  view_binary();
}

void RuntimeModel::view_binary() {
  const std::string& subject = subject_;
  require_ok(view_model_binary(bytes_of(*binary_), model_), subject);
  require_ok(view_animation(model_, animation_), subject);
  if (stored_.rig != nullptr) clip_names_ = stored_clip_names(*stored_.rig);
  stored_.rig = nullptr;
  stored_.animation = nullptr;
}

void RuntimeModel::pose_part(std::size_t part, std::span<const NodeMatrix> nodes, const ClipBlend& blend,
                             FixedMesh& posed) const {
  posed.sources.clear();
  const MeshView rest = model_.part(part).mesh;
  const StoredWeights weights = animation_.weights(part);
  std::vector<JointMatrix> joints;
  if (weights.exist()) {
    const std::span<const StoredJoint> skin = animation_.skin(weights.skin());
    joints.resize(skin.size());
    require_ok(pose_joints(skin, nodes, joints), subject_);
  }
  std::vector<std::int16_t> morph(animation_.morph(part).target_count());
  if (morph.empty()) {
    if (weights.exist()) require_ok(take_skinned(rest, animation_, part, joints, posed), subject_);
    return;
  }
  require_ok(pose_morph(animation_, part, blend, morph), subject_);
  MorphedMesh shaped;
  require_ok(MorphedMesh::make(rest, animation_, part, morph, shaped), subject_);
  if (weights.exist()) {
    require_ok(take_skinned(shaped, animation_, part, joints, posed), subject_);
  } else {
    take_vertices(shaped, posed);
  }
}

FixedModel RuntimeModel::posed_in_doubles(const std::string& clip, double seconds) const {
  const RigPose pose = pose_of(*in_doubles_.rig, clip, seconds);
  const FixedMeshes meshes(stored_);
  return to_fixed(tools::posed(in_doubles_, pose, subject_), box_of_units(meshes.centre(), meshes.unit()));
}

FixedModel RuntimeModel::posed(const std::string& clip, double seconds) const {
  if (in_doubles_.rig != nullptr) return posed_in_doubles(clip, seconds);
  const auto stored = clip_names_.find(clip);
  const std::string& name = stored == clip_names_.end() ? clip : stored->second;
  const std::size_t number = animation_.find_clip(name.c_str());
  ClipBlend blend;
  if (!clip.empty() && number != StoredAnimation::kNone) {
    blend.from.clip = animation_.clip(number);
    const double duration = blend.from.clip.duration();
    blend.from.time = static_cast<std::uint32_t>(std::clamp(std::round(seconds * 1e6), 0.0, duration));
  }
  std::vector<NodeMatrix> nodes(animation_.nodes().size());
  require_ok(pose_nodes(animation_, blend, nodes), subject_);
  FixedModel posed = stored_;
  for (std::size_t i = 0; i < posed.meshes.size(); ++i)
    pose_part(binary_->part_numbers[i], nodes, blend, posed.meshes[i]);
  if (rig_ == nullptr) return posed;
  const std::vector<bool> mirrored = mirrored_vertices(*rig_, pose_of(*rig_, clip, seconds));
  for (std::size_t i = 0; i < posed.meshes.size(); ++i)
    turn_mirrored(stored_.meshes[i].sources, mirrored, posed.meshes[i].indices);
  return posed;
}

Model posed_like(const Model& like, const FixedModel& posed) {
  Model out = like;
  out.rig = nullptr;
  out.binary = nullptr;
  out.reach.reset();
  for (std::size_t part = 0; part < out.parts.size(); ++part) {
    MeshData& mesh = out.parts[part].mesh;
    const FixedMesh& from = posed.meshes[part];
    mesh.sources.clear();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const ObjectPosition& p = from.positions[i];
      mesh.positions[i] = from.centre + Vec3{double(p.x), double(p.y), double(p.z)} * from.unit;
      const Direction n = unpack_normal(from.normals[i]);
      mesh.normals[i] = normalised(Vec3{double(n.x.raw()), double(n.y.raw()), double(n.z.raw())});
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      mesh.triangles[i] = {from.indices[3 * i], from.indices[3 * i + 1], from.indices[3 * i + 2]};
  }
  return out;
}

}  // namespace arcspan::tools
