// SPDX-License-Identifier: MIT
#include <arcspan_tools/fixed_point/rounding.hpp>
#include <arcspan_tools/mesh/compile/thin_keys.hpp>
#include <arcspan_tools/mesh/plain/node_transform.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {
namespace {

Quaternion quaternion(const std::vector<double>& v) {
  return unit_length(Quaternion{v[0], v[1], v[2], v[3]});
}

/// The angle between two rotations in degrees. The sine of half of it is exact for small angles.
double degrees_between(Quaternion a, Quaternion b) {
  if (inner(a, b) < 0) b = b * -1;
  const Quaternion difference = a + b * -1;
  return 4 * std::asin(std::min(std::sqrt(inner(difference, difference)) / 2, 1.0)) / kDegree;
}

bool is_within(const RigChannel& channel, const std::vector<double>& a, const std::vector<double>& b,
               const ClipTolerance& tolerance) {
  if (channel.path == ChannelPath::kRotation)
    return degrees_between(quaternion(a), quaternion(b)) <= tolerance.degrees;
  double squared = 0;
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    squared += (a[i] - b[i]) * (a[i] - b[i]);
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return channel.path == ChannelPath::kTranslation ? std::sqrt(squared) <= tolerance.length
                                                   : largest <= tolerance.share;
}

/// The channel with the keys of these numbers only.
RigChannel with_keys(const RigChannel& channel, const std::vector<std::size_t>& keys) {
  const std::size_t of_key = channel.components * (channel.interpolation == Interpolation::kCubic ? 3 : 1);
  RigChannel out = channel;
  out.times.clear();
  out.values.clear();
  for (const std::size_t key : keys) {
    const double* const first = channel.values.data() + key * of_key;
    out.times.push_back(channel.times[key]);
    out.values.insert(out.values.end(), first, first + of_key);
  }
  return out;
}

/// The value of a channel of two keys as the pipeline makes it: linear rotations by their components. The
/// spherical ones of at() would undo what with_close_rotations() adds.
std::vector<double> played(const RigChannel& two, double time) {
  if (two.path != ChannelPath::kRotation || two.interpolation != Interpolation::kLinear) return two.at(time);
  const Quaternion a = quaternion(two.at(two.times[0]));
  Quaternion b = quaternion(two.at(two.times[1]));
  if (inner(a, b) < 0) b = b * -1;
  const double t = (time - two.times[0]) / (two.times[1] - two.times[0]);
  const Quaternion mixed = a * (1 - t) + b * t;
  return {mixed.x, mixed.y, mixed.z, mixed.w};
}

/// Whether the channel of only the keys `from` and `to` is close enough at all keys between them and in the
/// middle of each two.
bool may_skip(const RigChannel& channel, std::size_t from, std::size_t to, const ClipTolerance& tolerance) {
  const RigChannel few = with_keys(channel, {from, to});
  for (std::size_t key = from + 1; key <= to; ++key) {
    const double before = (channel.times[key - 1] + channel.times[key]) / 2;
    for (const double time : {before, channel.times[key]}) {
      if (!is_within(channel, channel.at(time), played(few, time), tolerance)) return false;
    }
  }
  return true;
}

}  // namespace

RigChannel thinned(const RigChannel& channel, const ClipTolerance& tolerance) {
  if (channel.interpolation == Interpolation::kCubic) return channel;
  const std::size_t keys = channel.keys();
  const std::vector<double> first = channel.at(channel.times[0]);
  std::size_t alike = 1;
  while (alike < keys && is_within(channel, first, channel.at(channel.times[alike]), tolerance)) ++alike;
  if (alike == keys) return with_keys(channel, {0});
  if (tolerance.degrees == 0 && tolerance.length == 0 && tolerance.share == 0) return channel;
  std::vector<std::size_t> kept = {0};
  for (std::size_t key = 1; key < keys; ++key) {
    if (key + 1 < keys && may_skip(channel, kept.back(), key + 1, tolerance)) continue;
    kept.push_back(key);
  }
  return with_keys(channel, kept);
}

RigChannel in_microseconds(const RigChannel& channel) {
  const auto micro = [&channel](std::size_t key) { return rounded(channel.times[key] * 1e6); };
  std::vector<std::size_t> kept;
  std::vector<double> times;
  for (std::size_t key = 0; key < channel.keys(); ++key) {
    double time = micro(key);
    if (!times.empty() && time <= times.back()) {
      time = times.back() + 1;
      if (key + 1 < channel.keys() && micro(key + 1) <= time) continue;
    }
    kept.push_back(key);
    times.push_back(time);
  }
  RigChannel out = with_keys(channel, kept);
  for (std::size_t i = 0; i < times.size(); ++i) out.times[i] = times[i] / 1e6;
  return out;
}

RigChannel with_close_rotations(const RigChannel& channel) {
  constexpr double kMostDegrees = 0.002;  // along a chain of joints they add up
  if (channel.path != ChannelPath::kRotation || channel.interpolation != Interpolation::kLinear)
    return channel;
  RigChannel out = with_keys(channel, {0});
  const auto add = [&](double time) {
    const std::vector<double> value = channel.at(time);
    out.times.push_back(time);
    out.values.insert(out.values.end(), value.begin(), value.end());
  };
  for (std::size_t key = 1; key < channel.keys(); ++key) {
    const double from = channel.times[key - 1];
    const double to = channel.times[key];
    const auto is_close = [&](int parts) {
      // The error of the first part at the place where it is largest, (1 - 1/sqrt 3) / 2.
      constexpr double kPlace = 0.21132486540518713;
      const Quaternion a = quaternion(channel.at(from));
      const double end = from + (to - from) / parts;
      Quaternion b = quaternion(channel.at(end));
      if (inner(a, b) < 0) b = b * -1;
      const Quaternion straight = unit_length(a * (1 - kPlace) + b * kPlace);
      return degrees_between(straight, slerp(a, b, kPlace)) <= kMostDegrees;
    };
    int parts = 1;
    while (parts < 32 && !is_close(parts)) ++parts;
    for (int i = 1; i < parts; ++i) add(from + (to - from) * i / parts);
    add(to);
  }
  return out.keys() <= kMostKeys ? out : channel;
}

}  // namespace arcspan::tools
