// SPDX-License-Identifier: MIT
// The time of clips: speed, ends, fades.
#include <arcspan/animate/clip_player.hpp>
#include <arcspan/animate/key_frame.hpp>
#include <arcspan/animate/stored_animation.hpp>

#include <catch2/catch.hpp>
#include <tests/support/animated_rig.hpp>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// Clips of 2 s and of 1 s.
struct TwoClips {
  TwoClips() {
    Rig rig = tube(2, 1, 20000, 1000, 1);
    rig.clips.push_back(bending(rig, Interpolation::kLinear, 20));
    rig.clips.push_back(
        {"short", 1'000'000, {{0, ChannelPath::kScale, Interpolation::kStep, {0}, {{1, 1, 1}}}}});
    file = rig.file();
    StoredModel model;
    StoredAnimation animation;
    REQUIRE(ok(view_model_binary(file, model)));
    REQUIRE(ok(view_animation(model, animation)));
    bend = animation.clip(0);
    brief = animation.clip(1);
  }
  Bytes file;
  StoredClip bend;
  StoredClip brief;
};

}  // namespace

TEST_CASE("a clip repeats, or stops at its end") {
  const TwoClips clips;
  ClipPlayer player(clips.bend);
  player.advance(1'999'999);
  CHECK(player.time() == 1'999'999);
  player.advance(1);
  CHECK(player.time() == 0);
  player.advance(4'000'000'000u);
  CHECK(player.time() == 0);
  CHECK_FALSE(player.has_ended());
  player.seek(2'000'000);
  player.advance(0);
  CHECK(player.time() == 2'000'000);
  player.set_speed(ClipSpeed{});
  player.advance(1'000'000);
  CHECK(player.time() == 2'000'000);
  player.set_speed(ClipSpeed::of(1));

  player.play(clips.bend, AtClipEnd::kStop);
  player.advance(1'999'999);
  CHECK_FALSE(player.has_ended());
  player.advance(4'000'000'000u);
  CHECK(player.time() == 2'000'000);
  CHECK(player.has_ended());
  player.seek(5);
  CHECK(player.time() == 5);
  player.seek(5'000'000);
  CHECK(player.time() == 2'000'000);
}

TEST_CASE("many short steps at any speed are as long as few long ones") {
  const TwoClips clips;
  ClipPlayer player(clips.bend);
  player.set_speed(ClipSpeed::of(0.3));
  for (int i = 0; i < 1'000'000; ++i) player.advance(1);
  CHECK(player.time() == (1'000'000ull * static_cast<unsigned>(ClipSpeed::of(0.3).raw())) >> 16);
  player.seek(100'000);
  player.set_speed(ClipSpeed::of(-1.0));
  player.advance(300'000);
  CHECK(player.time() == 1'800'000);
  player.play(clips.bend, AtClipEnd::kStop);
  player.advance(1);
  CHECK(player.time() == 0);
  CHECK(player.has_ended());
  player.set_speed(ClipSpeed::from_raw(INT32_MIN));
  player.advance(UINT32_MAX);
  CHECK(player.time() == 0);
}

TEST_CASE("a fade moves both clips, and ends with the second") {
  const TwoClips clips;
  ClipPlayer player(clips.bend);
  player.advance(100'000);
  player.fade_to(clips.brief, 400'000);
  CHECK(player.blend().weight == 0);
  player.advance(100'000);
  CHECK(player.fades());
  CHECK(player.blend().weight == 16384);
  CHECK(player.blend().from.time == 200'000);
  CHECK(player.blend().to.time == 100'000);
  player.advance(299'999);
  CHECK(player.fades());
  CHECK(player.blend().weight < 65536);
  player.advance(1);
  CHECK_FALSE(player.fades());
  CHECK(player.blend().from.clip.duration() == 1'000'000);
  CHECK(player.time() == 400'000);
  player.fade_to(clips.bend, 0);
  CHECK_FALSE(player.fades());
  CHECK(player.time() == 0);
}

TEST_CASE("a player without a clip stays at rest") {
  ClipPlayer player;
  player.advance(1000);
  CHECK(player.time() == 0);
  CHECK(player.blend().weight == 0);
  CHECK(player.has_ended());
}

TEST_CASE("a time is found among keys, and the way to the next") {
  const std::uint32_t times[] = {10, 20, 21, 1'000'000'021};
  const auto at = [&](std::uint32_t time) { return key_place(times, 4, time); };
  CHECK(at(0).key == 0);
  CHECK(at(0).fraction == 0);
  CHECK(at(10).fraction == 0);
  CHECK(at(15).key == 0);
  CHECK(at(15).fraction == 16384);
  CHECK(at(20).key == 1);
  CHECK(at(20).fraction == 0);
  CHECK(at(500'000'021).key == 2);
  CHECK(at(500'000'021).fraction == 16384);
  CHECK(at(1'000'000'020).fraction == 32767);
  CHECK(at(1'000'000'021).key == 3);
  CHECK(at(1'000'000'021).fraction == 0);
  CHECK(at(UINT32_MAX).key == 3);
  CHECK(key_place(times, 1, 500).key == 0);
}
