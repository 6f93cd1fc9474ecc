// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/scene_clips.hpp>
#include <arcspan_tools/mesh/file/scene_numbers.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace arcspan::tools {
namespace {

std::vector<double> value_of(const NodeTransform& node, ChannelPath path) {
  const Quaternion& q = node.rotation;
  if (path == ChannelPath::kRotation) return {q.x, q.y, q.z, q.w};
  const Vec3& v = path == ChannelPath::kTranslation ? node.translation : node.scale;
  return {v.x, v.y, v.z};
}

/// True if all keys of a channel have the node's value at rest, within the rounding of floats.
bool keeps_rest(const RigChannel& channel, const RigNode& node) {
  if (channel.path == ChannelPath::kMorphWeights) return false;
  constexpr double kRounding = 1e-5;
  const std::vector<double> rest = value_of(node.rest, channel.path);
  for (std::size_t key = 0; key < channel.keys(); ++key) {
    double size = 0;
    double to_rest = 0;
    double to_negated = 0;  // q and -q are one rotation
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const double value = channel.value(key)[i];
      size += rest[i] * rest[i];
      to_rest += (value - rest[i]) * (value - rest[i]);
      to_negated += (value + rest[i]) * (value + rest[i]);
    }
    const double apart = channel.path == ChannelPath::kRotation ? std::min(to_rest, to_negated) : to_rest;
    if (apart > kRounding * kRounding * size) return false;
  }
  return true;
}

/// The loader library writes translations, rotations and scales for each animated node. Takes out channels
/// that move nothing, unless the clip would become shorter.
void drop_still_channels(RigClip& clip, const std::vector<RigNode>& nodes) {
  const double end = clip.duration();
  const auto is_still = [&](const RigChannel& c) { return keeps_rest(c, nodes[c.node]); };
  bool has_end = std::any_of(clip.channels.begin(), clip.channels.end(),
                             [&](const RigChannel& c) { return c.times.back() == end && !is_still(c); });
  std::erase_if(clip.channels, [&](const RigChannel& c) {
    if (!is_still(c)) return false;
    const bool is_end = !has_end && c.times.back() == end;
    has_end = has_end || is_end;
    return !is_end;
  });
}

void check(const RigNode& node, const std::optional<std::string>& wrong) {
  if (wrong) throw Failure("the node " + in_quotes(node.name), *wrong);
}

RigChannel read_channel(const nlohmann::json& json, std::vector<RigNode>& nodes,
                        const std::function<std::size_t(std::size_t)>& morph_targets) {
  RigChannel channel;
  channel.node = json["node"].get<std::size_t>();
  const auto path = json["path"].get<unsigned>();
  channel.path = static_cast<ChannelPath>(path);
  channel.times = scene_numbers<double>(json, "times");
  channel.values = scene_numbers<double>(json, "values");
  RigNode& node = nodes.at(channel.node);
  if (path > static_cast<unsigned>(ChannelPath::kMorphWeights)) check(node, "has a channel of no property");
  if (channel.path == ChannelPath::kMorphWeights) {
    channel.components = morph_targets(channel.node);
    if (channel.components == 0) check(node, "has meshes without morph targets, or with different ones");
  } else {
    channel.components = channel.path == ChannelPath::kRotation ? 4 : 3;
    if (split_matrix(node))
      check(node, "has a matrix that is not made of a translation, a rotation and a scale");
  }
  check(node, wrong_times(channel.times));
  check(node, wrong_values(channel));
  return channel;
}

}  // namespace

std::vector<RigClip> scene_clips(const nlohmann::json& scene, std::vector<RigNode>& nodes,
                                 const std::function<std::size_t(std::size_t)>& morph_targets,
                                 std::vector<std::string>& warnings) {
  std::vector<RigClip> clips;
  std::size_t numbers = 0;  // of clips that are not left out
  for (const nlohmann::json& json : scene["clips"]) {
    RigClip clip;
    clip.name = json["name"].get<std::string>();
    std::size_t own_numbers = 0;
    try {
      std::set<std::pair<std::size_t, ChannelPath>> taken;  // nodes with the same name are one
      for (const nlohmann::json& listed : json["channels"]) {
        RigChannel channel = read_channel(listed, nodes, morph_targets);
        if (!taken.insert({channel.node, channel.path}).second) continue;
        own_numbers += channel.values.size();
        if (numbers + own_numbers > kMostKeyNumbers) throw Failure("the file", "has too many keys");
        clip.channels.push_back(std::move(channel));
      }
    } catch (const Failure& failure) {
      warnings.push_back("the animation " + in_quotes(clip.name) + " is left out: " + failure.what());
      continue;
    }
    numbers += own_numbers;
    drop_still_channels(clip, nodes);
    if (!clip.channels.empty()) clips.push_back(std::move(clip));
  }
  name_clips(clips);
  return clips;
}

}  // namespace arcspan::tools
