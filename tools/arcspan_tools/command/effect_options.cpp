// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/effect_options.hpp>
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/render/render.hpp>

#include <cmath>
#include <iterator>
#include <vector>

namespace arcspan::tools {
namespace {

struct NamedTransparency {
  const char* name;
  Transparency kind;
};
constexpr NamedTransparency kTransparencies[] = {{"alpha", Transparency::kAlpha},
                                                 {"add", Transparency::kAdd},
                                                 {"multiply", Transparency::kMultiply},
                                                 {"screen-door", Transparency::kScreenDoor},
                                                 {"none", Transparency::kNone}};

// `NEAR,FAR[#R,G,B]`.
std::optional<SceneFog> parse_fog(const std::string& text) {
  const std::size_t hash = text.find('#');
  const std::string range = text.substr(0, hash);
  const std::size_t comma = range.find(',');
  if (comma == std::string::npos) return std::nullopt;
  const std::optional<double> from = parse_number(range.substr(0, comma));
  const std::optional<double> to = parse_number(range.substr(comma + 1));
  if (!from || !to || !std::isfinite(*from) || !std::isfinite(*to) || !(*from < *to)) return std::nullopt;
  SceneFog fog{*from, *to};
  if (hash != std::string::npos) {
    fog.colour = parse_colour(text.substr(hash + 1));
    if (!fog.colour) return std::nullopt;
  }
  return fog;
}

void add_blend(CLI::App& app, Scene& scene) {
  std::string names;
  for (const NamedTransparency& each : kTransparencies)
    names += (names.empty() ? "" : "|") + std::string(each.name);
  add_parsed<Transparency>(
      app, "--blend", names,
      "how transparent surfaces are drawn: mixed with what is behind (default), added to it, multiplied, as "
      "a pattern of pixels, or opaque",
      names,
      [](const std::string& text) -> std::optional<Transparency> {
        for (const NamedTransparency& each : kTransparencies) {
          if (text == each.name) return each.kind;
        }
        return std::nullopt;
      },
      [&scene](Transparency kind) { scene.transparency = kind; });
}

[[noreturn]] void refuse(const char* option, const std::string& complaint) {
  throw CLI::ValidationError(option, complaint);
}

/// Refuses what an environment map replaces.
void check_matcap(const RenderOptions& o) {
  if (o.shading != "arc") refuse("--matcap", "is drawn by --shading arc, not " + o.shading);
  std::vector<const char*> replaced(std::begin(kLightOptions), std::end(kLightOptions));
  replaced.insert(replaced.end(), {"--colour", "--texture", "--vertex-colours"});
  for (const char* option : replaced) {
    if (o.is_given(option)) refuse(option, "--matcap replaces all light and colour");
  }
}

}  // namespace

void add_effects(CLI::App& app, RenderOptions& o) {
  app.add_flag_function(
      "--vertex-colours,!--no-vertex-colours", [&o](std::int64_t count) { o.vertex_colours = count > 0; },
      "interpolate vertex colours, lit as by gouraud (default unless another shading is chosen), or "
      "draw each triangle in their mean");
  add_parsed<double>(
      app, "--alpha", "0...1", "opacity of all surfaces, times that of the file's materials and textures",
      "a number 0...1",
      [](const std::string& text) {
        const std::optional<double> v = parse_number(text);
        return v && *v >= 0 && *v <= 1 ? v : std::nullopt;
      },
      [&o](double v) { o.scene.alpha = v; });
  add_blend(app, o.scene);
  add_parsed<SceneFog>(
      app, "--fog", "NEAR,FAR[#R,G,B]",
      "fog that begins NEAR from the camera and hides everything at FAR, in the model's units, of a colour "
      "with each of R,G,B 0...1 (default: the background's)",
      "NEAR,FAR[#R,G,B] with NEAR below FAR and each of R,G,B 0...1", parse_fog,
      [&o](const SceneFog& fog) { o.scene.fog = fog; });
  app.add_option("--matcap", o.matcap,
                 "a picture of a shiny sphere as PNG, JPEG, BMP, TGA, PPM or PGM, in place of all light and "
                 "colour; drawn by arc");
}

void check_effects(const CLI::App& app, const RenderOptions& o) {
  if (!shading_draws_effects(o.shading)) {
    for (const char* option : kEffectOptions) {
      // --blend and means of vertex colours are what other shadings do.
      const bool has_effect = std::string(option) == "--vertex-colours" ? o.vertex_colours.value_or(false)
                                                                        : std::string(option) != "--blend";
      if (app.count(option) != 0 && has_effect) {
        refuse(option, "only --shading flat, gouraud and arc have it, not " + o.shading);
      }
    }
  }
  if (!o.texture.empty() && !shading_draws_effects(o.shading))
    refuse("--texture", "only --shading flat, gouraud and arc have it, not " + o.shading);
  if (o.crease_degrees && o.shading == "flat")
    refuse("--crease", "--shading flat takes no normals of vertices");
  if (!o.matcap.empty()) check_matcap(o);
  if (o.scene.fog && !o.scene.depth) refuse("--fog", "needs the depth buffer (not --no-depth)");
}

}  // namespace arcspan::tools
