// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/stored_clip.hpp>
#include <arcspan/numbers/fixed.hpp>

#include <cstdint>

namespace arcspan {

/// Factor of a clip's time, 16 fraction bits: 1 is the clip's own speed, below 0 is backwards.
using ClipSpeed = Fixed<std::int32_t, 16>;

/// How a clip goes on when its end is reached.
enum class AtClipEnd : std::uint8_t {
  kStop,   ///< its last pose stays; backwards, the first
  kRepeat  ///< it begins again
};

/// A clip at a time: microseconds, 0...duration().
struct ClipMoment {
  StoredClip clip;
  std::uint32_t time = 0;
};

/// One clip, or the way from one to another.
struct ClipBlend {
  ClipMoment from;
  ClipMoment to;
  std::uint32_t weight = 0;  ///< of `to`, in 65536ths: 0...65536; with 0 `to` is not read
};

/// Plays clips: keeps the time of one, and of a second while it fades to that. It reads no keys;
/// pose_nodes() does, of blend().
///
///     ClipPlayer player(animation.clip(walk));
///     for (;;) {                                 // frames
///       player.advance(microseconds);
///       pose_nodes(animation, player.blend(), nodes);
///       ...
///     }
class ClipPlayer {
 public:
  /// Plays nothing: all nodes are at rest.
  constexpr ClipPlayer() = default;
  /// Plays a clip from its beginning.
  explicit ClipPlayer(const StoredClip& clip, AtClipEnd at_end = AtClipEnd::kRepeat) { play(clip, at_end); }

  /// Plays another clip from its beginning, at once.
  void play(const StoredClip& clip, AtClipEnd at_end = AtClipEnd::kRepeat);
  /// Fades to another clip, which begins now, in so many microseconds; both move meanwhile. If a fade is
  /// under way, its first clip ends at once.
  void fade_to(const StoredClip& clip, std::uint32_t microseconds, AtClipEnd at_end = AtClipEnd::kRepeat);
  /// Sets the speed of all clips. Fades take the same time at every speed.
  void set_speed(ClipSpeed speed) { speed_ = speed; }
  /// Moves the clip, or that which it fades to, to a time, which is limited to its duration.
  void seek(std::uint32_t microseconds);
  /// Moves on. Fractions of a microsecond are kept, so that many short steps are as long as few long ones.
  void advance(std::uint32_t microseconds);

  /// True if a clip that stops has come to its end, and nothing fades.
  [[nodiscard]] bool has_ended() const;
  [[nodiscard]] bool fades() const { return fade_length_ != 0; }
  /// The time of the clip, or of that which it fades to, in microseconds.
  [[nodiscard]] std::uint32_t time() const { return fades() ? next_.time : now_.time; }
  /// The clips and times for pose_nodes().
  [[nodiscard]] ClipBlend blend() const;

 private:
  struct Playing {
    StoredClip clip;
    std::uint32_t time = 0;
    std::uint16_t fraction = 0;  ///< of a microsecond, in 65536ths
    AtClipEnd at_end = AtClipEnd::kStop;

    void advance(std::uint32_t microseconds, ClipSpeed speed);
  };

  Playing now_;
  Playing next_;
  std::uint32_t faded_ = 0;        ///< microseconds, below fade_length_ while there is a fade
  std::uint32_t fade_length_ = 0;  ///< 0 without a fade
  ClipSpeed speed_ = ClipSpeed::from_raw(std::int32_t{1} << ClipSpeed::kFraction);
};

}  // namespace arcspan
