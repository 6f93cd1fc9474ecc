// SPDX-License-Identifier: MIT
#include <arcspan/animate/animation_binary.hpp>

#include <arcspan_tools/output/animation_writer.hpp>
#include <arcspan_tools/output/bytes.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <map>

namespace arcspan::tools {
namespace {

template <class Number>
void put(std::string& out, Number value, int bytes) {
  append_number(out, static_cast<std::uint64_t>(static_cast<std::int64_t>(value)), bytes);
}

template <class Numbers>
void put_all(std::string& out, const Numbers& values, int bytes) {
  for (const auto value : values) put(out, value, bytes);
}

void put_name(std::string& out, std::string name) {
  name.resize(animation_binary::kNameBytes - 1);
  out += name + '\0';
}

void put_sphere(std::string& out, const BoundingSphere& sphere) {
  for (const std::int16_t value : {sphere.middle.x, sphere.middle.y, sphere.middle.z}) put(out, value, 2);
  put(out, sphere.radius, 2);
}

void fill(std::string& out) {
  while (out.size() % chunk_list::kAlignment != 0) out.push_back('\0');
}

std::string nodes_chunk(const std::vector<FixedNode>& nodes) {
  std::string out;
  put(out, nodes.size(), 4);
  for (const FixedNode& node : nodes) {
    put(out, node.parent ? *node.parent : std::size_t{animation_binary::kNoParent}, 4);
    put_all(out, node.translation, 4);
    put_all(out, node.rotation, 2);
    put_all(out, node.scale, 4);
  }
  return out;
}

std::string names_chunk(const std::vector<FixedNode>& nodes) {
  std::string out;
  for (const FixedNode& node : nodes) put_name(out, node.name);
  return out;
}

std::string skin_chunk(const FixedSkin& skin) {
  std::string out;
  put(out, skin.size(), 4);
  for (const FixedJoint& joint : skin) {
    put(out, joint.node, 4);
    for (const std::array<std::int32_t, 4>& row : joint.rows) put_all(out, row, 4);
  }
  return out;
}

/// The half-words of a vertex.
std::vector<std::uint16_t> record_of(const FixedWeights& weights) {
  std::size_t head = weights.joints[0] | (weights.count - 1) << 8;
  for (std::size_t k = 1; k < weights.count; ++k) head |= std::size_t{weights.weights[k] & 3u} << (8 + 2 * k);
  std::vector<std::uint16_t> record = {static_cast<std::uint16_t>(head)};
  for (std::size_t k = 1; k < weights.count; ++k)
    record.push_back(static_cast<std::uint16_t>(weights.joints[k] | (weights.weights[k] >> 2) << 8));
  return record;
}

std::string weights_chunk(const FixedPartMotion& part, const std::string& subject) {
  const auto& all = part.weights;
  const bool is_rigid =
      std::all_of(all.begin(), all.end(), [&](const FixedWeights& w) { return w == all[0]; }) &&
      all[0].count == 1;
  std::string out;
  put(out, part.skin, 2);
  put(out, is_rigid ? all[0].joints[0] : std::uint16_t{0}, 2);
  put(out, is_rigid ? 0 : all.size(), 4);
  std::map<std::vector<std::uint16_t>, std::size_t> known;  // where each record begins
  std::vector<std::uint16_t> records;
  std::string first;
  for (std::size_t i = 0; !is_rigid && i < all.size(); ++i) {
    const std::vector<std::uint16_t> record = record_of(all[i]);
    const auto [at, is_new] = known.try_emplace(record, records.size());
    if (is_new) records.insert(records.end(), record.begin(), record.end());
    put(first, at->second, 2);
  }
  if (records.size() > animation_binary::kMostWords)
    throw Failure(subject, "the vertices of a part have too many different weights");
  put(out, records.size(), 4);
  out += first;
  put_all(out, records, 2);
  return out;
}

std::string morph_chunk(const FixedMorph& morph, const std::string& subject) {
  std::string first;
  std::string records;
  std::size_t count = 0;
  put(first, count, 2);
  for (const std::vector<FixedMorphRecord>& of_vertex : morph.records) {
    for (const FixedMorphRecord& record : of_vertex) {
      put(records, record.target, 2);
      put_all(records, record.position, 2);
      if (!morph.has_normals) continue;
      put_all(records, record.normal, 2);
      put(records, 0, 2);
    }
    count += of_vertex.size();
    put(first, count, 2);
  }
  if (count > animation_binary::kMostRecords)
    throw Failure(subject, "the morph targets of a part move too many vertices");
  std::string out;
  put(out, morph.weights.size(), 2);
  put(out, morph.has_normals ? animation_binary::kMorphedNormals : 0, 2);
  put(out, morph.records.size(), 4);
  put(out, count, 4);
  put_all(out, morph.weights, 2);
  out += first;
  fill(out);
  return out + records;
}

std::string bounds_chunk(const std::vector<FixedBound>& bounds) {
  std::string out;
  put(out, bounds.size(), 4);
  for (const FixedBound& bound : bounds) {
    put(out, bound.joint, 4);
    put_sphere(out, bound.sphere);
  }
  return out;
}

std::string clip_chunk(const FixedClip& clip) {
  std::string head;
  put(head, clip.duration, 4);
  put(head, clip.channels.size(), 4);
  put_name(head, clip.name);
  const std::size_t begin = animation_binary::kClipBytes + clip.channels.size() * sizeof(StoredChannel);
  std::map<std::vector<std::uint32_t>, std::size_t> times;  // where each list is
  std::string body;
  for (const FixedChannel& channel : clip.channels) {
    const auto [at, is_new] = times.try_emplace(channel.times, begin + body.size());
    if (is_new) put_all(body, channel.times, 4);
    put(head, channel.target, 2);
    put(head, static_cast<int>(channel.path), 1);
    put(head, static_cast<int>(channel.interpolation), 1);
    put(head, at->second, 4);
    put(head, begin + body.size(), 4);
    put(head, channel.times.size(), 4);
    const bool is_short =
        channel.path == ChannelPath::kRotation || channel.path == ChannelPath::kMorphWeights;
    put_all(body, channel.values, is_short ? 2 : 4);
    fill(body);
  }
  return head + body;
}

}  // namespace

std::vector<FileChunk> animation_chunks(const FixedAnimation& animation, const std::string& subject) {
  std::vector<FileChunk> chunks;
  const auto& parts = animation.parts;
  const auto add = [&chunks](std::uint32_t tag, std::size_t number, std::string bytes) {
    chunks.push_back({tag, number, std::move(bytes)});
  };
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].bounds.empty()) add(animation_binary::kBoundsTag, i, bounds_chunk(parts[i].bounds));
  }
  for (std::size_t i = 0; i < animation.clips.size(); ++i)
    add(animation_binary::kClipTag, i, clip_chunk(animation.clips[i]));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].morph) add(animation_binary::kMorphTag, i, morph_chunk(*parts[i].morph, subject));
  }
  if (!animation.nodes.empty()) {
    add(animation_binary::kNamesTag, 0, names_chunk(animation.nodes));
    add(animation_binary::kNodesTag, 0, nodes_chunk(animation.nodes));
  }
  for (std::size_t i = 0; i < animation.skins.size(); ++i)
    add(animation_binary::kSkinTag, i, skin_chunk(animation.skins[i]));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].weights.empty()) add(animation_binary::kWeightsTag, i, weights_chunk(parts[i], subject));
  }
  return chunks;
}

}  // namespace arcspan::tools
