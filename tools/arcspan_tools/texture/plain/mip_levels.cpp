// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/texture/plain/mip_levels.hpp>
#include <stb/stb_image_resize.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>

namespace arcspan::tools {
namespace {

constexpr std::int32_t kLeastTexels = 1 << TextureSize::kLeastBits;
constexpr std::int32_t kMostTexels = 1 << TextureSize::kMostBits;

std::uint8_t bits_of(std::int32_t side, const std::string& subject) {
  if (side >= kLeastTexels && side <= kMostTexels && std::has_single_bit(static_cast<std::uint32_t>(side))) {
    return static_cast<std::uint8_t>(std::countr_zero(static_cast<std::uint32_t>(side)));
  }
  throw Failure(subject,
                "a texture's side must be a power of two from 8 to 1024, not " + std::to_string(side));
}

/// How a side of `side` texels continues beyond its edges. Enlarging reads up to two texels there, and
/// STBIR_EDGE_REFLECT reads outside of the picture if the side has no more than that.
stbir_edge edge_of(TextureWrap wrap, std::int32_t side) {
  if (wrap == TextureWrap::kRepeat) return STBIR_EDGE_WRAP;
  return wrap == TextureWrap::kClamp || side <= 2 ? STBIR_EDGE_CLAMP : STBIR_EDGE_REFLECT;
}

/// The filter for an axis of the largest level. One that keeps its side is copied, because the default would
/// blur it. Texels that are drawn as squares stay squares: without it a picture of few texels, such as a
/// palette, would have colours of its neighbours in the middle of each.
stbir_filter filter_of(std::int32_t from, std::int32_t to, TextureFilter drawn_by) {
  const bool is_copied = from == to || (from < to && drawn_by == TextureFilter::kNearest);
  return is_copied ? STBIR_FILTER_BOX : STBIR_FILTER_DEFAULT;
}

struct AxisFilters {
  stbir_filter u;
  stbir_filter v;
};

RgbaImage resized(const RgbaImage& from, std::int32_t width, std::int32_t height, const AxisFilters& filters,
                  const TextureSampler& sampler) {
  RgbaImage to(width, height);
  constexpr int kAlphaAt = 3;
  const int done =
      stbir_resize(&from.pixels[0].r, from.width, from.height, 0, &to.pixels[0].r, width, height, 0,
                   STBIR_TYPE_UINT8, 4, kAlphaAt, 0, edge_of(sampler.u, from.width),
                   edge_of(sampler.v, from.height), filters.u, filters.v, STBIR_COLORSPACE_SRGB, nullptr);
  if (done == 0) throw std::bad_alloc();  // nothing else can go wrong in it
  return to;
}

}  // namespace

std::int32_t nearest_side(std::int32_t side) {
  const auto bits = std::lround(std::log2(static_cast<double>(side)));
  return std::clamp(std::int32_t{1} << bits, kLeastTexels, kMostTexels);
}

TextureSize texture_size(const Size& sides, std::int32_t levels, const std::string& subject) {
  TextureSize size{bits_of(sides.width, subject), bits_of(sides.height, subject), 1};
  const std::int32_t most = std::min(size.width_bits, size.height_bits) + 1;
  if (levels > most) {
    throw Failure(subject, "a texture of " + std::to_string(sides.width) + "x" +
                               std::to_string(sides.height) + " has at most " + std::to_string(most) +
                               " levels, not " + std::to_string(levels));
  }
  size.levels = static_cast<std::uint8_t>(levels == 0 ? most : levels);
  return size;
}

std::vector<RgbaImage> mip_levels(const RgbaImage& picture, const TextureSize& size,
                                  const TextureSampler& sampler) {
  const std::int32_t width = 1 << size.width_bits;
  const std::int32_t height = 1 << size.height_bits;
  std::vector<RgbaImage> levels;
  const bool fits = picture.width == width && picture.height == height;
  const AxisFilters filters{filter_of(picture.width, width, sampler.filter),
                            filter_of(picture.height, height, sampler.filter)};
  levels.push_back(fits ? picture : resized(picture, width, height, filters, sampler));
  // Each is made of the largest, so that it is rounded once.
  for (unsigned i = 1; i < size.levels; ++i) {
    levels.push_back(
        resized(levels[0], width >> i, height >> i, {STBIR_FILTER_BOX, STBIR_FILTER_BOX}, sampler));
  }
  return levels;
}

}  // namespace arcspan::tools
