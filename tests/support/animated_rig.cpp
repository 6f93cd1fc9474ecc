// SPDX-License-Identifier: MIT
#include <tests/support/animated_rig.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace arcspan::test {

namespace {

Quat normalised(Quat q) {
  double square = 0;
  for (const double c : q) square += c * c;
  for (double& c : q) c /= std::sqrt(square);
  return q;
}

Quat product(const Quat& a, const Quat& b) {
  const auto [ax, ay, az, aw] = a;
  const auto [bx, by, bz, bw] = b;
  return {aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
          aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz};
}

/// The values of a channel at a time.
std::vector<double> sample(const RigChannel& channel, double time) {
  const std::size_t keys = channel.times.size();
  const bool is_cubic = channel.interpolation == Interpolation::kCubic;
  const auto value = [&](std::size_t k) { return channel.values.at(is_cubic ? 3 * k + 1 : k); };
  if (time <= channel.times.front()) return value(0);
  if (time >= channel.times.back()) return value(keys - 1);
  std::size_t k = 0;
  while (time >= channel.times.at(k + 1)) ++k;
  if (channel.interpolation == Interpolation::kStep) return value(k);
  const double s = (time - channel.times[k]) / (channel.times[k + 1] - channel.times[k]);
  std::vector<double> from = value(k);
  std::vector<double> to = value(k + 1);
  if (!is_cubic && channel.path == ChannelPath::kRotation) {
    double dot = 0;
    for (std::size_t i = 0; i < 4; ++i) dot += from[i] * to[i];
    if (dot < 0) {
      for (double& c : to) c = -c;
    }
  }
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (is_cubic) {
      const double out = channel.values[3 * k + 2][i];
      const double in = channel.values[3 * k + 3][i];
      from[i] = (2 * s * s * s - 3 * s * s + 1) * from[i] + (s * s * s - 2 * s * s + s) * out +
                (3 * s * s - 2 * s * s * s) * to[i] + (s * s * s - s * s) * in;
    } else {
      from[i] += s * (to[i] - from[i]);
    }
  }
  return from;
}

Vec3 vec3_of(const std::vector<double>& v) { return {v.at(0), v.at(1), v.at(2)}; }

void append_rounded(Bytes& out, double value, int bytes) {
  append(out, static_cast<std::uint64_t>(std::llround(value)), bytes);
}

void append_lengths(Bytes& out, Vec3 v) {
  for (const double c : {v.x, v.y, v.z}) append_rounded(out, 256 * c, 4);
}

void append_scales(Bytes& out, Vec3 v) {
  for (const double c : {v.x, v.y, v.z}) append_rounded(out, 65536 * c, 4);
}

void append_position(Bytes& out, Vec3 v) {
  for (const double c : {v.x, v.y, v.z}) append_rounded(out, c, 2);
}

/// The octahedral map, in 32767ths.
void append_normal(Bytes& out, Vec3 n) {
  const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
  double u = n.x / sum;
  double v = n.y / sum;
  if (n.z < 0) {
    const double folded_u = (1 - std::abs(v)) * (u < 0 ? -1 : 1);
    v = (1 - std::abs(u)) * (v < 0 ? -1 : 1);
    u = folded_u;
  }
  append_rounded(out, 32767 * u, 2);
  append_rounded(out, 32767 * v, 2);
}

void append_text(Bytes& out, const std::string& text) {
  out.insert(out.end(), text.begin(), text.end());
  out.resize(out.size() + 32 - text.size());
}

void fill(Bytes& out) { out.resize((out.size() + 3) / 4 * 4); }

Bytes nodes_chunk(const Rig& rig) {
  Bytes out;
  append(out, rig.nodes.size(), 4);
  for (const RigNode& node : rig.nodes) {
    append(out, static_cast<std::uint16_t>(node.parent), 2);
    append(out, 0, 2);
    append_lengths(out, node.translation);
    for (const double c : node.rotation) append_rounded(out, 32767 * c, 2);
    append_scales(out, node.scale);
  }
  return out;
}

Bytes names_chunk(const Rig& rig) {
  Bytes out;
  for (std::size_t i = 0; i < rig.nodes.size(); ++i) append_text(out, "node " + std::to_string(i));
  return out;
}

Bytes skin_chunk(const Rig& rig) {
  Bytes out;
  append(out, rig.joints.size(), 4);
  for (const RigJoint& joint : rig.joints) {
    append(out, static_cast<std::uint16_t>(joint.node), 4);
    const double offsets[3] = {joint.bind.t.x, joint.bind.t.y, joint.bind.t.z};
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double entry : joint.bind.m[i]) append_rounded(out, std::ldexp(entry, 24), 4);
      append_rounded(out, 256 * offsets[i], 4);
    }
  }
  return out;
}

Bytes weights_chunk(const Rig& rig) {
  Bytes out;
  append(out, 0, 2);
  if (rig.follows_joint >= 0) {
    append(out, static_cast<std::uint16_t>(rig.follows_joint), 2);
    append(out, 0, 8);
    return out;
  }
  Bytes first;
  Bytes records;
  for (const RigVertex& vertex : rig.vertices) {
    append(first, records.size() / 2, 2);
    const std::vector<RigWeight>& w = vertex.weights;
    unsigned word = static_cast<unsigned>(w[0].joint) | static_cast<unsigned>(w.size() - 1) << 8;
    for (std::size_t k = 1; k < w.size(); ++k)
      word |= (static_cast<unsigned>(w[k].weight) & 3u) << (8 + 2 * k);
    append(records, word, 2);
    for (std::size_t k = 1; k < w.size(); ++k)
      append(records, static_cast<unsigned>(w[k].joint) | static_cast<unsigned>(w[k].weight >> 2) << 8, 2);
  }
  append(out, 0, 2);
  append(out, rig.vertices.size(), 4);
  append(out, records.size() / 2, 4);
  out.insert(out.end(), first.begin(), first.end());
  out.insert(out.end(), records.begin(), records.end());
  return out;
}

Bytes morph_chunk(const Rig& rig) {
  Bytes out;
  append(out, static_cast<std::uint16_t>(rig.targets), 2);
  append(out, 1, 2);
  append(out, rig.vertices.size(), 4);
  std::size_t count = 0;
  Bytes first;
  Bytes records;
  for (const RigVertex& vertex : rig.vertices) {
    append(first, count, 2);
    count += vertex.morphs.size();
    for (const RigMorph& morph : vertex.morphs) {
      append(records, static_cast<std::uint16_t>(morph.target), 2);
      append_position(records, morph.position);
      append_position(records, 16384 * morph.normal);
      append(records, 0, 2);
    }
  }
  append(first, count, 2);
  append(out, count, 4);
  for (int i = 0; i < rig.targets; ++i) append(out, 0, 2);
  out.insert(out.end(), first.begin(), first.end());
  fill(out);
  out.insert(out.end(), records.begin(), records.end());
  return out;
}

/// A sphere around the vertices of each joint.
Bytes bounds_chunk(const Rig& rig) {
  Bytes out;
  int count = 0;
  for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) {
    Vec3 low{40000, 40000, 40000};
    Vec3 high{-40000, -40000, -40000};
    for (const RigVertex& vertex : rig.vertices) {
      for (const RigWeight& weight : vertex.weights) {
        if (weight.joint != static_cast<int>(joint)) continue;
        const Vec3 p = vertex.position;
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    }
    if (low.x > high.x) continue;
    ++count;
    append(out, joint, 4);
    append_position(out, 0.5 * (low + high));
    append_rounded(out, std::ceil(0.5 * length(high - low)) + 2, 2);
  }
  Bytes chunk;
  append(chunk, static_cast<unsigned>(count), 4);
  chunk.insert(chunk.end(), out.begin(), out.end());
  return chunk;
}

void append_value(Bytes& out, const RigChannel& channel, const std::vector<double>& value, bool is_tangent) {
  switch (channel.path) {
    case ChannelPath::kTranslation:
      return append_lengths(out, vec3_of(value));
    case ChannelPath::kRotation:
      for (const double c : value) append_rounded(out, (is_tangent ? 8192 : 32767) * c, 2);
      return;
    case ChannelPath::kScale:
      return append_scales(out, vec3_of(value));
    default:
      for (const double c : value) append_rounded(out, 4096 * c, 2);
  }
}

Bytes clip_chunk(const RigClip& clip) {
  Bytes out;
  append(out, clip.duration, 4);
  append(out, clip.channels.size(), 4);
  append_text(out, clip.name);
  Bytes data;
  const std::size_t begin = out.size() + 16 * clip.channels.size();
  for (const RigChannel& channel : clip.channels) {
    append(out, static_cast<std::uint16_t>(channel.target), 2);
    append(out, static_cast<unsigned>(channel.path), 1);
    append(out, static_cast<unsigned>(channel.interpolation), 1);
    append(out, begin + data.size(), 4);
    for (const std::uint32_t time : channel.times) append(data, time, 4);
    append(out, begin + data.size(), 4);
    for (std::size_t i = 0; i < channel.values.size(); ++i)
      append_value(data, channel, channel.values[i],
                   channel.interpolation == Interpolation::kCubic && i % 3 != 1);
    fill(data);
    append(out, channel.times.size(), 4);
  }
  out.insert(out.end(), data.begin(), data.end());
  return out;
}

Bytes mesh_chunk(const Rig& rig) {
  Bytes out{'A', 'R', 'C', 'M', 1, 0, 0, 0};
  append(out, 0, 4);
  append(out, rig.vertices.size(), 4);
  append(out, rig.indices.size() / 3, 4);
  out.resize(32);
  for (const RigVertex& vertex : rig.vertices) append_position(out, vertex.position);
  for (const RigVertex& vertex : rig.vertices) append_normal(out, vertex.normal);
  for (const int index : rig.indices) append(out, static_cast<std::uint16_t>(index), 2);
  fill(out);
  put(out, 8, out.size(), 4);
  return out;
}

Bytes model_chunk(const Rig& rig) {
  Bytes out;
  append(out, rig.vertices.size(), 4);
  append_u16(out, {0, 0, 0, 65535});
  for (int i = 0; i < 4; ++i) append(out, 0x3FF0000000000000, 8);  // 1.0
  return out;
}

Bytes parts_chunk() {
  Bytes out;
  append_u16(out, {6554, 6554, 6554, 26214, 26214, 26214, 16384, 16384, 16384, 16, 0, 0xFFFF});
  append_u16(out, {0, 0, 0, 65535});
  append_text(out, "rig");
  return out;
}

}  // namespace

Quat about(Vec3 axis, double degrees) {
  const double half = radians(degrees) / 2;
  const Vec3 v = std::sin(half) * normalised(axis);
  return {v.x, v.y, v.z, std::cos(half)};
}

Vec3 Affine::linear(Vec3 v) const {
  return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
          m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

Affine operator*(const Affine& outer, const Affine& inner) {
  Affine product;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      product.m[i][j] = 0;
      for (std::size_t k = 0; k < 3; ++k) product.m[i][j] += outer.m[i][k] * inner.m[k][j];
    }
  }
  product.t = outer(inner.t);
  return product;
}

Affine Affine::inverse() const {
  const Vec3 a{m[0][0], m[1][0], m[2][0]};
  const Vec3 b{m[0][1], m[1][1], m[2][1]};
  const Vec3 c{m[0][2], m[1][2], m[2][2]};
  const double volume = dot(a, cross(b, c));
  const Vec3 rows[3] = {(1 / volume) * cross(b, c), (1 / volume) * cross(c, a), (1 / volume) * cross(a, b)};
  Affine result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.m[i][0] = rows[i].x;
    result.m[i][1] = rows[i].y;
    result.m[i][2] = rows[i].z;
  }
  result.t = -1 * result.linear(t);
  return result;
}

Affine affine(Vec3 translation, Quat rotation, Vec3 scale) {
  const auto [x, y, z, w] = normalised(rotation);
  Affine result;
  const double r[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                          {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                          {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  for (std::size_t i = 0; i < 3; ++i) {
    result.m[i][0] = r[i][0] * scale.x;
    result.m[i][1] = r[i][1] * scale.y;
    result.m[i][2] = r[i][2] * scale.z;
  }
  result.t = translation;
  return result;
}

std::vector<Affine> Rig::pose(int clip, double microseconds) const {
  std::vector<Affine> pose;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    RigNode node = nodes[i];
    const std::vector<RigChannel> none;
    for (const RigChannel& channel : clip < 0 ? none : clips.at(static_cast<std::size_t>(clip)).channels) {
      if (channel.target != static_cast<int>(i)) continue;
      const std::vector<double> value = sample(channel, microseconds);
      if (channel.path == ChannelPath::kTranslation) node.translation = vec3_of(value);
      if (channel.path == ChannelPath::kRotation) node.rotation = {value[0], value[1], value[2], value[3]};
      if (channel.path == ChannelPath::kScale) node.scale = vec3_of(value);
    }
    const Affine local = affine(node.translation, node.rotation, node.scale);
    pose.push_back(node.parent < 0 ? local : pose.at(static_cast<std::size_t>(node.parent)) * local);
  }
  return pose;
}

std::vector<double> Rig::morph(int clip, double microseconds) const {
  if (clip >= 0) {
    for (const RigChannel& channel : clips.at(static_cast<std::size_t>(clip)).channels) {
      if (channel.path == ChannelPath::kMorphWeights) return sample(channel, microseconds);
    }
  }
  return std::vector<double>(static_cast<std::size_t>(targets));
}

Rig::Placed Rig::placed(std::size_t vertex, const std::vector<Affine>& pose,
                        const std::vector<double>& morph) const {
  const RigVertex& v = vertices.at(vertex);
  Vec3 p = v.position;
  Vec3 n = normalised(v.normal);
  for (const RigMorph& m : v.morphs) {
    p = p + morph.at(static_cast<std::size_t>(m.target)) * m.position;
    n = n + morph.at(static_cast<std::size_t>(m.target)) * m.normal;
  }
  std::vector<RigWeight> weights = v.weights;
  if (follows_joint >= 0) weights = {{follows_joint, 1024}};
  Placed placed;
  int left = 1024;
  for (std::size_t k = weights.size(); k-- > 0;) {
    const int weight = k == 0 ? left : weights[k].weight;
    left -= weight;
    const RigJoint& joint = joints.at(static_cast<std::size_t>(weights[k].joint));
    const Affine matrix = pose.at(static_cast<std::size_t>(joint.node)) * joint.bind;
    placed.position = placed.position + (weight / 1024.0) * matrix(p);
    placed.normal = placed.normal + (weight / 1024.0) * matrix.linear(n);
  }
  placed.normal = normalised(placed.normal);
  return placed;
}

std::vector<TestChunk> Rig::chunks() const {
  std::vector<TestChunk> chunks;
  if (follows_joint < 0) chunks.push_back({"BNDS", 0, bounds_chunk(*this)});
  for (std::size_t i = 0; i < clips.size(); ++i)
    chunks.push_back({"CLIP", static_cast<std::uint32_t>(i), clip_chunk(clips[i])});
  chunks.push_back({"MESH", 0, mesh_chunk(*this)});
  chunks.push_back({"MODL", 0, model_chunk(*this)});
  if (targets > 0) chunks.push_back({"MRPH", 0, morph_chunk(*this)});
  chunks.push_back({"NNAM", 0, names_chunk(*this)});
  chunks.push_back({"NODE", 0, nodes_chunk(*this)});
  chunks.push_back({"PART", 0, parts_chunk()});
  chunks.push_back({"SKIN", 0, skin_chunk(*this)});
  chunks.push_back({"WGHT", 0, weights_chunk(*this)});
  return chunks;
}

namespace {

/// The weights of a vertex that is `at` joints along a chain, for up to four joints around it. They fall off
/// linearly.
std::vector<RigWeight> chain_weights(double at, int joints, int influences) {
  std::vector<RigWeight> weights;
  double sum = 0;
  std::vector<double> shares;
  for (int joint = 0; joint < joints; ++joint) {
    const double share = influences / 2.0 - std::abs(joint - at);
    if (influences == 1 ? joint != static_cast<int>(std::lround(at)) : share <= 0.02) continue;
    weights.push_back({joint, 0});
    shares.push_back(influences == 1 ? 1 : share);
    sum += shares.back();
  }
  for (std::size_t k = 0; k < weights.size(); ++k)
    weights[k].weight = std::max(1, static_cast<int>(std::lround(1024 * shares[k] / sum)));
  std::sort(weights.begin(), weights.end(), [](auto a, auto b) { return a.weight > b.weight; });
  weights.resize(std::min(weights.size(), static_cast<std::size_t>(influences)));
  return weights;
}

}  // namespace

Rig tube(int joints, int influences, double length, double radius, double bind_scale) {
  Rig rig;
  // Above the chain a node that is moved, turned and scaled, as exporters write it.
  rig.nodes.push_back(
      {-1, {300, -200, 100}, about({1, 2, 3}, 40), {1 / bind_scale, 1 / bind_scale, 1 / bind_scale}});
  const Affine above = affine(rig.nodes[0].translation, rig.nodes[0].rotation, rig.nodes[0].scale);
  const double step = length / (joints - 1);
  Affine chain = above.inverse();  // bound straight along y of the object
  for (int joint = 0; joint < joints; ++joint) {
    const Vec3 at = joint == 0 ? chain(Vec3{0, -length / 2, 0}) : Vec3{0, bind_scale * step, 0};
    // The first joint turns the chain back into the object's axes.
    const Quat back = about({1, 2, 3}, joint == 0 ? -40 : 0);
    rig.nodes.push_back({joint, at, back, {1, 1, 1}});
  }
  const std::vector<Affine> rest = rig.pose(-1, 0);
  for (int joint = 0; joint < joints; ++joint)
    rig.joints.push_back({joint + 1, rest[static_cast<std::size_t>(joint) + 1].inverse()});
  constexpr int kRings = 24;
  constexpr int kSides = 8;
  for (int ring = 0; ring <= kRings; ++ring) {
    for (int side = 0; side < kSides; ++side) {
      const double angle = 2 * std::numbers::pi * side / kSides;
      const Vec3 normal{std::cos(angle), 0, -std::sin(angle)};
      const Vec3 p = radius * normal + Vec3{0, length * ring / kRings - length / 2, 0};
      rig.vertices.push_back(
          {{std::round(p.x), std::round(p.y), std::round(p.z)},
           normal,
           chain_weights((joints - 1) * static_cast<double>(ring) / kRings, joints, influences),
           {}});
      if (ring == kRings) continue;
      const int a = ring * kSides + side;
      const int b = ring * kSides + (side + 1) % kSides;
      rig.indices.insert(rig.indices.end(), {a, b, b + kSides, a, b + kSides, a + kSides});
    }
  }
  return rig;
}

RigClip bending(const Rig& rig, Interpolation interpolation, double degrees) {
  RigClip clip{"bend", 2'000'000, {}};
  for (std::size_t node = 1; node < rig.nodes.size(); ++node) {
    RigChannel channel{static_cast<int>(node), ChannelPath::kRotation, interpolation, {}, {}};
    std::vector<Quat> keys;
    for (int key = 0; key <= 8; ++key) {
      channel.times.push_back(static_cast<std::uint32_t>(250'000 * key));
      const double turn = degrees * std::sin(std::numbers::pi * key / 4 + static_cast<double>(node));
      keys.push_back(product(rig.nodes[node].rotation, about({0.2, 0.3, 1}, turn)));
      // Both signs name the same rotation. A cubic goes through the components.
      if (interpolation != Interpolation::kCubic && key % 2 == 1) {
        for (double& c : keys.back()) c = -c;
      }
    }
    for (std::size_t key = 0; key < keys.size(); ++key) {
      const Quat& before = keys[key == 0 ? 0 : key - 1];
      const Quat& after = keys[key + 1 == keys.size() ? key : key + 1];
      std::vector<double> tangent;
      for (std::size_t i = 0; i < 4; ++i) tangent.push_back(0.5 * (after[i] - before[i]));
      const std::vector<double> value(keys[key].begin(), keys[key].end());
      if (interpolation == Interpolation::kCubic) {
        channel.values.insert(channel.values.end(), {tangent, value, tangent});
      } else {
        channel.values.push_back(value);
      }
    }
    clip.channels.push_back(channel);
  }
  return clip;
}

}  // namespace arcspan::test
