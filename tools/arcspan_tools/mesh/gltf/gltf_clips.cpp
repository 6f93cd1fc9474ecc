// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/gltf_clips.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace arcspan::tools {
namespace {

/// The longest clip: times of the animation binary have 30 bits of microseconds.
constexpr double kMostSeconds = 1000;
constexpr std::size_t kMostKeys = 65'535;
/// Numbers of all keys of a file.
constexpr std::size_t kMostNumbers = std::size_t{1} << 24;

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

void check_times(const JsonView& id, const std::vector<double>& times) {
  if (times.empty()) id.fail("has no keys");
  if (times.size() > kMostKeys) id.fail(formatted("has more than %zu keys", kMostKeys));
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!(times[i] >= 0 && times[i] <= kMostSeconds))
      id.fail(formatted("key %zu is not at a time of 0...%g s", i, kMostSeconds));
    if (i > 0 && !(times[i] > times[i - 1]))
      id.fail(formatted("key %zu is not later than the one before", i));
  }
}

void check_values(const JsonView& id, const RigChannel& channel) {
  const std::size_t count = channel.keys() * channel.components;
  const std::size_t of_key = channel.interpolation == Interpolation::kCubic ? 3 : 1;
  if (channel.values.size() < count * of_key) id.fail("has fewer values than there are keys");
  for (const double value : channel.values) {
    if (!std::isfinite(value)) id.fail("has a value that is not finite");
  }
  for (std::size_t i = 0; channel.path == ChannelPath::kRotation && i < channel.keys(); ++i) {
    const double* q = channel.value(i);
    if (!(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 0))
      id.fail(formatted("key %zu is no rotation", i));
  }
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
  check_times(input, channel.times);
  const std::size_t of_element = morphs ? 1 : channel.components;
  channel.values = read_accessor(file, output, of_element, of_element).values;
  check_values(output, channel);
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
    if (*path != ChannelPath::kMorphWeights) split_matrix(node, target);
    const auto number = static_cast<std::size_t>(
        json.at("sampler").integer(0, static_cast<std::int64_t>(samplers.size()) - 1));
    clip.channels.push_back(read_sampler(file_, samplers.element(number), node, *path, targets));
    numbers_ += clip.channels.back().values.size();
    if (numbers_ > kMostNumbers) samplers.fail("has too many keys with those before");
  }

  /// The parts of a matrix that a clip moves.
  void split_matrix(std::size_t node, const JsonView& target) {
    RigNode& moved = nodes_.nodes[node];
    if (!moved.matrix) return;
    const std::optional<NodeTransform> parts = split(*moved.matrix);
    if (!parts) target.fail("is a node whose matrix is not made of a translation, a rotation and a scale");
    moved.rest = *parts;
    moved.matrix.reset();
  }

  GltfFile& file_;
  GltfNodes& nodes_;
  const std::function<std::size_t(std::size_t)>& morph_targets_;
  LeftOut& left_out_;
  std::set<std::pair<std::size_t, ChannelPath>> taken_;  ///< by the current clip
  std::size_t numbers_ = 0;
};

/// Gives clips without a name, or with that of an earlier one, a name.
void name_clips(std::vector<RigClip>& clips) {
  std::set<std::string> taken;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    std::string& name = clips[i].name;
    const std::string base = name.empty() ? "clip" : name;
    if (name.empty()) name = base + std::to_string(i + 1);
    for (std::size_t n = 2; !taken.insert(name).second; ++n) name = base + std::to_string(n);
  }
}

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
