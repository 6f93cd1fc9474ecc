// SPDX-License-Identifier: MIT
#include <arcspan/animate/stored_animation.hpp>
#include <arcspan/numbers/little_endian.hpp>

namespace arcspan {

namespace {

/// The records of a chunk that begins with their number, or none if there is no chunk.
template <class T>
std::span<const T> counted(std::span<const std::uint8_t> chunk) {
  if (chunk.data() == nullptr) return {};
  return {detail::elements_at<T>(chunk.data() + animation_binary::kCountBytes), little_u16(chunk.data())};
}

bool are_equal(const char* a, const char* b) {
  for (; *a == *b; ++a, ++b) {
    if (*a == '\0') return true;
  }
  return false;
}

}  // namespace

StoredWeights::StoredWeights(const std::uint8_t* chunk)
    : vertices_(static_cast<std::size_t>(little_u32(chunk + animation_binary::kVerticesAt))),
      skin_(little_u16(chunk + animation_binary::kSkinAt)) {
  if (vertices_ == 0) {
    records_ =
        detail::elements_at<std::uint16_t>(chunk + animation_binary::kJointAt);  // a record of one joint
    return;
  }
  first_ = detail::elements_at<std::uint16_t>(chunk + animation_binary::kFirstAt);
  records_ = first_ + vertices_;
}

VertexJoints StoredWeights::vertex(std::size_t i) const {
  if (!exist()) return {};
  const std::uint16_t* const words = record(i);
  VertexJoints vertex;
  vertex.count = ((words[0] >> 8) & 3u) + 1u;
  vertex.joints[0] = static_cast<std::uint8_t>(words[0]);
  std::uint16_t first = 1u << animation_binary::kWeightBits;
  for (std::size_t k = 1; k < vertex.count; ++k) {
    vertex.joints[k] = static_cast<std::uint8_t>(words[k]);
    const unsigned low = (words[0] >> (8 + 2 * k)) & 3u;
    vertex.weights[k] = static_cast<std::uint16_t>(((unsigned{words[k]} >> 8) << 2) | low);
    first = static_cast<std::uint16_t>(first - vertex.weights[k]);
  }
  vertex.weights[0] = first;
  return vertex;
}

StoredMorph::StoredMorph(const std::uint8_t* chunk) {
  const std::size_t targets = little_u16(chunk + animation_binary::kTargetsAt);
  vertices_ = static_cast<std::size_t>(little_u32(chunk + animation_binary::kMorphVerticesAt));
  weights_ = {detail::elements_at<std::int16_t>(chunk + animation_binary::kMorphWeightsAt), targets};
  const std::size_t first = animation_binary::kMorphWeightsAt + 2 * targets;
  const std::size_t end = first + 2 * (vertices_ + 1);
  first_ = detail::elements_at<std::uint16_t>(chunk + first);
  records_ = detail::elements_at<MorphRecord>(chunk + (end + 3) / 4 * 4);
  stride_ = (little_u16(chunk + animation_binary::kFlagsAt) & animation_binary::kMorphedNormals) != 0 ? 2 : 1;
}

const std::int16_t* StoredMorph::normal(std::size_t i) const {
  return static_cast<const std::int16_t*>(static_cast<const void*>(&record(i) + 1));
}

const char* StoredAnimation::node_name(std::size_t i) const {
  const std::span<const std::uint8_t> names = chunks_.find(animation_binary::kNamesTag);
  return names.data() == nullptr ? ""
                                 : detail::elements_at<char>(names.data() + i * animation_binary::kNameBytes);
}

std::size_t StoredAnimation::find_node(const char* name) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (are_equal(node_name(i), name)) return i;
  }
  return kNone;
}

std::span<const StoredJoint> StoredAnimation::skin(std::size_t i) const {
  return counted<StoredJoint>(find(animation_binary::kSkinTag, i));
}

StoredClip StoredAnimation::clip(std::size_t i) const {
  return StoredClip(find(animation_binary::kClipTag, i).data());
}

std::size_t StoredAnimation::find_clip(const char* name) const {
  for (std::size_t i = 0; i < clip_count_; ++i) {
    if (are_equal(clip(i).name(), name)) return i;
  }
  return kNone;
}

StoredWeights StoredAnimation::weights(std::size_t part) const {
  const std::span<const std::uint8_t> chunk = find(animation_binary::kWeightsTag, part);
  return chunk.data() == nullptr ? StoredWeights() : StoredWeights(chunk.data());
}

StoredMorph StoredAnimation::morph(std::size_t part) const {
  const std::span<const std::uint8_t> chunk = find(animation_binary::kMorphTag, part);
  return chunk.data() == nullptr ? StoredMorph() : StoredMorph(chunk.data());
}

std::span<const JointBound> StoredAnimation::bounds(std::size_t part) const {
  return counted<JointBound>(find(animation_binary::kBoundsTag, part));
}

}  // namespace arcspan
