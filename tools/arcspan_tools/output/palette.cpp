// SPDX-License-Identifier: MIT
#include <arcspan_tools/output/palette.hpp>
#include <gif_lib.h>

#include <limits>
#include <new>

namespace arcspan::tools {
namespace {

constexpr std::size_t kMostColours = 256;
/// Pixels that the choice is made from; more of them would not change it for the better.
constexpr std::size_t kMostSamples = 1u << 22;

std::uint32_t key(Rgb8 c) { return (std::uint32_t{c.r} << 16) | (std::uint32_t{c.g} << 8) | c.b; }

std::int32_t squared_distance(Rgb8 a, Rgb8 b) {
  const std::int32_t r = a.r - b.r;
  const std::int32_t g = a.g - b.g;
  const std::int32_t blue = a.b - b.b;
  return r * r + g * g + blue * blue;
}

}  // namespace

Palette::Palette(std::span<const Image> images) {
  if (take_all(images)) return;
  colours_.clear();
  known_.clear();
  choose(images);
}

bool Palette::take_all(std::span<const Image> images) {
  for (const Image& image : images) {
    for (const Rgb8 pixel : image.pixels) {
      if (known_.count(key(pixel)) != 0) continue;
      if (colours_.size() == kMostColours) return false;
      known_.emplace(key(pixel), static_cast<std::uint8_t>(colours_.size()));
      colours_.push_back(pixel);
    }
  }
  return true;
}

void Palette::choose(std::span<const Image> images) {
  std::size_t pixels = 0;
  for (const Image& image : images) pixels += image.pixels.size();
  const std::size_t stride = pixels / kMostSamples + 1;
  std::vector<GifByteType> red;
  std::vector<GifByteType> green;
  std::vector<GifByteType> blue;
  std::size_t at = 0;
  for (const Image& image : images) {
    for (; at < image.pixels.size(); at += stride) {
      red.push_back(image.pixels[at].r);
      green.push_back(image.pixels[at].g);
      blue.push_back(image.pixels[at].b);
    }
    at -= image.pixels.size();
  }
  int count = static_cast<int>(kMostColours);
  std::vector<GifByteType> indices(red.size());
  GifColorType chosen[kMostColours] = {};
  if (GifQuantizeBuffer(static_cast<unsigned>(red.size()), 1, &count, red.data(), green.data(), blue.data(),
                        indices.data(), chosen) == GIF_ERROR) {
    throw std::bad_alloc();  // nothing else can go wrong in it
  }
  for (int i = 0; i < count; ++i) colours_.push_back({chosen[i].Red, chosen[i].Green, chosen[i].Blue});
}

std::uint8_t Palette::index(Rgb8 colour) {
  const auto [at, is_new] = known_.try_emplace(key(colour), std::uint8_t{0});
  if (!is_new) return at->second;
  std::int32_t nearest = std::numeric_limits<std::int32_t>::max();
  for (std::size_t i = 0; i < colours_.size(); ++i) {
    const std::int32_t distance = squared_distance(colour, colours_[i]);
    if (distance >= nearest) continue;
    nearest = distance;
    at->second = static_cast<std::uint8_t>(i);
  }
  return at->second;
}

}  // namespace arcspan::tools
