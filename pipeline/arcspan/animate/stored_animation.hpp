// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/animation_binary.hpp>
#include <arcspan/animate/stored_clip.hpp>
#include <arcspan/model/model_binary.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// The joints of a vertex: at most four, with weights in 1024ths that add up to 1024.
struct VertexJoints {
  std::size_t count = 0;
  std::uint8_t joints[4] = {};
  std::uint16_t weights[4] = {};
};

/// The joints that a part of a model follows, made by StoredAnimation::weights().
class StoredWeights {
 public:
  /// Of a part that follows no joint.
  constexpr StoredWeights() = default;
  /// Of a chunk that view_animation() has accepted.
  explicit StoredWeights(const std::uint8_t* chunk);

  /// False if the part follows no joint.
  [[nodiscard]] constexpr bool exist() const { return records_ != nullptr; }
  /// True if all vertices follow joint().
  [[nodiscard]] constexpr bool are_of_one_joint() const { return exist() && first_ == nullptr; }
  /// The number of the skin.
  [[nodiscard]] constexpr std::size_t skin() const { return skin_; }
  /// The number of vertices; 0 if all follow one joint, whatever their number.
  [[nodiscard]] constexpr std::size_t vertex_count() const { return vertices_; }
  /// The record of vertex i: 1...4 half-words (docs/animation-binary.md).
  [[nodiscard]] ARCSPAN_INLINE constexpr const std::uint16_t* record(std::size_t i) const {
    return first_ == nullptr ? records_ : records_ + first_[i];
  }
  /// The joints of vertex i, which must be one of the part, unless all follow one joint.
  [[nodiscard]] VertexJoints vertex(std::size_t i) const;

 private:
  const std::uint16_t* first_ = nullptr;    ///< null if all vertices follow one joint
  const std::uint16_t* records_ = nullptr;  ///< null if the part follows no joint
  std::size_t vertices_ = 0;
  std::uint16_t skin_ = 0;
};

/// The morph targets of a part, made by StoredAnimation::morph().
class StoredMorph {
 public:
  /// Of a part without morph targets.
  constexpr StoredMorph() = default;
  /// Of a chunk that view_animation() has accepted.
  explicit StoredMorph(const std::uint8_t* chunk);

  [[nodiscard]] constexpr std::size_t target_count() const { return weights_.size(); }
  [[nodiscard]] constexpr std::size_t vertex_count() const { return vertices_; }
  /// The weights of the targets when no clip sets them, 12 fraction bits.
  [[nodiscard]] constexpr std::span<const std::int16_t> weights() const { return weights_; }
  [[nodiscard]] constexpr bool has_normals() const { return stride_ != 1; }
  /// The records of vertex i are first(i) ... first(i + 1) - 1.
  [[nodiscard]] constexpr std::size_t first(std::size_t i) const { return first_[i]; }
  [[nodiscard]] constexpr const MorphRecord& record(std::size_t i) const { return records_[i * stride_]; }
  /// What the target of record i adds to the normal at weight 1, 14 fraction bits: 3 numbers. Requires
  /// has_normals().
  [[nodiscard]] const std::int16_t* normal(std::size_t i) const;

 private:
  std::span<const std::int16_t> weights_;
  const std::uint16_t* first_ = nullptr;
  const MorphRecord* records_ = nullptr;
  std::size_t vertices_ = 0;
  std::size_t stride_ = 1;  ///< of records, in MorphRecords
};

/// What is animated in a model binary, made by view_animation(). It takes a few words and can be copied. The
/// binary must outlive it, and all that it returns.
class StoredAnimation {
 public:
  static constexpr std::size_t kNone = SIZE_MAX;

  /// The nodes; parents come before their children. Empty if the model has none.
  [[nodiscard]] constexpr std::span<const StoredNode> nodes() const { return nodes_; }
  /// The name of a node, within the binary; "" if nodes have no names.
  [[nodiscard]] const char* node_name(std::size_t i) const;
  /// The first node of this name, or kNone.
  [[nodiscard]] std::size_t find_node(const char* name) const;

  [[nodiscard]] constexpr std::size_t skin_count() const { return skin_count_; }
  /// The joints of skin i, which must be below skin_count(). At most 256.
  [[nodiscard]] std::span<const StoredJoint> skin(std::size_t i) const;

  [[nodiscard]] constexpr std::size_t clip_count() const { return clip_count_; }
  /// Clip i, which must be below clip_count().
  [[nodiscard]] StoredClip clip(std::size_t i) const;
  /// The number of the first clip of this name, or kNone.
  [[nodiscard]] std::size_t find_clip(const char* name) const;

  /// The joints of part i of the model.
  [[nodiscard]] StoredWeights weights(std::size_t part) const;
  /// The morph targets of part i of the model.
  [[nodiscard]] StoredMorph morph(std::size_t part) const;
  /// The spheres around the vertices of the joints of a part; none if the binary has none.
  [[nodiscard]] std::span<const JointBound> bounds(std::size_t part) const;

 private:
  friend Status view_animation(const StoredModel& model, StoredAnimation& animation);

  [[nodiscard]] std::span<const std::uint8_t> find(std::uint32_t tag, std::size_t number) const {
    return chunks_.find(tag, static_cast<std::uint32_t>(number));
  }

  ChunkList chunks_;
  std::span<const StoredNode> nodes_;
  std::size_t skin_count_ = 0;
  std::size_t clip_count_ = 0;
};

/// Makes a view of the animation in a model binary that view_model_binary() has accepted. A model without any
/// gives an empty view. Every chunk is checked once, in time linear in its size. Returns:
///
///   kOk                `animation` is set; otherwise it is not changed
///   kCorrupted         a chunk is missing that another requires, counts and sizes contradict each other, a
///                      parent comes after its child, weights do not add up to 1, times do not increase,
///                      or a number is out of range (docs/animation-binary.md lists all reasons)
///   kIndexOutOfRange   a node, a joint, a skin, a part or a morph target is named that is not there
[[nodiscard]] Status view_animation(const StoredModel& model, StoredAnimation& animation);

}  // namespace arcspan
