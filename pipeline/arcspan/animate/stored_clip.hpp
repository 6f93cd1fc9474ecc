// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/animation_binary.hpp>
#include <arcspan/numbers/little_endian.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// A clip in a model binary, made by StoredAnimation::clip().
class StoredClip {
 public:
  /// A clip of no channels.
  constexpr StoredClip() = default;
  /// The clip of a chunk that view_animation() has accepted.
  constexpr explicit StoredClip(const std::uint8_t* chunk) : chunk_(chunk) {}

  /// Microseconds, 1...2^30; 0 for a clip that was default-constructed.
  [[nodiscard]] std::uint32_t duration() const {
    return chunk_ == nullptr ? 0 : little_u32(chunk_ + animation_binary::kDurationAt);
  }
  /// Within the binary.
  [[nodiscard]] const char* name() const {
    return chunk_ == nullptr ? "" : detail::elements_at<char>(chunk_ + animation_binary::kNameAt);
  }
  /// In the order of their targets and paths.
  [[nodiscard]] std::span<const StoredChannel> channels() const {
    if (chunk_ == nullptr) return {};
    return {detail::elements_at<StoredChannel>(chunk_ + animation_binary::kClipBytes),
            little_u16(chunk_ + animation_binary::kChannelsAt)};
  }
  /// The times of the keys of a channel, microseconds, which increase; `channel.keys` of them.
  [[nodiscard]] const std::uint32_t* times(const StoredChannel& channel) const {
    return detail::elements_at<std::uint32_t>(chunk_ + static_cast<std::size_t>(channel.times));
  }
  /// The values of a channel: of type StoredTranslation, StoredRotation, StoredScale, or std::int16_t for
  /// morph weights. A cubic channel has three for each key.
  template <class Value>
  [[nodiscard]] const Value* values(const StoredChannel& channel) const {
    return detail::elements_at<Value>(chunk_ + static_cast<std::size_t>(channel.values));
  }

 private:
  const std::uint8_t* chunk_ = nullptr;
};

}  // namespace arcspan
