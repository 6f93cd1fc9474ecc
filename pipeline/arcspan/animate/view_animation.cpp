// SPDX-License-Identifier: MIT
// What view_animation() checks, chunk by chunk.
#include <arcspan/animate/stored_animation.hpp>
#include <arcspan/mesh/mesh_chunk.hpp>
#include <arcspan/numbers/little_endian.hpp>

#include <type_traits>

namespace arcspan {

namespace {

namespace binary = animation_binary;
using Bytes = std::span<const std::uint8_t>;

bool is_name(const std::uint8_t* name) { return name[binary::kNameBytes - 1] == 0; }

bool is_within(std::int32_t value, std::int32_t limit) { return value >= -limit && value <= limit; }

bool is_length(ObjectLength length) { return is_within(length.raw(), binary::kLongestLength); }

bool is_valid(const StoredTranslation& v) { return is_length(v.x) && is_length(v.y) && is_length(v.z); }

bool is_valid(const StoredScale& v) {
  return is_within(v.x, binary::kLargestScale) && is_within(v.y, binary::kLargestScale) &&
         is_within(v.z, binary::kLargestScale);
}

/// Whether the length is 1 within 1/64; its square then is within 1/32 and less.
bool is_valid(const StoredRotation& q) {
  std::uint32_t square = 0;
  for (const std::int32_t c : {q.x, q.y, q.z, q.w}) square += static_cast<std::uint32_t>(c * c);
  // In halves of the raw unit the limits are whole: 32767 * 63 / 64 and 32767 * 65 / 64.
  constexpr std::uint32_t kLeast = 32255;
  constexpr std::uint32_t kMost = 33279;
  return square >= kLeast * kLeast && square <= kMost * kMost;
}

/// Whether a chunk is a number, a zero and as many records; there are 1...most.
bool has_records(Bytes chunk, std::size_t bytes, std::size_t most) {
  if (chunk.size() < binary::kCountBytes || little_u16(chunk.data() + 2) != 0) return false;
  const std::size_t count = little_u16(chunk.data());
  return count >= 1 && count <= most &&
         chunk.size() - binary::kCountBytes == static_cast<std::uint32_t>(count) * bytes;
}

Status check_nodes(Bytes chunk) {
  if (!has_records(chunk, sizeof(StoredNode), binary::kMostNodes)) return Status::kCorrupted;
  const auto* const nodes = detail::elements_at<StoredNode>(chunk.data() + binary::kCountBytes);
  const std::size_t count = little_u16(chunk.data());
  for (std::size_t i = 0; i < count; ++i) {
    const StoredNode& node = nodes[i];
    if (node.parent != binary::kNoParent && node.parent >= count) return Status::kIndexOutOfRange;
    if ((node.parent != binary::kNoParent && node.parent >= i) || node.zero != 0 ||
        !is_valid(node.translation) || !is_valid(node.rotation) || !is_valid(node.scale))
      return Status::kCorrupted;
  }
  return Status::kOk;
}

Status check_names(Bytes chunk, std::size_t nodes) {
  if (nodes == 0 || chunk.size() != static_cast<std::uint32_t>(nodes) * binary::kNameBytes)
    return Status::kCorrupted;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (!is_name(chunk.data() + i * binary::kNameBytes)) return Status::kCorrupted;
  }
  return Status::kOk;
}

Status check_skin(Bytes chunk, std::size_t nodes) {
  if (nodes == 0 || !has_records(chunk, sizeof(StoredJoint), binary::kMostJoints)) return Status::kCorrupted;
  const auto* const joints = detail::elements_at<StoredJoint>(chunk.data() + binary::kCountBytes);
  for (std::size_t i = 0; i < little_u16(chunk.data()); ++i) {
    if (joints[i].node >= nodes) return Status::kIndexOutOfRange;
    if (joints[i].zero != 0) return Status::kCorrupted;
    for (const StoredMatrixRow& row : joints[i].rows) {
      if (!is_length(row.offset)) return Status::kCorrupted;
    }
  }
  return Status::kOk;
}

/// Checks the joints and weights of a vertex, whose record has `left` half-words at most.
Status check_record(const std::uint16_t* words, std::uint32_t left, std::size_t joints) {
  const std::size_t count = ((words[0] >> 8) & 3u) + 1u;
  if (count > left) return Status::kCorrupted;
  std::uint32_t sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::uint32_t low = k == 0 ? 0 : (words[0] >> (8 + 2 * k)) & 3u;
    if (k >= count) {
      if (low != 0) return Status::kCorrupted;
      continue;
    }
    if ((words[k] & 0xFFu) >= joints) return Status::kIndexOutOfRange;
    if (k == 0) continue;
    const std::uint32_t weight = ((unsigned{words[k]} >> 8) << 2) | low;
    if (weight == 0) return Status::kCorrupted;
    sum += weight;
  }
  return sum < (1u << binary::kWeightBits) ? Status::kOk : Status::kCorrupted;
}

/// Checks chunk WGHT of a part of so many vertices; `skin` is that of the chunk, or empty.
Status check_weights(Bytes chunk, std::size_t part_vertices, std::span<const StoredJoint> skin) {
  if (chunk.size() < binary::kFirstAt) return Status::kCorrupted;
  const std::uint8_t* const at = chunk.data();
  const std::uint32_t vertices = little_u32(at + binary::kVerticesAt);
  const std::uint32_t words = little_u32(at + binary::kWordsAt);
  const std::uint16_t joint = little_u16(at + binary::kJointAt);
  if (skin.empty()) return Status::kIndexOutOfRange;
  if (words > binary::kMostWords || (vertices != 0 ? vertices != part_vertices || joint != 0 : words != 0) ||
      std::uint64_t{chunk.size()} != binary::kFirstAt + 2 * (std::uint64_t{vertices} + words))
    return Status::kCorrupted;
  if (vertices == 0 && joint >= skin.size()) return Status::kIndexOutOfRange;
  const auto* const first = detail::elements_at<std::uint16_t>(at + binary::kFirstAt);
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices); ++i) {
    if (first[i] >= words) return Status::kCorrupted;
    const Status status =
        check_record(first + static_cast<std::size_t>(vertices) + first[i], words - first[i], skin.size());
    if (!ok(status)) return status;
  }
  return Status::kOk;
}

/// Checks the lists of records of a chunk MRPH whose header and size are right.
Status check_morph_records(const std::uint8_t* chunk, std::size_t vertices) {
  const StoredMorph morph(chunk);
  if (morph.first(0) != 0 || morph.first(vertices) != little_u32(chunk + binary::kRecordsAt))
    return Status::kCorrupted;
  for (std::size_t i = 0; i < vertices; ++i) {
    if (morph.first(i) > morph.first(i + 1)) return Status::kCorrupted;
  }
  for (std::size_t i = 0; i < vertices; ++i) {
    std::size_t next = 0;  // the least target that may follow
    for (std::size_t j = morph.first(i); j < morph.first(i + 1); ++j) {
      const std::size_t target = morph.record(j).target;
      if (target >= morph.target_count()) return Status::kIndexOutOfRange;
      if (target < next || (morph.has_normals() && morph.normal(j)[3] != 0)) return Status::kCorrupted;
      next = target + 1;
    }
  }
  return Status::kOk;
}

Status check_morph(Bytes chunk, std::size_t part_vertices) {
  if (chunk.size() < binary::kMorphWeightsAt) return Status::kCorrupted;
  const std::uint8_t* const at = chunk.data();
  const std::uint32_t targets = little_u16(at + binary::kTargetsAt);
  const std::uint16_t flags = little_u16(at + binary::kFlagsAt);
  const std::uint32_t records = little_u32(at + binary::kRecordsAt);
  if (targets == 0 || targets > binary::kMostTargets || flags > binary::kMorphedNormals ||
      little_u32(at + binary::kMorphVerticesAt) != part_vertices || records > binary::kMostRecords)
    return Status::kCorrupted;
  const std::uint32_t arrays = static_cast<std::uint32_t>(binary::kMorphWeightsAt) + 2 * targets +
                               2 * (static_cast<std::uint32_t>(part_vertices) + 1);
  if (chunk.size() != (arrays + 3) / 4 * 4 + (flags != 0 ? 2u : 1u) * records * binary::kShortRecordBytes)
    return Status::kCorrupted;
  return check_morph_records(at, part_vertices);
}

Status check_bounds(Bytes chunk, std::size_t joints) {
  if (joints == 0 || !has_records(chunk, sizeof(JointBound), binary::kMostJoints)) return Status::kCorrupted;
  const auto* const bounds = detail::elements_at<JointBound>(chunk.data() + binary::kCountBytes);
  for (std::size_t i = 0; i < little_u16(chunk.data()); ++i) {
    if (bounds[i].joint >= joints) return Status::kIndexOutOfRange;
    if (bounds[i].zero != 0 || (i != 0 && bounds[i].joint <= bounds[i - 1].joint)) return Status::kCorrupted;
  }
  return Status::kOk;
}

/// Whether so many bytes from `begin` on lie in the chunk at a multiple of 4 and behind its `head` bytes.
bool lies_within(Bytes chunk, std::uint32_t head, std::uint32_t begin, std::uint32_t bytes) {
  return begin % chunk_list::kAlignment == 0 && begin >= head && begin <= chunk.size() &&
         bytes <= chunk.size() - begin;
}

bool are_times(const std::uint32_t* times, std::size_t count, std::uint32_t duration) {
  for (std::size_t i = 1; i < count; ++i) {
    if (times[i] <= times[i - 1]) return false;
  }
  return times[count - 1] <= duration;
}

template <class Value>
bool are_valid(const StoredClip& clip, const StoredChannel& channel) {
  const bool is_cubic = channel.interpolation == Interpolation::kCubic;
  const std::size_t count = (is_cubic ? 3u : 1u) * std::size_t{channel.keys};
  for (std::size_t i = 0; i < count; ++i) {
    // Tangents of rotations have any length.
    if (std::is_same_v<Value, StoredRotation> && is_cubic && i % 3 != 1) continue;
    if (!is_valid(clip.values<Value>(channel)[i])) return false;
  }
  return true;
}

bool has_valid_values(const StoredClip& clip, const StoredChannel& channel) {
  switch (channel.path) {
    case ChannelPath::kTranslation:
      return are_valid<StoredTranslation>(clip, channel);
    case ChannelPath::kRotation:
      return are_valid<StoredRotation>(clip, channel);
    case ChannelPath::kScale:
      return are_valid<StoredScale>(clip, channel);
    default:
      return true;
  }
}

/// Bytes of a value of a channel; `targets` are those of the part that it morphs.
std::uint32_t bytes_of_value(const StoredChannel& channel, std::size_t targets) {
  if (channel.path == ChannelPath::kMorphWeights) return 2 * static_cast<std::uint32_t>(targets);
  return channel.path == ChannelPath::kRotation ? sizeof(StoredRotation) : sizeof(StoredTranslation);
}

/// The place of a channel among those of its clip: nodes first.
std::uint32_t order_of(const StoredChannel& channel) {
  const bool morphs = channel.path == ChannelPath::kMorphWeights;
  return (std::uint32_t{morphs} << 18) | (std::uint32_t{channel.target} << 2) |
         static_cast<std::uint32_t>(channel.path);
}

/// Checks a channel of a clip; `morph_targets`: how many the part of its target has.
Status check_channel(Bytes chunk, const StoredChannel& channel, std::size_t morph_targets) {
  const StoredClip clip(chunk.data());
  if (channel.interpolation > Interpolation::kCubic || channel.keys == 0 || channel.zero != 0)
    return Status::kCorrupted;
  const auto head =
      static_cast<std::uint32_t>(binary::kClipBytes + clip.channels().size() * sizeof(StoredChannel));
  const std::uint32_t values =
      std::uint32_t{channel.keys} * (channel.interpolation == Interpolation::kCubic ? 3u : 1u);
  if (!lies_within(chunk, head, channel.times, std::uint32_t{channel.keys} * 4) ||
      !lies_within(chunk, head, channel.values, values * bytes_of_value(channel, morph_targets)) ||
      !are_times(clip.times(channel), channel.keys, clip.duration()) || !has_valid_values(clip, channel))
    return Status::kCorrupted;
  return Status::kOk;
}

Status check_clip(Bytes chunk, const StoredAnimation& animation) {
  if (chunk.size() < binary::kClipBytes) return Status::kCorrupted;
  const std::uint8_t* const at = chunk.data();
  const std::size_t count = little_u16(at + binary::kChannelsAt);
  const StoredClip clip(at);
  if (clip.duration() == 0 || clip.duration() > binary::kLongestTime ||
      little_u16(at + binary::kChannelsAt + 2) != 0 || !is_name(at + binary::kNameAt) || count == 0 ||
      (chunk.size() - binary::kClipBytes) / sizeof(StoredChannel) < count)
    return Status::kCorrupted;
  const std::span<const StoredChannel> channels = clip.channels();
  for (std::size_t i = 0; i < count; ++i) {
    const StoredChannel& channel = channels[i];
    if (channel.path > ChannelPath::kMorphWeights ||
        (i != 0 && order_of(channel) <= order_of(channels[i - 1])))
      return Status::kCorrupted;
    const bool morphs = channel.path == ChannelPath::kMorphWeights;
    const std::size_t targets = morphs ? animation.morph(channel.target).target_count() : 0;
    if (morphs ? targets == 0 : channel.target >= animation.nodes().size()) return Status::kIndexOutOfRange;
    const Status status = check_channel(chunk, channel, targets);
    if (!ok(status)) return status;
  }
  return Status::kOk;
}

/// Checks the chunks of a model one after another: first what others name, then those others.
class AnimationCheck {
 public:
  AnimationCheck(const StoredModel& model, const StoredAnimation& animation, std::size_t nodes)
      : model_(model), animation_(animation), nodes_(nodes) {}

  static constexpr int kPasses = 3;
  /// Checks a chunk if `pass`, 1...kPasses, is its own. (A table of the checks would keep all of them in
  /// programs that call none.)
  [[nodiscard]] Status run(int pass, const Chunk& chunk) const {
    if (pass != pass_of(chunk.tag)) return Status::kOk;
    switch (chunk.tag) {
      case binary::kNodesTag:
        return chunk.number == 0 ? check_nodes(chunk.bytes) : Status::kCorrupted;
      case binary::kNamesTag:
        return chunk.number == 0 ? check_names(chunk.bytes, nodes_) : Status::kCorrupted;
      case binary::kSkinTag:
        return check_skin(chunk.bytes, nodes_);
      case binary::kMorphTag:
        return is_part(chunk) ? check_morph(chunk.bytes, vertices_of(chunk)) : Status::kIndexOutOfRange;
      case binary::kWeightsTag:
        return is_part(chunk) ? check_weights(chunk.bytes, vertices_of(chunk), skin_of(chunk.bytes))
                              : Status::kIndexOutOfRange;
      case binary::kClipTag:
        return check_clip(chunk.bytes, animation_);
      case binary::kBoundsTag:
        return check_bounds_of(animation_.weights(static_cast<std::size_t>(chunk.number)), chunk.bytes);
      default:
        return Status::kOk;
    }
  }

 private:
  /// Chunks that name only nodes and vertices come first, then those that name skins and morph targets, then
  /// the bounds of parts, which need weights.
  [[nodiscard]] static int pass_of(std::uint32_t tag) {
    if (tag == binary::kBoundsTag) return 3;
    return tag == binary::kWeightsTag || tag == binary::kClipTag ? 2 : 1;
  }
  [[nodiscard]] Status check_bounds_of(const StoredWeights& weights, Bytes chunk) const {
    return check_bounds(chunk, weights.exist() ? animation_.skin(weights.skin()).size() : 0);
  }
  [[nodiscard]] bool is_part(const Chunk& chunk) const { return chunk.number < model_.part_count(); }
  [[nodiscard]] std::size_t vertices_of(const Chunk& chunk) const {
    return detail::mesh_of_chunk(model_.chunks().find(model_binary::kMeshTag, chunk.number).data())
        .vertex_count();
  }
  /// The joints of the skin that a chunk WGHT names; empty if there is none.
  [[nodiscard]] std::span<const StoredJoint> skin_of(Bytes weights) const {
    if (weights.size() < binary::kFirstAt) return {};
    const std::size_t skin = little_u16(weights.data() + binary::kSkinAt);
    return skin < animation_.skin_count() ? animation_.skin(skin) : std::span<const StoredJoint>();
  }

  const StoredModel& model_;
  const StoredAnimation& animation_;
  std::size_t nodes_;
};

/// Counts the chunks of a tag, whose numbers have no gaps; kNone if they have.
std::size_t count_of(const ChunkList& chunks, std::uint32_t tag) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const Chunk chunk = chunks[i];
    if (chunk.tag != tag) continue;
    if (chunk.number != count) return StoredAnimation::kNone;
    ++count;
  }
  return count;
}

}  // namespace

Status view_animation(const StoredModel& model, StoredAnimation& animation) {
  StoredAnimation found;
  found.chunks_ = model.chunks();
  found.skin_count_ = count_of(found.chunks_, binary::kSkinTag);
  found.clip_count_ = count_of(found.chunks_, binary::kClipTag);
  if (found.skin_count_ == StoredAnimation::kNone || found.clip_count_ == StoredAnimation::kNone)
    return Status::kCorrupted;
  const Bytes nodes = found.chunks_.find(binary::kNodesTag);
  if (nodes.data() != nullptr) {
    const Status status = check_nodes(nodes);
    if (!ok(status)) return status;
    found.nodes_ = {detail::elements_at<StoredNode>(nodes.data() + binary::kCountBytes),
                    little_u16(nodes.data())};
  }
  const AnimationCheck check(model, found, found.nodes_.size());
  for (int pass = 1; pass <= AnimationCheck::kPasses; ++pass) {
    for (std::size_t i = 0; i < found.chunks_.size(); ++i) {
      const Status status = check.run(pass, found.chunks_[i]);
      if (!ok(status)) return status;
    }
  }
  animation = found;
  return Status::kOk;
}

}  // namespace arcspan
