// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/clip_player.hpp>
#include <arcspan/animate/node_matrix.hpp>
#include <arcspan/animate/stored_animation.hpp>

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace arcspan::tools {

/// A clip of a model, and how long it lasts.
struct ClipLength {
  std::string name{};
  double seconds = 0;
};

/// The clips of a model that was read from a file of any kind.
[[nodiscard]] std::vector<ClipLength> clips_of(const Model& model);

/// Whether joints, nodes or morph targets move a model.
[[nodiscard]] inline bool moves(const Model& model) {
  return model.rig != nullptr || model.binary != nullptr;
}

/// A model that moves, posed as a device poses it: by the library, in integers, from the bytes that
/// `arcspan mesh` writes. There are two differences: normals are rounded once more, to the 32 bits of a
/// mesh at rest, and triangles turn round where a pose mirrors them, unless the model was read from a binary.
/// A rig that cannot be stored is posed in doubles, and a warning says so.
class RuntimeModel {
 public:
  RuntimeModel(const Model& model, const std::string& subject);
  /// Of a compiled model that has its animation. Throws a Failure about `subject` if that cannot be stored.
  RuntimeModel(const FixedModel& model, const std::string& subject);

  /// At a time of a clip, which is limited to its duration; without a clip of this name at rest.
  [[nodiscard]] FixedModel posed(const std::string& clip, double seconds) const;

 private:
  void view_binary();
  [[nodiscard]] FixedModel posed_in_doubles(const std::string& clip, double seconds) const;
  void pose_part(std::size_t part, std::span<const NodeMatrix> nodes, const ClipBlend& blend,
                 FixedMesh& posed) const;

  std::string subject_;
  std::map<std::string, std::string> clip_names_;  ///< those of the binary, by the names of the file
  Model in_doubles_;                               ///< with a rig that cannot be stored
  FixedModel stored_;                              ///< as it is before it is posed
  std::shared_ptr<const Rig> rig_;                 ///< of a model of another program's file, or null
  std::shared_ptr<const MovingBinary> binary_;
  StoredModel model_;
  StoredAnimation animation_;
};

/// `like` with the positions, normals and triangles of `posed`, which has the same vertices, and without
/// motion.
[[nodiscard]] Model posed_like(const Model& like, const FixedModel& posed);

}  // namespace arcspan::tools
