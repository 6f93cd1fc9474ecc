// SPDX-License-Identifier: MIT
// The chunks of animation in a model binary: what is read from them, and each reason to refuse one.
#include <arcspan/animate/stored_animation.hpp>

#include <catch2/catch.hpp>
#include <tests/support/animated_rig.hpp>

#include <string_view>

using namespace arcspan;
using namespace arcspan::test;

namespace {

// Chunks of rig() in the order of the file.
enum : std::size_t { kBounds, kClip, kMesh, kModel, kMorph, kNames, kNodes, kParts, kSkin, kWeights };

/// A tube of three joints with four weights per vertex, two morph targets and a clip of four channels.
Rig rig() {
  Rig rig = tube(3, 4, 20000, 1000, 1);
  rig.targets = 2;
  rig.vertices[0].morphs = {{0, {1, 2, 3}, {0.5, 0, 0}}, {1, {-4, -5, -6}, {0, 0, -0.5}}};
  rig.vertices[5].morphs = {{1, {7, 8, 9}, {0, 0.25, 0}}};
  rig.clips.push_back(bending(rig, Interpolation::kLinear, 20));
  RigClip& clip = rig.clips[0];
  clip.channels.resize(2);
  clip.channels.push_back({2, ChannelPath::kScale, Interpolation::kStep, {0, 7}, {{1, 2, 3}, {-1, 0.5, 64}}});
  clip.channels.push_back(
      {0, ChannelPath::kMorphWeights, Interpolation::kStep, {0, 2'000'000}, {{0, 1}, {-0.5, 7}}});
  return rig;
}

Status status_of(const std::vector<TestChunk>& chunks) {
  const Bytes file = file_of(chunks);
  StoredModel model;
  REQUIRE(ok(view_model_binary(file, model)));
  StoredAnimation animation;
  const Status status = view_animation(model, animation);
  if (!ok(status)) CHECK(animation.nodes().empty());
  return status;
}

/// The status with some bytes of a chunk changed.
Status status_with(std::size_t chunk, std::size_t at, std::uint64_t value, int bytes) {
  static const std::vector<TestChunk> kChunks = rig().chunks();
  std::vector<TestChunk> chunks = kChunks;
  put(chunks[chunk].bytes, at, value, bytes);
  return status_of(chunks);
}

/// The status with a chunk of another size.
Status status_resized(std::size_t chunk, int by) {
  std::vector<TestChunk> chunks = rig().chunks();
  Bytes& bytes = chunks[chunk].bytes;
  bytes.resize(bytes.size() + static_cast<std::size_t>(by));
  return status_of(chunks);
}

Status status_without(std::size_t chunk) {
  std::vector<TestChunk> chunks = rig().chunks();
  chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(chunk));
  return status_of(chunks);
}

constexpr std::size_t channel_at(std::size_t i) { return 40 + 16 * i; }

}  // namespace

TEST_CASE("all that is animated is read where it lies") {
  const Rig written = rig();
  const Bytes file = written.file();
  StoredModel model;
  REQUIRE(ok(view_model_binary(file, model)));
  StoredAnimation animation;
  REQUIRE(view_animation(model, animation) == Status::kOk);

  REQUIRE(animation.nodes().size() == 4);
  CHECK(animation.nodes()[0].parent == animation_binary::kNoParent);
  CHECK(animation.nodes()[0].translation.y == ObjectLength::of(-200));
  CHECK(animation.nodes()[3].parent == 2);
  CHECK(std::string_view(animation.node_name(3)) == "node 3");
  CHECK(animation.find_node("node 2") == 2);
  CHECK(animation.find_node("node") == StoredAnimation::kNone);

  REQUIRE(animation.skin_count() == 1);
  REQUIRE(animation.skin(0).size() == 3);
  CHECK(animation.skin(0)[2].node == 3);
  CHECK(animation.skin(0)[0].rows[1].offset.raw() == 256 * 10000);

  const StoredWeights weights = animation.weights(0);
  REQUIRE(weights.exist());
  CHECK_FALSE(weights.are_of_one_joint());
  for (std::size_t i = 0; i < written.vertices.size(); ++i) {
    const std::vector<RigWeight>& truth = written.vertices[i].weights;
    const VertexJoints vertex = weights.vertex(i);
    REQUIRE(vertex.count == truth.size());
    int sum = 0;
    for (std::size_t k = 0; k < vertex.count; ++k) {
      CHECK(vertex.joints[k] == truth[k].joint);
      if (k != 0) CHECK(vertex.weights[k] == truth[k].weight);
      sum += vertex.weights[k];
    }
    CHECK(sum == 1024);
  }
  CHECK_FALSE(animation.weights(1).exist());

  const StoredMorph morph = animation.morph(0);
  CHECK(morph.target_count() == 2);
  CHECK(morph.first(0) == 0);
  CHECK(morph.first(1) == 2);
  CHECK(morph.first(6) - morph.first(5) == 1);
  CHECK(morph.record(2).target == 1);
  CHECK(morph.record(2).position == ObjectPosition{7, 8, 9});
  REQUIRE(morph.has_normals());
  CHECK(morph.normal(1)[2] == -8192);

  CHECK(animation.bounds(0).size() == 3);
  CHECK(animation.bounds(0)[1].joint == 1);
  CHECK(animation.bounds(1).empty());

  REQUIRE(animation.clip_count() == 1);
  CHECK(animation.find_clip("bend") == 0);
  CHECK(animation.find_clip("") == StoredAnimation::kNone);
  const StoredClip clip = animation.clip(0);
  CHECK(clip.duration() == 2'000'000);
  REQUIRE(clip.channels().size() == 4);
  CHECK(clip.times(clip.channels()[2])[1] == 7);
  CHECK(clip.values<StoredScale>(clip.channels()[2])[1].z == 64 * 65536);
  CHECK(clip.values<std::int16_t>(clip.channels()[3])[2] == -2048);
}

TEST_CASE("a model without chunks of animation has an empty one") {
  std::vector<TestChunk> chunks = rig().chunks();
  const std::vector<TestChunk> still{chunks[kMesh], chunks[kModel], chunks[kParts]};
  CHECK(status_of(still) == Status::kOk);
  const Bytes file = file_of(still);
  StoredModel model;
  REQUIRE(ok(view_model_binary(file, model)));
  StoredAnimation animation;
  REQUIRE(ok(view_animation(model, animation)));
  CHECK(animation.nodes().empty());
  CHECK(animation.skin_count() == 0);
  CHECK(animation.clip_count() == 0);
  CHECK(animation.morph(0).target_count() == 0);
  CHECK(std::string_view(animation.node_name(0)).empty());
}

TEST_CASE("chunks of another size than they state are refused") {
  for (const std::size_t chunk : {kBounds, kMorph, kNames, kNodes, kSkin, kWeights}) {
    CAPTURE(chunk);
    CHECK(status_resized(chunk, -4) == Status::kCorrupted);
    CHECK(status_resized(chunk, 4) == Status::kCorrupted);
  }
  CHECK(status_resized(kClip, -4) == Status::kCorrupted);
  for (const std::size_t chunk : {kBounds, kClip, kMorph, kNames, kNodes, kSkin, kWeights}) {
    CAPTURE(chunk);
    std::vector<TestChunk> chunks = rig().chunks();
    chunks[chunk].bytes.clear();
    CHECK_FALSE(ok(status_of(chunks)));
  }
}

TEST_CASE("weights without a whole head are refused before they are read") {
  std::vector<TestChunk> chunks = rig().chunks();
  chunks[kWeights].bytes.resize(8);
  CHECK(status_of(chunks) == Status::kCorrupted);
}

TEST_CASE("a chunk that another requires must be there") {
  CHECK(status_without(kNodes) == Status::kCorrupted);
  CHECK(status_without(kSkin) == Status::kIndexOutOfRange);
  CHECK(status_without(kMorph) == Status::kIndexOutOfRange);  // a clip names it
  CHECK(status_without(kWeights) == Status::kCorrupted);      // there are bounds
  CHECK(status_without(kBounds) == Status::kOk);
  CHECK(status_without(kNames) == Status::kOk);
  CHECK(status_without(kClip) == Status::kOk);
  std::vector<TestChunk> chunks = rig().chunks();
  chunks[kSkin].number = 1;
  CHECK(status_of(chunks) == Status::kCorrupted);
  chunks = rig().chunks();
  chunks[kClip].number = 1;
  CHECK(status_of(chunks) == Status::kCorrupted);
  chunks = rig().chunks();
  chunks[kWeights].number = 1;
  CHECK(status_of(chunks) == Status::kIndexOutOfRange);
}

TEST_CASE("nodes are refused if parents come late or numbers are out of range") {
  const std::size_t second = 4 + 36;
  CHECK(status_with(kNodes, 2, 1, 2) == Status::kCorrupted);
  CHECK(status_with(kNodes, second, 0xFFFF, 2) == Status::kOk);
  CHECK(status_with(kNodes, second, 1, 2) == Status::kCorrupted);  // its own parent
  CHECK(status_with(kNodes, second, 2, 2) == Status::kCorrupted);
  CHECK(status_with(kNodes, second, 4, 2) == Status::kIndexOutOfRange);
  CHECK(status_with(kNodes, second + 2, 1, 2) == Status::kCorrupted);
  CHECK(status_with(kNodes, second + 8, (1u << 30) - 1, 4) == Status::kOk);
  CHECK(status_with(kNodes, second + 8, 1u << 30, 4) == Status::kCorrupted);
  CHECK(status_with(kNodes, second + 8, 0u - (1u << 30), 4) == Status::kCorrupted);
  CHECK(status_with(kNodes, second + 16, 0, 8) == Status::kCorrupted);  // no rotation at all
  CHECK(status_with(kNodes, second + 16, 32256, 8) == Status::kOk);     // (1 - 1/64, 0, 0, 0)
  CHECK(status_with(kNodes, second + 16, 32254, 8) == Status::kCorrupted);
  CHECK(status_with(kNodes, second + 24, 64 << 16, 4) == Status::kOk);
  CHECK(status_with(kNodes, second + 24, (64 << 16) + 1, 4) == Status::kCorrupted);
  CHECK(status_with(kNames, 31, 'x', 1) == Status::kCorrupted);
}

TEST_CASE("a skin names nodes that are there") {
  CHECK(status_with(kSkin, 4, 4, 2) == Status::kIndexOutOfRange);
  CHECK(status_with(kSkin, 6, 1, 2) == Status::kCorrupted);
  CHECK(status_with(kSkin, 4 + 4 + 12, 1u << 30, 4) == Status::kCorrupted);  // an offset
}

TEST_CASE("weights name joints that are there, and do not add up to more than 1") {
  const std::size_t vertices = rig().vertices.size();
  const std::size_t records = 12 + 2 * vertices;
  CHECK(status_with(kWeights, 0, 1, 2) == Status::kIndexOutOfRange);  // the skin
  CHECK(status_with(kWeights, 2, 1, 2) == Status::kCorrupted);        // a joint of the whole mesh
  CHECK(status_with(kWeights, 4, vertices - 1, 4) == Status::kCorrupted);
  CHECK(status_with(kWeights, 12, 0xFFFF, 2) == Status::kCorrupted);  // where a record begins
  CHECK(status_with(kWeights, records, 0x0002, 2) == Status::kOk);    // joint 2 alone
  CHECK(status_with(kWeights, records, 0x0003, 2) == Status::kIndexOutOfRange);
  CHECK(status_with(kWeights, records, 0x0402, 2) == Status::kCorrupted);      // a bit of a weight too many
  CHECK(status_with(kWeights, records, 0xFF010D00, 4) == Status::kOk);         // 1023 of joint 1
  CHECK(status_with(kWeights, records, 0x00010100, 4) == Status::kCorrupted);  // 0 of joint 1
  CHECK(status_with(kWeights, records, 0x0001'FF01'1E00, 6) == Status::kCorrupted);  // 1023 and 1
  // The last vertex begins at the last half-word, but has more.
  const std::size_t words = (rig().chunks()[kWeights].bytes.size() - records) / 2;
  CHECK(status_with(kWeights, 12, words - 1, 2) != Status::kIndexOutOfRange);
  std::vector<TestChunk> chunks = rig().chunks();
  put(chunks[kWeights].bytes, 12, words - 1, 2);
  put(chunks[kWeights].bytes, records + 2 * (words - 1), 0x0300, 2);
  CHECK(status_of(chunks) == Status::kCorrupted);
}

TEST_CASE("a mesh that follows one joint names one that is there") {
  Rig whole = rig();
  whole.follows_joint = 2;
  CHECK(status_of(whole.chunks()) == Status::kOk);
  whole.follows_joint = 3;
  CHECK(status_of(whole.chunks()) == Status::kIndexOutOfRange);
}

TEST_CASE("morph targets are in order, and are there") {
  const std::size_t first = 12 + 2 * 2;
  const std::size_t records = (first + 2 * (rig().vertices.size() + 1) + 3) / 4 * 4;
  CHECK(status_with(kMorph, 0, 0, 2) == Status::kCorrupted);
  CHECK(status_with(kMorph, 2, 2, 2) == Status::kCorrupted);  // an unknown flag
  CHECK(status_with(kMorph, 4, 7, 4) == Status::kCorrupted);
  CHECK(status_with(kMorph, 8, 65536, 4) == Status::kCorrupted);
  CHECK(status_with(kMorph, first, 1, 2) == Status::kCorrupted);
  CHECK(status_with(kMorph, first + 2, 4, 2) == Status::kCorrupted);  // beyond the next
  CHECK(status_with(kMorph, records, 2, 2) == Status::kIndexOutOfRange);
  CHECK(status_with(kMorph, records, 1, 2) == Status::kCorrupted);  // twice the same target
  CHECK(status_with(kMorph, records + 14, 1, 2) == Status::kCorrupted);
}

TEST_CASE("bounds name joints in order") {
  CHECK(status_with(kBounds, 4, 3, 2) == Status::kIndexOutOfRange);
  CHECK(status_with(kBounds, 4, 1, 2) == Status::kCorrupted);
  CHECK(status_with(kBounds, 6, 1, 2) == Status::kCorrupted);
}

TEST_CASE("a clip is refused if a channel is not as the format says") {
  const std::size_t size = rig().chunks()[kClip].bytes.size();
  CHECK(status_with(kClip, 0, 0, 4) == Status::kCorrupted);          // no duration
  CHECK(status_with(kClip, 0, 1'999'999, 4) == Status::kCorrupted);  // a key after it
  CHECK(status_with(kClip, 0, (1u << 30) + 1, 4) == Status::kCorrupted);
  CHECK(status_with(kClip, 4, 0, 2) == Status::kCorrupted);
  CHECK(status_with(kClip, 4, 0xFFFF, 2) == Status::kCorrupted);
  CHECK(status_with(kClip, 6, 1, 2) == Status::kCorrupted);
  CHECK(status_with(kClip, 39, 'x', 1) == Status::kCorrupted);
  const std::size_t channel = channel_at(1);
  CHECK(status_with(kClip, channel, 4, 2) != Status::kOk);         // order, then range
  CHECK(status_with(kClip, channel, 1, 2) == Status::kCorrupted);  // as the one before
  CHECK(status_with(kClip, channel_at(2), 4, 2) == Status::kIndexOutOfRange);
  CHECK(status_with(kClip, channel_at(3), 1, 2) == Status::kIndexOutOfRange);  // no such part
  CHECK(status_with(kClip, channel + 2, 4, 1) == Status::kCorrupted);          // path
  CHECK(status_with(kClip, channel + 3, 3, 1) == Status::kCorrupted);          // interpolation
  CHECK(status_with(kClip, channel + 4, 100, 4) == Status::kCorrupted);        // in the channels
  CHECK(status_with(kClip, channel + 4, size, 4) == Status::kCorrupted);
  CHECK(status_with(kClip, channel + 4, 0xFFFFFFFC, 4) == Status::kCorrupted);
  CHECK(status_with(kClip, channel + 8, size - 4, 4) == Status::kCorrupted);
  CHECK(status_with(kClip, channel + 8, channel_at(4) + 2, 4) == Status::kCorrupted);  // alignment
  CHECK(status_with(kClip, channel + 12, 0, 2) == Status::kCorrupted);
  CHECK(status_with(kClip, channel + 12, 0xFFFF, 2) == Status::kCorrupted);
  CHECK(status_with(kClip, channel + 14, 1, 2) == Status::kCorrupted);
}

TEST_CASE("times of keys increase, and values are in range") {
  const std::size_t times = channel_at(4);  // of channel 0: 9 keys
  CHECK(status_with(kClip, times + 4, 0, 4) == Status::kCorrupted);
  CHECK(status_with(kClip, times + 4, 500'000, 4) == Status::kCorrupted);
  CHECK(status_with(kClip, times + 4, 1, 4) == Status::kOk);
  CHECK(status_with(kClip, times + 9 * 4, 0, 8) == Status::kCorrupted);  // a rotation
}
