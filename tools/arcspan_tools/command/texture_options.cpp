// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/texture_options.hpp>
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/support/text.hpp>
#include <arcspan_tools/texture/plain/mip_levels.hpp>

#include <vector>

namespace arcspan::tools {
namespace {

std::string texel_format_names() {
  std::vector<std::string> names;
  for (const TextureFormat& format : texture_formats()) names.emplace_back(format.name);
  return joined(names, "|");
}

std::optional<Size> parse_sides(const std::string& text) {
  const std::optional<Size> sides =
      parse_size(text.find('x') == std::string::npos ? text + "x" + text : text);
  const auto fits = [](std::int32_t side) { return nearest_side(side) == side; };
  return sides && fits(sides->width) && fits(sides->height) ? sides : std::nullopt;
}

std::optional<TextureWrap> parse_wrap(const std::string& text) {
  if (text == "repeat") return TextureWrap::kRepeat;
  if (text == "clamp") return TextureWrap::kClamp;
  return text == "mirror" ? std::optional(TextureWrap::kMirror) : std::nullopt;
}

/// The wraps of u and v: one for both, or two.
std::optional<TextureSampler> parse_wraps(const std::string& text) {
  const std::size_t comma = text.find(',');
  const std::optional<TextureWrap> u = parse_wrap(text.substr(0, comma));
  const std::optional<TextureWrap> v = comma == std::string::npos ? u : parse_wrap(text.substr(comma + 1));
  return u && v ? std::optional(TextureSampler{*u, *v}) : std::nullopt;
}

std::optional<TextureFilter> parse_filter(const std::string& text) {
  if (text == "nearest") return TextureFilter::kNearest;
  return text == "bilinear" ? std::optional(TextureFilter::kBilinear) : std::nullopt;
}

std::optional<std::int32_t> parse_levels(const std::string& text) {
  constexpr std::int64_t kMost = TextureSize::kMostBits + 1;
  if (text == "all") return 0;
  const std::optional<std::int64_t> value = parse_integer(text);
  if (!value || *value < 1 || *value > kMost) return std::nullopt;
  return static_cast<std::int32_t>(*value);
}

}  // namespace

TextureOptions default_texture_options() { return {texture_formats().front()}; }

TextureOptions default_model_texture_options() {
  TextureOptions options{find_texture_format("pal8").value()};
  options.most_side = 128;
  return options;
}

void add_texture(CLI::App& app, std::string& picture) {
  app.add_option(
      "--texture", picture,
      "a PNG, JPEG, BMP, TGA, PPM or PGM file in place of the textures of the model, which must have "
      "texture coordinates");
}

void add_texture_format(CLI::App& app, const std::string& name, TextureFormat& format) {
  const std::string names = texel_format_names();
  add_parsed<TextureFormat>(
      app, name, names, std::string("the format of texels (default: ") + format.name + ")", names,
      [](const std::string& text) { return find_texture_format(text); },
      [&format](const TextureFormat& f) { format = f; });
}

void add_texture_size(CLI::App& app, const std::string& name, const std::string& otherwise,
                      std::optional<Size>& size) {
  add_parsed<Size>(
      app, name, "N or WIDTHxHEIGHT",
      "sides in texels, powers of two from 8 to 1024 (default: the ones nearest to the picture's" +
          otherwise + ")",
      "powers of two from 8 to 1024, such as 128 or 128x64", parse_sides,
      [&size](const Size& s) { size = s; });
}

void add_sampler(CLI::App& app, TextureSampler& sampler) {
  const std::string wraps = "repeat|clamp|mirror";
  add_parsed<TextureSampler>(
      app, "--wrap", wraps,
      "what the texture shows beyond its borders, or, with a comma between, to the sides and above and below "
      "(default: repeat); edges are filtered alike",
      wraps + ", or two of them with a comma", parse_wraps, [&sampler](const TextureSampler& wrap) {
        sampler = {wrap.u, wrap.v, sampler.filter};
      });
  const std::string filters = "nearest|bilinear";
  add_parsed<TextureFilter>(
      app, "--filter", filters, "the filter that the texture is meant for (default: nearest)", filters,
      parse_filter, [&sampler](const TextureFilter& filter) { sampler.filter = filter; });
}

void add_texture_levels(CLI::App& app, const std::string& name, std::int32_t& levels) {
  add_parsed<std::int32_t>(
      app, name, "N or all",
      "mip levels with the picture itself, as far as islands of an atlas keep two texels (default: 1)",
      "an integer 1...11 or 'all'", parse_levels, [&levels](const std::int32_t& n) { levels = n; });
}

}  // namespace arcspan::tools
