// SPDX-License-Identifier: MIT
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/shading_method_list.hpp>
#include <arcspan_tools/support/failure.hpp>

namespace arcspan::tools {

// Each is defined by a translation unit of its own, which is render_method.hpp for this method.
#define ARCSPAN_DECLARE(name, Class, header) RenderFunction render_##Class;
ARCSPAN_FOR_EACH_SHADING_METHOD(ARCSPAN_DECLARE)
#undef ARCSPAN_DECLARE

namespace {

std::vector<Renderer> all_renderers() {
  std::vector<Renderer> all;
  for (const ShadingRenderer& method : shading_renderers()) {
    for (const PixelChoice& pixels : pixel_choices())
      all.push_back({method.shading, pixels, method.function});
  }
  return all;
}

}  // namespace

std::span<const ShadingRenderer> shading_renderers() {
#define ARCSPAN_ENTRY(name, Class, header) {name, &render_##Class},
  static constexpr ShadingRenderer kRenderers[] = {ARCSPAN_FOR_EACH_SHADING_METHOD(ARCSPAN_ENTRY)};
#undef ARCSPAN_ENTRY
  return kRenderers;
}

std::span<const Renderer> renderers() {
  static const std::vector<Renderer> kAll = all_renderers();
  return kAll;
}

const Renderer& find_renderer(std::string_view shading, std::string_view format, bool dithers) {
  const Renderer* plain = nullptr;
  for (const Renderer& renderer : renderers()) {
    if (renderer.shading != shading || renderer.pixels.format != format) continue;
    if (renderer.pixels.dithers == dithers) return renderer;
    if (dithers) plain = &renderer;
  }
  if (plain == nullptr) throw Failure(std::string(shading) + ", " + std::string(format), "no such renderer");
  return *plain;
}

bool shading_draws_effects(std::string_view shading) {
#define ARCSPAN_COMPARE_NAME(name, Class, header) (shading == (name) && draws_effects(#Class)) ||
  return ARCSPAN_FOR_EACH_PRODUCT_METHOD(ARCSPAN_COMPARE_NAME) false;
#undef ARCSPAN_COMPARE_NAME
}

std::vector<std::string> shading_names() {
  std::vector<std::string> names;
  for (const ShadingRenderer& method : shading_renderers()) names.emplace_back(method.shading);
  return names;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const PixelChoice& pixels : pixel_choices()) {
    if (!pixels.dithers) names.emplace_back(pixels.format);
  }
  return names;
}

}  // namespace arcspan::tools
