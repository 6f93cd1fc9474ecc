// SPDX-License-Identifier: MIT
#include <arcspan/animate/animation_binary.hpp>

#include <arcspan_tools/fixed_point/rounding.hpp>
#include <arcspan_tools/mesh/compile/animation_space.hpp>
#include <arcspan_tools/mesh/compile/far_joints.hpp>
#include <arcspan_tools/mesh/compile/make_animation.hpp>
#include <arcspan_tools/mesh/compile/part_motion.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace arcspan::tools {
namespace {

constexpr double kMicroseconds = 1e6;
constexpr double kRotationTangent = 8192;
constexpr double kMorphWeight = 4096;
constexpr std::size_t kMostNameBytes = animation_binary::kNameBytes - 1;
constexpr double kExtent = 65534;  // of the largest side of a model, in object units

/// Makes the clips of a model.
class ClipMaker {
 public:
  ClipMaker(const FixedModel& model, const AnimationSpace& space, const FixedAnimation& animation,
            const ClipOptions& options, const std::string& subject)
      : model_(model),
        space_(space),
        animation_(animation),
        tolerance_{options.degrees, options.share * kExtent * model.meshes[0].unit, options.share},
        subject_(subject),
        names_(stored_clip_names(*model.rig)) {}

  FixedClip make(const RigClip& clip) {
    FixedClip out;
    out.name = names_.at(clip.name);
    name_ = clip.name;
    for (const RigChannel& channel : clip.channels) {
      const RigChannel thin = smaller(in_microseconds(with_close_rotations(channel)));
      if (channel.path == ChannelPath::kMorphWeights) {
        for (const std::size_t part : parts_of(channel.node)) out.channels.push_back(fixed(thin, part));
      } else if (const std::optional<std::size_t> node = space_.number(channel.node)) {
        out.channels.push_back(fixed(thin, *node));
      }
    }
    std::sort(out.channels.begin(), out.channels.end(), [](const FixedChannel& a, const FixedChannel& b) {
      const auto key = [](const FixedChannel& c) {
        return std::tuple(c.path == ChannelPath::kMorphWeights, c.target, c.path);
      };
      return key(a) < key(b);
    });
    out.duration = std::max(micro(clip.duration()), std::uint32_t{1});
    for (const FixedChannel& channel : out.channels)
      out.duration = std::max(out.duration, channel.times.back());
    return out;
  }

 private:
  static std::uint32_t micro(double seconds) {
    return static_cast<std::uint32_t>(rounded(seconds * kMicroseconds));
  }

  /// The tolerance in the numbers of a channel, whose node may be below scales: a skeleton in centimetres
  /// below one of 1/100.
  [[nodiscard]] ClipTolerance tolerance_of(const RigChannel& channel) const {
    ClipTolerance tolerance = tolerance_;
    if (channel.path == ChannelPath::kMorphWeights || !space_.number(channel.node)) return tolerance;
    const double scale = space_.scale_of_parent(channel.node);
    tolerance.length /= scale;
    if (channel.path == ChannelPath::kScale) tolerance.share *= space_.scale_of(channel.node) / scale;
    return tolerance;
  }

  /// The channel with as few keys as the tolerance allows, unless that takes more bytes: keys that are left
  /// out leave a list of times of its own, and channels often share one.
  [[nodiscard]] RigChannel smaller(const RigChannel& channel) const {
    const RigChannel whole = thinned(channel, {});
    const RigChannel thin = thinned(channel, tolerance_of(channel));
    const bool is_short =
        channel.path == ChannelPath::kRotation || channel.path == ChannelPath::kMorphWeights;
    const std::size_t of_value = channel.components * (is_short ? 2 : 4);
    constexpr std::size_t kOfTime = 4;
    return thin.keys() * (of_value + kOfTime) < whole.keys() * of_value ? thin : whole;
  }

  /// The parts whose vertices have the morph targets of a node's mesh.
  [[nodiscard]] std::vector<std::size_t> parts_of(std::size_t node) const {
    std::vector<std::size_t> parts;
    for (std::size_t i = 0; i < model_.meshes.size(); ++i) {
      if (!animation_.parts[i].morph) continue;
      const std::vector<std::uint32_t>& sources = model_.meshes[i].sources;
      const auto first = std::find_if(sources.begin(), sources.end(), [](auto s) { return s != kNoSource; });
      const std::size_t instance = model_.rig->vertices[*first].instance;
      if (model_.rig->instances[instance].node == node) parts.push_back(i);
    }
    return parts;
  }

  /// Appends a value, or a tangent that is multiplied by `seconds`.
  void append(FixedChannel& out, const RigChannel& channel, const double* v, std::optional<double> seconds) {
    const double factor = seconds.value_or(1);
    switch (channel.path) {
      case ChannelPath::kTranslation:
        append(out, space_.translation(channel.node, Vec3{v[0], v[1], v[2]} * factor));
        break;
      case ChannelPath::kScale:
        append(out, space_.scale(channel.node, Vec3{v[0], v[1], v[2]} * factor));
        break;
      case ChannelPath::kRotation:
        if (seconds) {
          for (int i = 0; i < 4; ++i) append_half_word(out, v[i] * factor * kRotationTangent);
        } else {
          append(out, fixed_rotation({v[0], v[1], v[2], v[3]}));
        }
        break;
      case ChannelPath::kMorphWeights:
        for (std::size_t i = 0; i < channel.components; ++i)
          append_half_word(out, v[i] * factor * kMorphWeight);
        break;
    }
  }

  template <class Raw, std::size_t n>
  static void append(FixedChannel& out, const std::array<Raw, n>& raw) {
    out.values.insert(out.values.end(), raw.begin(), raw.end());
  }

  void append_half_word(FixedChannel& out, double value) const {
    if (!(std::abs(value) <= 32767)) {
      throw Failure(subject_, "a morph weight or a tangent of the clip '" + name_ +
                                  "' is out of range (weights are below 8, tangents below 4)");
    }
    out.values.push_back(static_cast<std::int32_t>(rounded(value)));
  }

  FixedChannel fixed(const RigChannel& channel, std::size_t target) {
    FixedChannel out;
    out.target = target;
    out.path = channel.path;
    out.interpolation = channel.interpolation;
    out.components = channel.components;
    for (std::size_t key = 0; key < channel.keys(); ++key) {
      out.times.push_back(micro(channel.times[key]));
      const double* value = channel.value(key);
      if (channel.interpolation != Interpolation::kCubic) {
        append(out, channel, value, {});
        continue;
      }
      const std::size_t n = channel.components;
      const bool is_last = key + 1 == channel.keys();
      // The lengths of rotations are taken out of tangents, too.
      const double size = channel.path == ChannelPath::kRotation
                              ? std::sqrt(inner({value[0], value[1], value[2], value[3]},
                                                {value[0], value[1], value[2], value[3]}))
                              : 1;
      const double before = key == 0 ? 0 : channel.times[key] - channel.times[key - 1];
      const double after = is_last ? 0 : channel.times[key + 1] - channel.times[key];
      append(out, channel, value - n, before / size);
      append(out, channel, value, {});
      append(out, channel, value + n, after / size);
    }
    return out;
  }

  const FixedModel& model_;
  const AnimationSpace& space_;
  const FixedAnimation& animation_;
  ClipTolerance tolerance_;
  std::string subject_;
  std::map<std::string, std::string> names_;
  std::string name_;
};

/// Names of nodes that fit, the long ones each its own.
void shorten_names(FixedAnimation& animation) {
  std::vector<std::string> names;
  for (const FixedNode& node : animation.nodes) names.push_back(node.name);
  const std::vector<std::string> fitting = shortened(names, kMostNameBytes);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (fitting[i] != names[i]) animation.cut_names.push_back(names[i]);
    animation.nodes[i].name = fitting[i];
  }
}

}  // namespace

std::map<std::string, std::string> stored_clip_names(const Rig& rig) {
  std::vector<std::string> names;
  for (const RigClip& clip : rig.clips) names.push_back(clip.name);
  const std::vector<std::string> fitting = shortened(names, kMostNameBytes);
  std::map<std::string, std::string> stored;
  for (std::size_t i = 0; i < names.size(); ++i) stored.emplace(names[i], fitting[i]);
  return stored;
}

FixedAnimation make_animation(const FixedModel& model, const ClipOptions& options,
                              const std::string& subject) {
  FixedAnimation animation;
  AnimationSpace space(*model.rig, model.meshes[0].unit, model.meshes[0].centre, subject);
  PartMotions motions(*model.rig, space, subject);
  for (const FixedMesh& mesh : model.meshes) animation.parts.push_back(motions.motion(mesh));
  animation.skins = motions.skins();
  animation.nodes = space.nodes();
  check_joints_are_near(model, subject);
  shorten_names(animation);
  ClipMaker maker(model, space, animation, options, subject);
  for (const RigClip& clip : model.rig->clips) {
    FixedClip made = maker.make(clip);
    if (made.channels.empty()) {
      animation.still_clips.push_back(clip.name);
      continue;
    }
    if (made.name != clip.name) animation.cut_names.push_back(clip.name);
    animation.clips.push_back(std::move(made));
  }
  return animation;
}

}  // namespace arcspan::tools
