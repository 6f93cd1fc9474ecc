// SPDX-License-Identifier: MIT
#include <arcspan/pixel/pixel_format_list.hpp>

#include <arcspan_tools/render/pixel_choice.hpp>

#include <vector>

namespace arcspan::tools {
namespace {

/// Whether the format keeps all 256 greys, so that there is nothing to dither.
template <class Format>
constexpr bool keeps_8_bits() {
  for (unsigned grey = 0; grey < 256; ++grey) {
    const auto level = static_cast<std::uint8_t>(grey);
    if (Format::decode(Format::encode(Rgb8{level, level, level})) != Rgb8{level, level, level}) return false;
  }
  return true;
}

std::vector<PixelChoice> all_choices() {
  std::vector<PixelChoice> all;
#define ARCSPAN_PLAIN(name, Format) all.push_back({#name, false});
#define ARCSPAN_DITHERED(name, Format) \
  if constexpr (!keeps_8_bits<Format>()) all.push_back({#name, true});
  ARCSPAN_FOR_EACH_PIXEL_FORMAT(ARCSPAN_PLAIN)
  ARCSPAN_FOR_EACH_PIXEL_FORMAT(ARCSPAN_DITHERED)
#undef ARCSPAN_PLAIN
#undef ARCSPAN_DITHERED
  return all;
}

}  // namespace

std::span<const PixelChoice> pixel_choices() {
  static const std::vector<PixelChoice> kAll = all_choices();
  return kAll;
}

}  // namespace arcspan::tools
