// SPDX-License-Identifier: MIT
#include <arcspan_tools/texture/compile/choose_palette.hpp>
#include <libimagequant.h>

#include <algorithm>
#include <memory>
#include <new>
#include <set>
#include <span>

namespace arcspan::tools {
namespace {

/// sRGB, the library's default.
constexpr double kGamma = 0;

template <auto destroy>
struct Destroy {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};
using Attributes = std::unique_ptr<liq_attr, Destroy<liq_attr_destroy>>;
using LibraryImage = std::unique_ptr<liq_image, Destroy<liq_image_destroy>>;
using Histogram = std::unique_ptr<liq_histogram, Destroy<liq_histogram_destroy>>;
using Result = std::unique_ptr<liq_result, Destroy<liq_result_destroy>>;

// With arguments in range, memory is the only thing that can run out.
void require(liq_error error) {
  if (error != LIQ_OK) throw std::bad_alloc();
}

template <class T>
T* require(T* object) {
  if (object == nullptr) throw std::bad_alloc();
  return object;
}

/// The library's form of the levels, which must outlive it.
std::vector<LibraryImage> to_library(const liq_attr* attributes, const std::vector<RgbaImage>& levels) {
  std::vector<LibraryImage> images;
  images.reserve(levels.size());
  for (const RgbaImage& level : levels) {
    images.emplace_back(
        require(liq_image_create_rgba(attributes, level.pixels.data(), level.width, level.height, kGamma)));
  }
  return images;
}

/// Chooses colours for all images together; those that are `fixed` are taken.
Result quantised(liq_attr* attributes, const std::vector<LibraryImage>& images,
                 std::span<const liq_color> fixed) {
  const Histogram histogram(require(liq_histogram_create(attributes)));
  for (const liq_color& colour : fixed) {
    require(liq_histogram_add_fixed_color(histogram.get(), colour, kGamma));
  }
  for (const LibraryImage& image : images) {
    require(liq_histogram_add_image(histogram.get(), attributes, image.get()));
  }
  liq_result* result = nullptr;
  require(liq_histogram_quantize(histogram.get(), attributes, &result));
  return Result(result);
}

std::uint16_t stored(const liq_color& c, unsigned alpha_bits) {
  return stored_colour({c.r, c.g, c.b, c.a}, alpha_bits);
}

/// The colours of a result as the format draws them.
std::vector<liq_color> drawn_colours(liq_result* result, unsigned alpha_bits) {
  const liq_palette* const palette = liq_get_palette(result);
  std::set<std::uint16_t> colours;
  for (const liq_color& c : std::span(palette->entries, palette->count)) {
    colours.insert(stored(c, alpha_bits));
  }
  std::vector<liq_color> drawn;
  for (const std::uint16_t colour : colours) {
    const Rgba8 c = drawn_colour(colour, alpha_bits);
    drawn.push_back({c.r, c.g, c.b, c.a});
  }
  return drawn;
}

/// The colour of texels that are fully transparent, if there are any: they must not become visible.
std::vector<liq_color> transparent_colour(const std::vector<RgbaImage>& levels) {
  for (const RgbaImage& level : levels) {
    for (const Rgba8 c : level.pixels) {
      if (c.a == 0) return {{0, 0, 0, 0}};
    }
  }
  return {};
}

}  // namespace

void choose_palette(const std::vector<RgbaImage>& levels, bool dither, MadeTexture& texture) {
  const unsigned alpha_bits = texture.format.alpha_bits;
  const Attributes attributes(require(liq_attr_create()));
  const auto most = static_cast<int>(texture_binary::palette_size(texture.format.layout));
  require(liq_set_max_colors(attributes.get(), most));
  const std::vector<LibraryImage> images = to_library(attributes.get(), levels);
  // The colours are chosen with 8 bits per channel. Pictures are mapped to what the format makes of them.
  const Result chosen = quantised(attributes.get(), images, transparent_colour(levels));
  const std::vector<liq_color> fixed = drawn_colours(chosen.get(), alpha_bits);
  require(liq_set_max_colors(attributes.get(), std::max(static_cast<int>(fixed.size()), 2)));
  const Result result = quantised(attributes.get(), images, fixed);
  require(liq_set_dithering_level(result.get(), dither ? 1.0F : 0.0F));
  for (std::size_t i = 0; i < levels.size(); ++i) {
    std::vector<std::uint8_t> indices(levels[i].pixels.size());
    require(liq_write_remapped_image(result.get(), images[i].get(), indices.data(), indices.size()));
    texture.texels.insert(texture.texels.end(), indices.begin(), indices.end());
  }
  const liq_palette* const palette = liq_get_palette(result.get());
  for (const liq_color& c : std::span(palette->entries, palette->count)) {
    texture.palette.push_back(stored(c, alpha_bits));
  }
}

}  // namespace arcspan::tools
