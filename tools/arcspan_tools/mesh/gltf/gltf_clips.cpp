// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/gltf_clips.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <optional>
#include <set>
#include <utility>

namespace arcspan::tools {
namespace {

Interpolation interpolation_of(const JsonView& sampler) {
  const std::string name = sampler.text_or("interpolation", "LINEAR");
  if (name == "LINEAR") return Interpolation::kLinear;
  if (name == "STEP") return Interpolation::kStep;
  if (name == "CUBICSPLINE") return Interpolation::kCubic;
  sampler.at("interpolation").fail("'" + name + "' is not an interpolation");
}

std::optional<ChannelPath> path_of(const std::string& name) {
  if (name == "translation") return ChannelPath::kTranslation;
  if (name == "rotation") return ChannelPath::kRotation;
  if (name == "scale") return ChannelPath::kScale;
  if (name == "weights") return ChannelPath::kMorphWeights;
  return std::nullopt;
}

void check(const JsonView& json, const std::optional<std::string>& wrong) {
  if (wrong) json.fail(*wrong);
}

/// `animation.samplers[i]` of a channel of the node.
RigChannel read_sampler(GltfFile& file, const JsonView& sampler, std::size_t node, ChannelPath path,
                        std::size_t morph_targets) {
  RigChannel channel;
  channel.node = node;
  channel.path = path;
  channel.interpolation = interpolation_of(sampler);
  const bool morphs = path == ChannelPath::kMorphWeights;
  channel.components = morphs ? morph_targets : path == ChannelPath::kRotation ? 4 : 3;
  const JsonView input = sampler.at("input");
  const JsonView output = sampler.at("output");
  channel.times = read_accessor(file, input, 1, 1).values;
  check(input, wrong_times(channel.times));
  const std::size_t of_element = morphs ? 1 : channel.components;
  channel.values = read_accessor(file, output, of_element, of_element).values;
  check(output, wrong_values(channel));
  const std::size_t of_key = channel.interpolation == Interpolation::kCubic ? 3 : 1;
  channel.values.resize(channel.keys() * channel.components * of_key);
  return channel;
}

class ClipReader {
 public:
  ClipReader(GltfFile& file, GltfNodes& nodes, const std::function<std::size_t(std::size_t)>& morph_targets,
             LeftOut& left_out)
      : file_(file), nodes_(nodes), morph_targets_(morph_targets), left_out_(left_out) {}

  RigClip read(const JsonView& json) {
    RigClip clip;
    taken_.clear();
    const JsonView samplers = json.at("samplers");
    const JsonView channels = json.at("channels");
    for (std::size_t i = 0; i < channels.size(); ++i) read_channel(channels.element(i), samplers, clip);
    return clip;
  }

 private:
  void read_channel(const JsonView& json, const JsonView& samplers, RigClip& clip) {
    const JsonView target = json.at("target");
    const JsonView name = target.at("path");
    const std::optional<ChannelPath> path = path_of(name.text());
    const std::optional<JsonView> id = target.find("node");
    if (!path || !id) return left_out_.add("animated properties that are not of nodes");
    const auto found = nodes_.places.find(file_.element("nodes", *id).place());
    if (found == nodes_.places.end()) return left_out_.add("animated nodes that are not in the scene");
    const std::size_t node = found->second;
    const std::size_t targets = *path == ChannelPath::kMorphWeights ? morph_targets_(node) : 0;
    if (*path == ChannelPath::kMorphWeights && targets == 0)
      name.fail("the node's mesh has no morph targets");
    if (!taken_.insert({node, *path}).second) target.fail("is animated twice by one animation");
    if (*path != ChannelPath::kMorphWeights) check(target, split_matrix(nodes_.nodes[node]));
    const auto number = static_cast<std::size_t>(
        json.at("sampler").integer(0, static_cast<std::int64_t>(samplers.size()) - 1));
    clip.channels.push_back(read_sampler(file_, samplers.element(number), node, *path, targets));
    numbers_ += clip.channels.back().values.size();
    if (numbers_ > kMostKeyNumbers) samplers.fail("has too many keys with those before");
  }

  GltfFile& file_;
  GltfNodes& nodes_;
  const std::function<std::size_t(std::size_t)>& morph_targets_;
  LeftOut& left_out_;
  std::set<std::pair<std::size_t, ChannelPath>> taken_;  ///< by the current clip
  std::size_t numbers_ = 0;
};

}  // namespace

std::vector<RigClip> read_gltf_clips(GltfFile& file, GltfNodes& nodes,
                                     const std::function<std::size_t(std::size_t)>& morph_targets,
                                     LeftOut& left_out, std::vector<std::string>& warnings) {
  std::vector<RigClip> clips;
  const std::optional<JsonView> all = file.root().find("animations");
  ClipReader reader(file, nodes, morph_targets, left_out);
  for (std::size_t i = 0; all && i < all->size(); ++i) {
    try {
      RigClip clip = reader.read(all->element(i));
      clip.name = all->element(i).text_or("name", "");
      if (!clip.channels.empty()) clips.push_back(std::move(clip));
    } catch (const Failure& failure) {
      warnings.push_back(std::string("an animation is left out: ") + failure.reason());
    }
  }
  name_clips(clips);
  return clips;
}

}  // namespace arcspan::tools
