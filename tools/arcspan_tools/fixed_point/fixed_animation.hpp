// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/bounding_sphere.hpp>
#include <arcspan/mesh/packed_normal.hpp>

#include <arcspan_tools/mesh/plain/clip.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// The contents of the chunks of docs/animation-binary.md, whose formats these are.

namespace arcspan::tools {

struct FixedNode {
  std::string name{};
  std::optional<std::size_t> parent{};  ///< an earlier node
  std::array<std::int32_t, 3> translation{};
  std::array<std::int16_t, 4> rotation{};
  std::array<std::int32_t, 3> scale{};
};

struct FixedJoint {
  std::size_t node = 0;
  std::array<std::array<std::int32_t, 4>, 3> rows{};  ///< three entries and a length each

  friend bool operator==(const FixedJoint&, const FixedJoint&) = default;
};

using FixedSkin = std::vector<FixedJoint>;

/// The joints of a vertex and their weights in 1024ths, the largest first; the sum is 1024.
struct FixedWeights {
  std::size_t count = 1;
  std::array<std::uint16_t, 4> joints{};
  std::array<std::uint16_t, 4> weights{1024};

  friend bool operator==(const FixedWeights&, const FixedWeights&) = default;
};

struct FixedMorphRecord {
  std::size_t target = 0;
  std::array<std::int16_t, 3> position{};
  std::array<std::int16_t, 3> normal{};
};

struct FixedMorph {
  std::vector<std::int16_t> weights{};  ///< of each target when no clip sets them
  bool has_normals = false;
  std::vector<std::vector<FixedMorphRecord>> records{};  ///< of each vertex
};

struct FixedBound {
  std::size_t joint = 0;
  BoundingSphere sphere{};
};

/// What moves the vertices of a part.
struct FixedPartMotion {
  std::size_t skin = 0;
  std::vector<FixedWeights> weights{};  ///< of each vertex; empty if the part does not follow the nodes
  std::optional<FixedMorph> morph{};
  std::vector<FixedBound> bounds{};
};

struct FixedChannel {
  std::size_t target = 0;  ///< a node, or of morph weights a part
  ChannelPath path = ChannelPath::kTranslation;
  Interpolation interpolation = Interpolation::kLinear;
  std::size_t components = 3;
  std::vector<std::uint32_t> times{};  ///< microseconds
  std::vector<std::int32_t> values{};
};

struct FixedClip {
  std::string name{};
  std::uint32_t duration = 1;  ///< microseconds
  std::vector<FixedChannel> channels{};
};

struct FixedAnimation {
  std::vector<FixedNode> nodes{};
  std::vector<FixedSkin> skins{};
  std::vector<FixedPartMotion> parts{};
  std::vector<FixedClip> clips{};
  std::vector<std::string> cut_names{};    ///< those of the file that are longer than the format's
  std::vector<std::string> still_clips{};  ///< of the file, left out because they move nothing of the model
};

}  // namespace arcspan::tools
