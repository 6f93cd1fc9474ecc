// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/animation_binary.hpp>
#include <arcspan/animate/node_matrix.hpp>
#include <arcspan/animate/stored_clip.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// A time among the keys of a channel.
struct KeyPlace {
  std::size_t key = 0;         ///< the last key that is not after the time, or the first one
  std::uint32_t fraction = 0;  ///< of the way to the next key, in 32768ths; 0 if there is none
};

/// The place of `time` among `count` times that increase, at least one.
[[nodiscard]] KeyPlace key_place(const std::uint32_t* times, std::size_t count, std::uint32_t time);

/// Reads the channels of a clip at one time. Channels of nodes must be read in the order of the nodes.
class ClipSampler {
 public:
  /// A clip without channels leaves every node as it is.
  ClipSampler(const StoredClip& clip, std::uint32_t time) : clip_(clip), time_(time) {}

  /// Sets what the clip changes of `node`. Nodes are asked for in increasing order.
  void set(std::size_t node, NodePose& pose);
  /// Moves the weights of a part's morph targets, 12 fraction bits, by `weight` 65536ths (0...65536) towards
  /// those of the clip, or to those at rest if the clip has none. `weights` are as many as `rest`.
  void blend_weights(std::size_t part, std::span<const std::int16_t> rest, std::uint32_t weight,
                     std::int16_t* weights);

 private:
  /// The place of the time in the list of a channel, of which the last is kept.
  [[nodiscard]] KeyPlace place_in(const StoredChannel& channel);

  StoredClip clip_;
  std::uint32_t time_;
  std::size_t next_ = 0;  ///< the first channel of this node or a later one
  std::uint32_t kept_times_ = 0;
  std::uint16_t kept_keys_ = 0;
  KeyPlace kept_place_;
};

}  // namespace arcspan
