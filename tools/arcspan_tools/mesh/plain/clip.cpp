// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/clip.hpp>
#include <arcspan_tools/mesh/plain/node_transform.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

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

/// At most so many bytes of a longer text, up to the end of a UTF-8 character.
std::string beginning(const std::string& text, std::size_t bytes) {
  const auto continues = [&text](std::size_t i) {
    return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
  };
  while (bytes > 0 && continues(bytes)) --bytes;
  return text.substr(0, bytes);
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

std::optional<std::string> wrong_times(const std::vector<double>& times) {
  // Times of the animation binary have 30 bits of microseconds.
  constexpr double kMostSeconds = 1000;
  if (times.empty()) return "has no keys";
  if (times.size() > kMostKeys) return formatted("has more than %zu keys", kMostKeys);
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!(times[i] >= 0 && times[i] <= kMostSeconds))
      return formatted("key %zu is not at a time of 0...%g s", i, kMostSeconds);
    if (i > 0 && !(times[i] > times[i - 1])) return formatted("key %zu is not later than the one before", i);
  }
  return std::nullopt;
}

std::optional<std::string> wrong_values(const RigChannel& channel) {
  const std::size_t of_key = channel.interpolation == Interpolation::kCubic ? 3 : 1;
  if (channel.values.size() < channel.keys() * channel.components * of_key)
    return "has fewer values than there are keys";
  for (const double value : channel.values) {
    if (!std::isfinite(value)) return "has a value that is not finite";
  }
  for (std::size_t i = 0; channel.path == ChannelPath::kRotation && i < channel.keys(); ++i) {
    const Quaternion q = quaternion(channel.value(i));
    if (!(inner(q, q) > 0)) return formatted("key %zu is no rotation", i);
  }
  return std::nullopt;
}

void name_clips(std::vector<RigClip>& clips) {
  std::set<std::string> taken;  // first by the file
  for (const RigClip& clip : clips) taken.insert(clip.name);
  std::map<std::string, std::size_t> next;  // numbers for the names that were met
  for (std::size_t i = 0; i < clips.size(); ++i) {
    std::string& name = clips[i].name;
    if (!name.empty() && next.try_emplace(name, 2).second) continue;
    const std::string base = name.empty() ? "clip" : name;
    std::size_t own = i + 1;
    std::size_t& n = name.empty() ? own : next[base];
    do {
      name = base + std::to_string(n++);
    } while (!taken.insert(name).second);
  }
}

std::vector<std::string> shortened(std::vector<std::string> names, std::size_t most) {
  std::set<std::string> taken;
  for (const std::string& name : names) {
    if (name.size() <= most) taken.insert(name);
  }
  std::map<std::string, std::size_t> next;  // numbers for the beginnings of long names
  for (std::string& name : names) {
    if (name.size() <= most) continue;
    const std::string whole = name;
    name = beginning(whole, most);
    for (std::size_t& n = next.try_emplace(name, 2).first->second; !taken.insert(name).second; ++n) {
      const std::string number = std::to_string(n);
      name = beginning(whole, most - number.size()) + number;
    }
  }
  return names;
}

}  // namespace arcspan::tools
