// SPDX-License-Identifier: MIT
#include <arcspan/mesh/packed_normal.hpp>

#include <arcspan_tools/fixed_point/rounding.hpp>
#include <arcspan_tools/fixed_point/stored_pose.hpp>
#include <arcspan_tools/mesh/plain/node_transform.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {
namespace {

using Numbers = std::vector<double>;

template <class Raw>
Numbers numbers(const Raw& raw, int fraction_bits) {
  Numbers out;
  for (const auto value : raw) out.push_back(std::ldexp(static_cast<double>(value), -fraction_bits));
  return out;
}

int bits_of(const FixedChannel& channel, bool is_tangent) {
  switch (channel.path) {
    case ChannelPath::kTranslation:
      return 8;
    case ChannelPath::kScale:
      return 16;
    case ChannelPath::kRotation:
      return is_tangent ? 13 : 0;  // values are divided by 32767
    case ChannelPath::kMorphWeights:
      break;
  }
  return 12;
}

/// Value `place` of the list, in units.
Numbers stored_value(const FixedChannel& channel, std::size_t place, bool is_tangent) {
  const auto begin = channel.values.begin() + static_cast<std::ptrdiff_t>(place * channel.components);
  Numbers out =
      numbers(std::vector<std::int32_t>(begin, begin + static_cast<std::ptrdiff_t>(channel.components)),
              bits_of(channel, is_tangent));
  if (channel.path == ChannelPath::kRotation && !is_tangent) {
    for (double& c : out) c /= 32767;
  }
  return out;
}

Numbers mixed(std::initializer_list<std::pair<double, Numbers>> terms) {
  Numbers sum(terms.begin()->second.size());
  for (const auto& [factor, v] : terms) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * v[i];
  }
  return sum;
}

Numbers value_at(const FixedChannel& channel, double microseconds) {
  const auto& times = channel.times;
  const bool cubic = channel.interpolation == Interpolation::kCubic;
  const auto key_value = [&](std::size_t key) {
    return stored_value(channel, cubic ? 3 * key + 1 : key, false);
  };
  const auto next = std::upper_bound(times.begin(), times.end(), microseconds);
  if (next == times.begin()) return key_value(0);
  const auto key = static_cast<std::size_t>(next - times.begin()) - 1;
  if (next == times.end() || channel.interpolation == Interpolation::kStep) return key_value(key);
  const double s = (microseconds - times[key]) / (times[key + 1] - times[key]);
  const Numbers a = key_value(key);
  Numbers b = key_value(key + 1);
  if (!cubic) {
    if (channel.path == ChannelPath::kRotation && a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] < 0)
      b = mixed({{-1, b}});
    return mixed({{1 - s, a}, {s, b}});
  }
  const double s2 = s * s;
  const double s3 = s2 * s;
  return mixed({{2 * s3 - 3 * s2 + 1, a},
                {s3 - 2 * s2 + s, stored_value(channel, 3 * key + 2, true)},
                {3 * s2 - 2 * s3, b},
                {s3 - s2, stored_value(channel, 3 * key + 3, true)}});
}

Affine matrix_of(const FixedJoint& joint) {
  const auto& r = joint.rows;
  const auto column = [&r](std::size_t i, int bits) -> Vec3 {
    return {std::ldexp(r[0][i], -bits), std::ldexp(r[1][i], -bits), std::ldexp(r[2][i], -bits)};
  };
  return {column(0, 24), column(1, 24), column(2, 24), column(3, 8)};
}

/// Within 16 bits, as each mesh of the pipeline limits what it makes of a position.
Vec3 saturated(Vec3 p) {
  const auto limited = [](double c) { return std::clamp(c, -32768.0, 32767.0); };
  return {limited(p.x), limited(p.y), limited(p.z)};
}

}  // namespace

StoredPose::StoredPose(const FixedModel& model) : StoredPose(model, {}, 0) {}

StoredPose::StoredPose(const FixedModel& model, const FixedClip& clip, double seconds) : model_(model) {
  const FixedAnimation& animation = *model.animation;
  std::vector<Numbers> translations;
  std::vector<Numbers> rotations;
  std::vector<Numbers> scales;
  for (const FixedNode& node : animation.nodes) {
    translations.push_back(numbers(node.translation, 8));
    rotations.push_back(numbers(node.rotation, 0));
    scales.push_back(numbers(node.scale, 16));
  }
  for (const FixedPartMotion& part : animation.parts)
    morph_weights_.push_back(part.morph ? numbers(part.morph->weights, 12) : Numbers{});
  for (const FixedChannel& channel : clip.channels) {
    std::vector<Numbers>* const of[] = {&translations, &rotations, &scales, &morph_weights_};
    (*of[static_cast<int>(channel.path)])[channel.target] = value_at(channel, rounded(seconds * 1e6));
  }
  place_nodes(translations, rotations, scales);
}

void StoredPose::place_nodes(const std::vector<Numbers>& translations, const std::vector<Numbers>& rotations,
                             const std::vector<Numbers>& scales) {
  const FixedAnimation& animation = *model_.animation;
  std::vector<Affine> nodes;
  for (std::size_t i = 0; i < animation.nodes.size(); ++i) {
    const Numbers& t = translations[i];
    const Numbers& q = rotations[i];
    const Numbers& s = scales[i];
    const Affine own = NodeTransform{
        {t[0], t[1], t[2]},
        unit_length(Quaternion{q[0], q[1], q[2], q[3]}),
        {s[0], s[1], s[2]}}.affine();
    nodes.push_back(animation.nodes[i].parent ? nodes[*animation.nodes[i].parent] * own : own);
  }
  for (const FixedSkin& skin : animation.skins) {
    std::vector<Affine>& joints = joints_.emplace_back();
    for (const FixedJoint& joint : skin) joints.push_back(nodes[joint.node] * matrix_of(joint));
  }
}

StoredPose::Vertex StoredPose::shaped(std::size_t part, std::size_t i) const {
  const ObjectPosition& p = model_.meshes[part].positions[i];
  const Direction n = unpack_normal(model_.meshes[part].normals[i]);
  Vertex out{{double(p.x), double(p.y), double(p.z)},
             normalised(Vec3{double(n.x.raw()), double(n.y.raw()), double(n.z.raw())})};
  const std::optional<FixedMorph>& morph = model_.animation->parts[part].morph;
  if (!morph) return out;
  for (const FixedMorphRecord& record : morph->records[i]) {
    const double weight = morph_weights_[part][record.target];
    const Numbers position = numbers(record.position, 0);
    const Numbers normal = numbers(record.normal, 14);
    out.position = out.position + Vec3{position[0], position[1], position[2]} * weight;
    out.normal = out.normal + Vec3{normal[0], normal[1], normal[2]} * weight;
  }
  out.position = saturated(out.position);
  return out;
}

StoredPose::Vertex StoredPose::vertex(std::size_t part, std::size_t i) const {
  const Vertex own = shaped(part, i);
  const FixedPartMotion& motion = model_.animation->parts[part];
  if (motion.weights.empty()) return own;
  const FixedWeights& weights = motion.weights[i];
  Affine sum{{}, {}, {}, {}};
  for (std::size_t k = 0; k < weights.count; ++k)
    add_weighted(sum, joints_[motion.skin][weights.joints[k]], weights.weights[k] / 1024.0);
  return {saturated(sum.point(own.position)), sum.direction(own.normal)};
}

}  // namespace arcspan::tools
