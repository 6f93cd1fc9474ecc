// SPDX-License-Identifier: MIT
#include <arcspan/animate/key_frame.hpp>
#include <arcspan/animate/short_quaternion.hpp>
#include <arcspan/numbers/integer.hpp>

#include <bit>

namespace arcspan {

namespace {

constexpr std::int32_t kOne = 32768;

/// The factors of a cubic between two keys, 15 fraction bits. Those of the values add up to 1.
struct CubicFactors {
  std::int32_t from;
  std::int32_t out;
  std::int32_t to;
  std::int32_t in;

  explicit CubicFactors(std::uint32_t fraction) {
    const auto s = static_cast<std::int32_t>(fraction);
    const std::int32_t s2 = (s * s + kOne / 2) >> 15;
    const std::int32_t s3 = (s2 * s + kOne / 2) >> 15;
    to = 3 * s2 - 2 * s3;
    from = kOne - to;
    out = s3 - 2 * s2 + s;
    in = s3 - s2;
  }
};

/// Components i of the two values at a place, and of the tangents between them, in a channel of values of
/// `width` numbers.
template <class Number>
class KeyValues {
 public:
  KeyValues(const Number* values, std::size_t width, Interpolation interpolation, const KeyPlace& place)
      : width_(width), is_cubic_(interpolation == Interpolation::kCubic) {
    at_ = values + place.key * stride() + (is_cubic_ ? width : 0);
  }
  [[nodiscard]] std::int32_t from(std::size_t i) const { return at_[i]; }
  [[nodiscard]] std::int32_t to(std::size_t i) const { return at_[stride() + i]; }
  [[nodiscard]] std::int32_t out(std::size_t i) const { return at_[width_ + i]; }
  [[nodiscard]] std::int32_t in(std::size_t i) const { return at_[stride() - width_ + i]; }
  /// The cubic at component i; tangents have `tangent_up` fraction bits fewer than values.
  [[nodiscard]] std::int64_t cubic(const CubicFactors& factors, std::size_t i, int tangent_up) const {
    const std::int64_t tangents = std::int64_t{out(i)} * factors.out + std::int64_t{in(i)} * factors.in;
    return std::int64_t{from(i)} * factors.from + std::int64_t{to(i)} * factors.to +
           tangents * (std::int64_t{1} << tangent_up);
  }

 private:
  [[nodiscard]] std::size_t stride() const { return is_cubic_ ? 3 * width_ : width_; }

  const Number* at_;
  std::size_t width_;
  bool is_cubic_;
};

/// Component i of a vector at a place.
template <class Number>
std::int32_t vector_at(const KeyValues<Number>& keys, Interpolation interpolation, const KeyPlace& place,
                       std::size_t i, std::int32_t most) {
  if (interpolation == Interpolation::kStep || place.fraction == 0) return keys.from(i);
  if (interpolation == Interpolation::kCubic) {
    const CubicFactors factors(place.fraction);
    return limited((keys.cubic(factors, i, 0) + kOne / 2) >> 15, most);
  }
  const std::int64_t way = std::int64_t{keys.to(i)} - keys.from(i);
  return keys.from(i) +
         static_cast<std::int32_t>((way * static_cast<std::int32_t>(place.fraction) + kOne / 2) >> 15);
}

/// Three numbers of 32 bits.
void set_vector(const std::int32_t* values, Interpolation interpolation, const KeyPlace& place,
                std::int32_t most, std::int32_t (&vector)[3]) {
  const KeyValues<std::int32_t> keys(values, 3, interpolation, place);
  for (std::size_t i = 0; i < 3; ++i) vector[i] = vector_at(keys, interpolation, place, i, most);
}

void set_rotation(const std::int16_t* values, Interpolation interpolation, const KeyPlace& place,
                  std::int32_t (&q)[4]) {
  const KeyValues<std::int16_t> keys(values, 4, interpolation, place);
  if (interpolation == Interpolation::kCubic && place.fraction != 0) {
    const CubicFactors factors(place.fraction);
    std::int64_t c[4];
    for (std::size_t i = 0; i < 4; ++i) c[i] = keys.cubic(factors, i, 15 - animation_binary::kTangentBits);
    return detail::shorten(c, q);
  }
  std::int32_t from[4];
  for (std::size_t i = 0; i < 4; ++i) from[i] = keys.from(i);
  if (interpolation == Interpolation::kStep || place.fraction == 0) return detail::shorten(from, q);
  std::int32_t to[4];
  for (std::size_t i = 0; i < 4; ++i) to[i] = keys.to(i);
  detail::interpolate(from, to, static_cast<std::int32_t>(place.fraction), q);
}

/// a + (b - a) * weight / 65536 of numbers of 16 bits.
std::int16_t between(std::int32_t a, std::int32_t b, std::uint32_t weight) {
  return static_cast<std::int16_t>(a + (((b - a) * static_cast<std::int32_t>(weight >> 2)) >> 14));
}

/// The part of the way from `begin` to `end` at which `time` is, in 32768ths, rounded down; begin <= time <
/// end.
std::uint32_t fraction_of(std::uint32_t time, std::uint32_t begin, std::uint32_t end) {
  const int width = static_cast<int>(std::bit_width(end - begin));
  const int down = width > 17 ? width - 17 : 0;
  const std::uint32_t gone = (time - begin) >> down;  // below 2^17
  return (gone << 15) / ((end - begin) >> down);
}

}  // namespace

KeyPlace key_place(const std::uint32_t* times, std::size_t count, std::uint32_t time) {
  std::size_t low = 0;  // the last key that is known not to be after the time
  std::size_t high = count;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    if (times[middle] <= time) {
      low = middle;
    } else {
      high = middle;
    }
  }
  if (low + 1 == count || time <= times[low]) return {low, 0};
  const std::uint32_t fraction = fraction_of(time, times[low], times[low + 1]);
  // The quotient reaches 1 where dropped bits made the divisor smaller.
  return {low, fraction < kOne ? fraction : kOne - 1};
}

KeyPlace ClipSampler::place_in(const StoredChannel& channel) {
  if (channel.times != kept_times_ || channel.keys != kept_keys_) {
    kept_times_ = channel.times;
    kept_keys_ = channel.keys;
    kept_place_ = key_place(clip_.times(channel), channel.keys, time_);
  }
  return kept_place_;
}

void ClipSampler::set(std::size_t node, NodePose& pose) {
  const std::span<const StoredChannel> channels = clip_.channels();
  for (; next_ < channels.size(); ++next_) {
    const StoredChannel& channel = channels[next_];
    if (channel.path == ChannelPath::kMorphWeights || channel.target > node) return;
    if (channel.target < node) continue;
    const KeyPlace place = place_in(channel);
    switch (channel.path) {
      case ChannelPath::kTranslation:
        set_vector(clip_.values<std::int32_t>(channel), channel.interpolation, place,
                   animation_binary::kLongestLength, pose.translation);
        break;
      case ChannelPath::kRotation:
        set_rotation(clip_.values<std::int16_t>(channel), channel.interpolation, place, pose.rotation);
        break;
      default:
        set_vector(clip_.values<std::int32_t>(channel), channel.interpolation, place,
                   animation_binary::kLargestScale, pose.scale);
        break;
    }
  }
}

void ClipSampler::blend_weights(std::size_t part, std::span<const std::int16_t> rest, std::uint32_t weight,
                                std::int16_t* weights) {
  const StoredChannel* channel = nullptr;
  for (const StoredChannel& other : clip_.channels()) {
    if (other.path == ChannelPath::kMorphWeights && other.target == part) channel = &other;
  }
  if (channel == nullptr) {
    for (std::size_t i = 0; i < rest.size(); ++i) weights[i] = between(weights[i], rest[i], weight);
    return;
  }
  const KeyPlace place = place_in(*channel);
  const KeyValues<std::int16_t> keys(clip_.values<std::int16_t>(*channel), rest.size(),
                                     channel->interpolation, place);
  for (std::size_t i = 0; i < rest.size(); ++i)
    weights[i] = between(weights[i], vector_at(keys, channel->interpolation, place, i, 32767), weight);
}

}  // namespace arcspan
