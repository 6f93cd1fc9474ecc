// SPDX-License-Identifier: MIT
#include <arcspan/animate/clip_player.hpp>

namespace arcspan {

void ClipPlayer::Playing::advance(std::uint32_t microseconds, ClipSpeed speed) {
  const auto duration = static_cast<std::int64_t>(clip.duration());
  if (duration == 0) return;
  const std::int64_t step = static_cast<std::int64_t>(microseconds) * speed.raw() + fraction;  // below 2^63
  std::int64_t moved = static_cast<std::int64_t>(time) + (step >> ClipSpeed::kFraction);
  fraction = static_cast<std::uint16_t>(step);
  if ((step >> ClipSpeed::kFraction) == 0) return;  // a clip that repeats would leave its end
  if (moved < 0 || moved >= duration) {
    if (at_end == AtClipEnd::kStop) {
      moved = moved < 0 ? 0 : duration;
    } else {
      moved %= duration;
      if (moved < 0) moved += duration;
    }
  }
  time = static_cast<std::uint32_t>(moved);
}

void ClipPlayer::play(const StoredClip& clip, AtClipEnd at_end) {
  now_ = {clip, 0, 0, at_end};
  next_ = {};
  faded_ = 0;
  fade_length_ = 0;
}

void ClipPlayer::fade_to(const StoredClip& clip, std::uint32_t microseconds, AtClipEnd at_end) {
  if (microseconds == 0) return play(clip, at_end);
  if (fades()) now_ = next_;
  next_ = {clip, 0, 0, at_end};
  faded_ = 0;
  fade_length_ = microseconds;
}

void ClipPlayer::seek(std::uint32_t microseconds) {
  Playing& playing = fades() ? next_ : now_;
  const std::uint32_t duration = playing.clip.duration();
  playing.time = microseconds < duration ? microseconds : duration;
  playing.fraction = 0;
}

void ClipPlayer::advance(std::uint32_t microseconds) {
  now_.advance(microseconds, speed_);
  if (!fades()) return;
  next_.advance(microseconds, speed_);
  if (microseconds < fade_length_ - faded_) {
    faded_ += microseconds;
    return;
  }
  now_ = next_;
  next_ = {};
  faded_ = 0;
  fade_length_ = 0;
}

bool ClipPlayer::has_ended() const {
  if (fades() || now_.at_end == AtClipEnd::kRepeat) return false;
  return now_.time == (speed_.raw() < 0 ? 0 : now_.clip.duration());
}

ClipBlend ClipPlayer::blend() const {
  ClipBlend blend{{now_.clip, now_.time}, {}, 0};
  if (!fades()) return blend;
  blend.to = {next_.clip, next_.time};
  blend.weight = static_cast<std::uint32_t>((std::uint64_t{faded_} << 16) / fade_length_);
  return blend;
}

}  // namespace arcspan
