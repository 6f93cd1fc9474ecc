// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/metrics.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {
namespace {

constexpr int kRadius = 5;
constexpr double kSigma = 1.5;
constexpr double kC1 = (0.01 * 255) * (0.01 * 255);
constexpr double kC2 = (0.03 * 255) * (0.03 * 255);

/// One double per pixel.
struct Plane {
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::vector<double> values;

  Plane(std::int32_t w, std::int32_t h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  [[nodiscard]] double& at(std::int32_t x, std::int32_t y) { return values[index(x, y)]; }
  [[nodiscard]] double at(std::int32_t x, std::int32_t y) const { return values[index(x, y)]; }

 private:
  [[nodiscard]] std::size_t index(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

double luma_of(const ChannelLevels& c) { return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2]; }
ChannelLevels levels_of(Rgb8 c) { return {double(c.r), double(c.g), double(c.b)}; }

/// A Gaussian blur of a row or column; beyond the picture its border goes on.
template <bool Down>
Plane blurred_one_way(const Plane& in) {
  constexpr std::size_t kTaps = 2 * kRadius + 1;
  std::array<double, kTaps> weights{};
  double sum = 0;
  for (std::size_t tap = 0; tap < kTaps; ++tap) {
    const int i = static_cast<int>(tap) - kRadius;
    sum += weights[tap] = std::exp(-i * i / (2 * kSigma * kSigma));
  }
  const std::int32_t lines = Down ? in.width : in.height;
  const std::int32_t length = Down ? in.height : in.width;
  Plane out(in.width, in.height);
  std::vector<double> line(static_cast<std::size_t>(length) + 2 * kRadius);  // with its border
  for (std::int32_t i = 0; i < lines; ++i) {
    std::int32_t from = -kRadius;
    for (double& value : line) {
      const std::int32_t place = std::clamp(from++, 0, length - 1);
      value = Down ? in.at(i, place) : in.at(place, i);
    }
    for (std::int32_t place = 0; place < length; ++place) {
      const double* const first = line.data() + place;
      double value = 0;
      for (std::size_t tap = 0; tap < kTaps; ++tap) value += weights[tap] * first[tap];
      (Down ? out.at(i, place) : out.at(place, i)) = value / sum;
    }
  }
  return out;
}

Plane blurred(const Plane& in) { return blurred_one_way<true>(blurred_one_way<false>(in)); }

Plane product(const Plane& a, const Plane& b) {
  Plane out(a.width, a.height);
  for (std::size_t i = 0; i < a.values.size(); ++i) out.values[i] = a.values[i] * b.values[i];
  return out;
}

double mean_ssim(const Plane& a, const Plane& b, const ReferencePicture& reference) {
  const Plane mean_a = blurred(a);
  const Plane mean_b = blurred(b);
  const Plane square_a = blurred(product(a, a));
  const Plane square_b = blurred(product(b, b));
  const Plane mixed = blurred(product(a, b));
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if (reference.numbers[i] == 0) continue;
    const double ma = mean_a.values[i];
    const double mb = mean_b.values[i];
    const double variances = square_a.values[i] - ma * ma + square_b.values[i] - mb * mb;
    const double covariance = mixed.values[i] - ma * mb;
    sum += (2 * ma * mb + kC1) * (2 * covariance + kC2) / ((ma * ma + mb * mb + kC1) * (variances + kC2));
    ++count;
  }
  return count == 0 ? 1 : sum / static_cast<double>(count);
}

}  // namespace

PictureError picture_error(const Image& picture, const ReferencePicture& reference, Rgb8 background) {
  PictureError error;
  Plane ours(reference.width, reference.height);
  Plane theirs(reference.width, reference.height);
  double squares = 0;
  for (std::int32_t y = 0; y < reference.height; ++y) {
    for (std::int32_t x = 0; x < reference.width; ++x) {
      const ChannelLevels drawn = levels_of(picture.at(x, y));
      const ReferenceSample* sample = reference.at(x, y);
      const ChannelLevels wanted = sample == nullptr ? levels_of(background) : sample->levels;
      ours.at(x, y) = luma_of(drawn);
      theirs.at(x, y) = luma_of(wanted);
      if (sample == nullptr) continue;
      ++error.pixels;
      for (std::size_t c = 0; c < 3; ++c) {
        const double d = std::fabs(drawn[c] - wanted[c]);
        error.max = std::max(error.max, d);
        squares += d * d;
      }
    }
  }
  if (error.pixels > 0) error.rms = std::sqrt(squares / (3.0 * static_cast<double>(error.pixels)));
  error.psnr = error.rms > 0 ? 20 * std::log10(255 / error.rms) : INFINITY;
  error.ssim = mean_ssim(ours, theirs, reference);
  return error;
}

std::vector<double> error_map(const Image& picture, const ReferencePicture& reference) {
  std::vector<double> map(reference.numbers.size());
  std::size_t i = 0;
  for (std::int32_t y = 0; y < reference.height; ++y) {
    for (std::int32_t x = 0; x < reference.width; ++x, ++i) {
      const ReferenceSample* sample = reference.at(x, y);
      if (sample == nullptr) continue;
      const ChannelLevels drawn = levels_of(picture.at(x, y));
      for (std::size_t c = 0; c < 3; ++c) map[i] = std::max(map[i], std::fabs(drawn[c] - sample->levels[c]));
    }
  }
  return map;
}

}  // namespace arcspan::tools
