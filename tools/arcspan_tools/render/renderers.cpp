// SPDX-License-Identifier: MIT
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

constexpr PixelChoice kPixelChoices[] = {{"rgb565"}, {"rgb888"},       {"gray8"},       {"gray4"},
                                         {"mono"},   {"rgb565", true}, {"gray4", true}, {"mono", true}};

std::vector<Renderer> all_renderers() {
  std::vector<Renderer> all;
  for (const ShadingRenderer& method : shading_renderers()) {
    for (const PixelChoice& pixels : kPixelChoices) {
      all.push_back({method.shading, pixels.format, pixels.dithers, method.function});
    }
  }
  return all;
}

std::vector<std::string> names(std::string_view Renderer::*member) {
  std::vector<std::string> result;
  for (const Renderer& renderer : renderers()) {
    const std::string name(renderer.*member);
    if (std::find(result.begin(), result.end(), name) == result.end()) result.push_back(name);
  }
  return result;
}

}  // namespace

std::span<const Renderer> renderers() {
  static const std::vector<Renderer> kAll = all_renderers();
  return kAll;
}

const Renderer& find_renderer(std::string_view shading, std::string_view format, bool dithers) {
  const Renderer* found = nullptr;
  for (const Renderer& renderer : renderers()) {
    if (renderer.shading != shading || renderer.format != format) continue;
    if (renderer.dithers == dithers) return renderer;
    if (dithers) found = &renderer;  // a format that has nothing to dither
  }
  if (found == nullptr) throw Failure(std::string(shading) + ", " + std::string(format), "no such renderer");
  return *found;
}

std::vector<std::string> shading_names() { return names(&Renderer::shading); }
std::vector<std::string> format_names() { return names(&Renderer::format); }

}  // namespace arcspan::tools
