// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/clip.hpp>
#include <arcspan_tools/mesh/plain/node_transform.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

Quaternion quaternion(const double* v) { return {v[0], v[1], v[2], v[3]}; }

std::vector<double> numbers(Quaternion q) { return {q.x, q.y, q.z, q.w}; }

/// The Hermite spline of glTF 2.0, appendix C, between two keys that are `seconds` apart.
std::vector<double> spline(const RigChannel& channel, std::size_t key, double t, double seconds) {
  const std::size_t n = channel.components;
  const double* from = channel.value(key);
  const double* leaving = from + n;
  const double* to = channel.value(key + 1);
  const double* arriving = to - n;
  const double t2 = t * t;
  const double t3 = t2 * t;
  std::vector<double> value(n);
  for (std::size_t i = 0; i < n; ++i) {
    value[i] = (2 * t3 - 3 * t2 + 1) * from[i] + seconds * (t3 - 2 * t2 + t) * leaving[i] +
               (-2 * t3 + 3 * t2) * to[i] + seconds * (t3 - t2) * arriving[i];
  }
  return value;
}

}  // namespace

const double* RigChannel::value(std::size_t key) const {
  const std::size_t place = interpolation == Interpolation::kCubic ? 3 * key + 1 : key;
  return values.data() + place * components;
}

std::vector<double> RigChannel::at(double time) const {
  const bool rotates = path == ChannelPath::kRotation;
  const auto as_key = [&](std::size_t key) {
    const double* v = value(key);
    return rotates ? numbers(unit_length(quaternion(v))) : std::vector<double>(v, v + components);
  };
  const auto next = std::upper_bound(times.begin(), times.end(), time);
  if (next == times.begin()) return as_key(0);
  const auto key = static_cast<std::size_t>(next - times.begin()) - 1;
  if (next == times.end() || interpolation == Interpolation::kStep) return as_key(key);
  const double seconds = times[key + 1] - times[key];
  const double t = (time - times[key]) / seconds;
  if (interpolation == Interpolation::kCubic) {
    const std::vector<double> value = spline(*this, key, t, seconds);
    return rotates ? numbers(unit_length(quaternion(value.data()))) : value;
  }
  const double* from = value(key);
  const double* to = value(key + 1);
  if (rotates) return numbers(slerp(unit_length(quaternion(from)), unit_length(quaternion(to)), t));
  std::vector<double> mixed(components);
  for (std::size_t i = 0; i < components; ++i) mixed[i] = from[i] * (1 - t) + to[i] * t;
  return mixed;
}

double RigClip::duration() const {
  double last = 0;
  for (const RigChannel& channel : channels) last = std::max(last, channel.times.back());
  return last;
}

}  // namespace arcspan::tools
