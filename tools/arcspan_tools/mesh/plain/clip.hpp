// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// How a channel goes from key to key.
enum class Interpolation : std::uint8_t {
  kStep,    ///< each value stays until the next key
  kLinear,  ///< along a line, rotations along the shorter arc
  kCubic    ///< along Hermite splines, whose tangents are values per second
};

/// What of a node a channel moves.
enum class ChannelPath : std::uint8_t { kTranslation, kRotation, kScale, kMorphWeights };

/// One property of a node over time.
struct RigChannel {
  std::size_t node = 0;
  ChannelPath path = ChannelPath::kTranslation;
  Interpolation interpolation = Interpolation::kLinear;
  std::size_t components = 3;   ///< of a value: 3, of rotations 4, of morph weights as many as targets
  std::vector<double> times{};  ///< in seconds from the clip's beginning, 0 or more, ascending
  /// Values one after the other; of kCubic three for each key, which are the tangent towards it, its value,
  /// and the tangent from it.
  std::vector<double> values{};

  [[nodiscard]] std::size_t keys() const { return times.size(); }
  [[nodiscard]] const double* value(std::size_t key) const;

  /// The value at `time`; before the first key and after the last that of the key. Rotations are of unit
  /// length: x, y, z, w.
  [[nodiscard]] std::vector<double> at(double time) const;
};

/// A named animation.
struct RigClip {
  std::string name{};
  std::vector<RigChannel> channels{};

  /// The time of the last key in seconds.
  [[nodiscard]] double duration() const;
};

/// Most keys of a channel.
inline constexpr std::size_t kMostKeys = 65'535;
/// The keys of a file have at most this many numbers in all.
inline constexpr std::size_t kMostKeyNumbers = std::size_t{1} << 24;

/// Checks the times of a channel's keys. Returns what is wrong with them, or nothing.
[[nodiscard]] std::optional<std::string> wrong_times(const std::vector<double>& times);

/// Checks the values of a channel, whose times must be right. Returns what is wrong with them, or nothing.
[[nodiscard]] std::optional<std::string> wrong_values(const RigChannel& channel);

/// Gives a name to clips without one ("clip1"), and another one to clips that are called as an earlier one.
void name_clips(std::vector<RigClip>& clips);

/// `names` of at most `most` bytes. Longer ones are cut at a whole UTF-8 character, and end in a number if
/// that makes the name of another.
[[nodiscard]] std::vector<std::string> shortened(std::vector<std::string> names, std::size_t most);

}  // namespace arcspan::tools
