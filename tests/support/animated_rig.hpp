// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/animation_binary.hpp>

#include <tests/pipeline/model/chunk_bytes.hpp>
#include <tests/support/vec3.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// Animated models in double precision: where their vertices are, and as model binaries written from
/// docs/animation-binary.md. Neither uses the code that is tested.
namespace arcspan::test {

using Quat = std::array<double, 4>;  ///< x, y, z, w

[[nodiscard]] Quat about(Vec3 axis, double degrees);

/// A matrix and a translation.
struct Affine {
  double m[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vec3 t;

  [[nodiscard]] Vec3 linear(Vec3 v) const;
  [[nodiscard]] Vec3 operator()(Vec3 v) const { return linear(v) + t; }
  [[nodiscard]] Affine inverse() const;
};
[[nodiscard]] Affine operator*(const Affine& outer, const Affine& inner);
[[nodiscard]] Affine affine(Vec3 translation, Quat rotation, Vec3 scale);

struct RigNode {
  int parent = -1;
  Vec3 translation;
  Quat rotation{0, 0, 0, 1};
  Vec3 scale{1, 1, 1};
};

struct RigJoint {
  int node = 0;
  Affine bind;
};

struct RigWeight {
  int joint;
  int weight;  ///< in 1024ths; the first of a vertex is what the others leave
};

/// What a morph target adds.
struct RigMorph {
  int target;
  Vec3 position;
  Vec3 normal;
};

struct RigVertex {
  Vec3 position;  ///< whole numbers
  Vec3 normal;
  std::vector<RigWeight> weights;
  std::vector<RigMorph> morphs;
};

/// As in glTF: a key has one value, or an in-tangent, a value and an out-tangent, here multiplied by the time
/// between keys.
struct RigChannel {
  int target;
  ChannelPath path;
  Interpolation interpolation;
  std::vector<std::uint32_t> times;
  std::vector<std::vector<double>> values;
};

struct RigClip {
  std::string name;
  std::uint32_t duration;
  std::vector<RigChannel> channels;
};

/// A model of one part with one skin.
struct Rig {
  std::vector<RigNode> nodes;
  std::vector<RigJoint> joints;
  std::vector<RigVertex> vertices;
  std::vector<int> indices;
  std::vector<RigClip> clips;
  int follows_joint = -1;  ///< of the whole mesh; -1: vertices have weights
  int targets = 0;

  /// The matrix of each node at a time of a clip; at rest with clip -1.
  [[nodiscard]] std::vector<Affine> pose(int clip, double microseconds) const;
  /// The weights of the morph targets.
  [[nodiscard]] std::vector<double> morph(int clip, double microseconds) const;
  struct Placed {
    Vec3 position;
    Vec3 normal;
  };
  [[nodiscard]] Placed placed(std::size_t vertex, const std::vector<Affine>& pose,
                              const std::vector<double>& morph) const;

  [[nodiscard]] std::vector<TestChunk> chunks() const;
  [[nodiscard]] Bytes file() const { return file_of(chunks()); }
};

/// A tube along y of `length` with `joints` joints, that is bound straight. Vertices have `influences`
/// weights (1...4). The joints are bound in a space that is `bind_scale` times as large, below a node that is
/// turned and scaled back.
[[nodiscard]] Rig tube(int joints, int influences, double length, double radius, double bind_scale);

/// A clip of 2 s in which each joint of a tube turns, with keys of this kind.
[[nodiscard]] RigClip bending(const Rig& rig, Interpolation interpolation, double degrees);

}  // namespace arcspan::test
