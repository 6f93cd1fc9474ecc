// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/effect_options.hpp>
#include <arcspan_tools/command/render_options.hpp>
#include <arcspan_tools/command/texture_options.hpp>
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/render/job_outlines.hpp>
#include <arcspan_tools/render/render.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>

namespace arcspan::tools {

std::optional<Vec3> parse_colour(const std::string& text) {
  const std::optional<Vec3> v = parse_triple(text);
  const auto fits = [](double c) { return c >= 0 && c <= 1; };
  return v && fits(v->x) && fits(v->y) && fits(v->z) ? v : std::nullopt;
}

namespace {

constexpr std::size_t kMostLights = 4;
constexpr std::int64_t kMostSegmentBits = 4;
constexpr double kFarthestLight = 1000;
constexpr const char* kPolynomials[] = {"linear", "quadratic",      "cubic",
                                        "root",   "printed-linear", "printed-quadratic"};
constexpr const char* kUsualPolynomial = "quadratic";

std::optional<Vec3> parse_direction(const std::string& text) {
  const std::optional<Vec3> v = parse_triple(text);
  return v && length(*v) > 0 ? v : std::nullopt;
}

// `X,Y,Z[@D][#R,G,B]`.
std::optional<SceneLight> parse_light(const std::string& text) {
  const std::size_t hash = text.find('#');
  const std::string place = text.substr(0, hash);
  const std::size_t at = place.find('@');
  const std::optional<Vec3> towards = parse_direction(place.substr(0, at));
  if (!towards) return std::nullopt;
  SceneLight light(*towards);
  if (at != std::string::npos) {
    const std::optional<double> distance = parse_number(place.substr(at + 1));
    if (!distance || !(*distance >= 0 && *distance <= kFarthestLight)) return std::nullopt;
    light.distance = *distance;
  }
  if (hash != std::string::npos) {
    const std::optional<Vec3> colour = parse_colour(text.substr(hash + 1));
    if (!colour) return std::nullopt;
    light.colour = *colour;
  }
  return light;
}

// One number for all channels, or R,G,B.
std::optional<Share> parse_share(const std::string& text) {
  if (const std::optional<double> all = parse_number(text)) {
    return *all >= 0 && *all <= 1 ? std::optional<Share>(*all) : std::nullopt;
  }
  const std::optional<Vec3> channels = parse_colour(text);
  return channels ? std::optional<Share>(*channels) : std::nullopt;
}

void add_share(CLI::App& app, const std::string& name, const std::string& help, Share& value) {
  std::string standard = std::to_string(value.rgb.x);
  standard.erase(standard.find_last_not_of('0') + 1);
  add_parsed<Share>(app, name, "0...1|R,G,B", help + " (default " + standard + ")",
                    "a number 0...1 or R,G,B with each 0...1", parse_share,
                    [&value](const Share& v) { value = v; });
}

void add_picture_options(CLI::App& app, RenderOptions& o) {
  add_parsed<Size>(
      app, "--size", "WxH", "picture size, each 1...2048 (default 320x240)", "WxH with each 1...2048",
      [](const std::string& text) {
        const std::optional<Size> size = parse_size(text);
        return size && size->width <= kMostRenderedSide && size->height <= kMostRenderedSide ? size
                                                                                             : std::nullopt;
      },
      [&o](Size size) { o.scene.size = size; });
  add_choice(app, "--format", "pixel format", format_names(), o.format);
  app.add_flag("--dither,!--no-dither", o.dither,
               "ordered dither where the format has fewer than 8 bits per channel (default)");
  add_integer(app, "--band", "ROWS", "draw and store the picture ROWS at a time", 1, kMostRenderedSide,
              o.scene.band_rows);
  app.add_flag("--depth,!--no-depth", o.scene.depth, "16-bit depth buffer (default), or painter's order");
  add_parsed<Vec3>(app, "--background", "R,G,B", "each 0...1", "R,G,B with each 0...1", parse_colour,
                   [&o](Vec3 v) { o.scene.background = v; });
}

// `dichotomy` becomes the renderer of its polynomial.
void choose_renderer(RenderOptions& o) {
  if (o.shading == kDichotomy) {
    o.shading = dichotomies(o.polynomial.empty() ? kUsualPolynomial : o.polynomial).front();
  } else if (!o.polynomial.empty()) {
    throw CLI::ValidationError("--polynomial", "only --shading dichotomy has one, not " + o.shading);
  }
  if (o.is_given("--segment") && !has_segments(o.shading)) {
    throw CLI::ValidationError(
        "--segment", "only --shading segment, phong-segment and dichotomy have some, not " + o.shading);
  }
  if (o.is_given("--tolerance") && o.shading != "arc") {
    throw CLI::ValidationError("--tolerance", "only --shading arc has one, not " + o.shading);
  }
}

// --smooth that was asked for and has no effect.
void check_smooth(const RenderOptions& o) {
  if (!o.is_given("--smooth") || !o.smooth || o.smooths()) return;
  if (!o.scene.depth) throw CLI::ValidationError("--smooth", "needs a depth buffer, not --no-depth");
  throw CLI::ValidationError("--smooth", "needs at least 4 bits per pixel, not --format " + o.format);
}

// `R,G,B[:WIDTH]`.
std::optional<OutlineInk> parse_ink(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::optional<Vec3> colour = parse_colour(text.substr(0, colon));
  if (!colour) return std::nullopt;
  OutlineInk ink{to_rgb8(*colour)};
  if (colon == std::string::npos) return ink;
  const std::optional<std::int64_t> width = parse_integer(text.substr(colon + 1));
  if (!width || *width < 1 || *width > OutlineInk::kWidest) return std::nullopt;
  ink.width = static_cast<std::uint8_t>(*width);
  return ink;
}

void check_ink(const RenderOptions& o) {
  if (o.is_given("--ink-creases") && !o.ink) throw CLI::ValidationError("--ink-creases", "needs --ink");
  if (o.ink && !o.scene.depth) throw CLI::ValidationError("--ink", "needs a depth buffer, not --no-depth");
}

void check_curves(const RenderOptions& o) {
  if (o.curved_outlines && !o.has_outlines())
    throw CLI::ValidationError("--curved-outlines", "needs outlines that are smoothed or inked");
}

void check_toon(const RenderOptions& o) {
  if (o.scene.toon_steps == 0) return;
  if (o.shading != "arc") throw CLI::ValidationError("--toon", "needs --shading arc, not " + o.shading);
  if (!o.matcap.empty()) throw CLI::ValidationError("--toon", "excludes --matcap, which replaces all light");
}

// They hold for the whole model, in place of what its file says.
void add_surface_options(CLI::App& app, RenderOptions& o) {
  Surface& surface = o.scene.surface;
  add_parsed<Vec3>(app, "--colour", "R,G,B", "of the surface, each 0...1, in place of the file's colours",
                   "R,G,B with each 0...1", parse_colour, [&surface](Vec3 v) { surface.colour = v; });
  add_share(app, "--ambient", "ambient share of the colour", surface.ambient);
  add_share(app, "--diffuse", "diffuse share of the colour", surface.diffuse);
  add_share(app, "--specular", "share and colour of the highlight, in place of the file's", surface.specular);
  add_integer(app, "--shininess", "1...256", "exponent of the highlight, in place of the file's (default 40)",
              1, 256, surface.shininess);
  add_crease(app, o.crease_degrees);
  add_texture(app, o.texture);
  add_effects(app, o);
}

void add_shading_options(CLI::App& app, RenderOptions& o) {
  const std::vector<std::string> choices = shading_choices();
  const std::string all = joined(choices, "|");
  add_parsed<std::string>(
      app, "--shading", all, "shading method (default " + o.shading + ")", all,
      [choices](const std::string& text) -> std::optional<std::string> {
        if (text == kAdaptive) refuse_adaptive();
        const bool known = std::count(choices.begin(), choices.end(), text) != 0;
        return known ? std::optional(text) : std::nullopt;
      },
      [&o](const std::string& shading) { o.shading = shading; });
  add_parsed<std::string>(
      app, "--polynomial", "linear|quadratic|cubic|root|printed-linear|printed-quadratic",
      "what dichotomy halves arcs by (default quadratic); root and printed are S3's own, with its last "
      "segments",
      "linear, quadratic, cubic, root, printed-linear or printed-quadratic",
      [](const std::string& text) {
        const bool known = std::count(std::begin(kPolynomials), std::end(kPolynomials), text) != 0;
        return known ? std::optional(text) : std::nullopt;
      },
      [&o](const std::string& polynomial) { o.polynomial = polynomial; });
  add_parsed<std::int32_t>(
      app, "--segment", "1...4|adaptive",
      "a segment's length is 2 to this power in pixels (default 2, of dichotomy 3), or the longest whose "
      "error "
      "is at most 1/64 (of dichotomy: that turns by at most 45 degrees)",
      "an integer 1...4 or adaptive",
      [](const std::string& text) -> std::optional<std::int32_t> {
        if (text == "adaptive") return kAdaptiveSegments;
        const std::optional<std::int64_t> bits = parse_integer(text);
        if (!bits || *bits < 1 || *bits > kMostSegmentBits) return std::nullopt;
        return static_cast<std::int32_t>(*bits);
      },
      [&o](std::int32_t bits) { o.scene.segment_bits = bits; });
  add_integer(app, "--tolerance", "0...64", "what arc may be off by, in 8-bit steps (default 1)", 0, 64,
              o.scene.tolerance);
  app.parse_complete_callback([&app, &o] {
    note_settings(app, o);
    choose_renderer(o);
    check_smooth(o);
    check_ink(o);
    check_curves(o);
    check_toon(o);
    o.scene.outlines.smooth = o.smooth;
    o.scene.outlines.ink = o.ink;
    o.scene.outlines.curved = o.curved_outlines;
    if (o.ink) o.scene.outlines.ink->creases = o.ink_creases;
    check_effects(app, o);
  });
  add_parsed<Highlight>(
      app, "--illumination", "blinn|phong", "illumination model (default blinn)", "blinn or phong",
      [](const std::string& text) -> std::optional<Highlight> {
        if (text == "blinn") return Highlight::kBlinn;
        if (text == "phong") return Highlight::kPhong;
        return std::nullopt;
      },
      [&o](Highlight h) { o.scene.highlight = h; });
  add_surface_options(app, o);
  add_number(app, "--highlight-fade",
             "N·L below which the highlight fades out; at 0 it ends at the terminator", 0, 1,
             o.scene.surface.highlight_fade);
  app.add_flag("--two-sided", o.scene.two_sided, "draw back faces too, lit from their side");
  const auto take_light = [&o](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      const std::optional<SceneLight> light = parse_light(text);
      if (!light) {
        throw CLI::ValidationError(
            "--light",
            "expected X,Y,Z[@DISTANCE][#R,G,B] with X,Y,Z not 0,0,0 and each of R,G,B 0...1, not '" + text +
                "'");
      }
      o.lights.push_back(*light);
    }
    if (o.lights.size() > kMostLights) {
      throw CLI::ValidationError("--light", "at most 4 lights, not " + std::to_string(o.lights.size()));
    }
    o.scene.lights = o.lights;
  };
  app.add_option_function<std::vector<std::string>>(
         "--light", take_light,
         "towards a light (default 0.4,0.7,0.6), at a distance (default 0), of a colour with each of R,G,B "
         "0...1 (default white); up to 4 times")
      ->type_name("X,Y,Z[@D][#R,G,B]")
      ->allow_extra_args(false);
  add_number(app, "--attenuation", "K of a light's strength 1/(D + K)", 1, kFarthestLight,
             o.scene.attenuation);
}

void add_camera_options(CLI::App& app, RenderOptions& o) {
  const std::string point = "three numbers X,Y,Z";
  const auto parse_point = [](const std::string& text) { return parse_triple(text); };
  add_parsed<Vec3>(app, "--eye", "X,Y,Z", "where the camera stands (default: the whole mesh in view)", point,
                   parse_point, [&o](Vec3 v) { o.scene.camera.eye = v; });
  add_parsed<Vec3>(app, "--target", "X,Y,Z", "what it looks at (default: the mesh's centre)", point,
                   parse_point, [&o](Vec3 v) { o.scene.camera.target = v; });
  add_parsed<Vec3>(app, "--up", "X,Y,Z", "its upward direction (default 0,1,0)", "a direction X,Y,Z",
                   parse_direction, [&o](Vec3 v) { o.scene.camera.up = v; });
  add_number(app, "--fov", "vertical field of view in degrees; wider by default if a narrow picture needs it",
             1, 170, o.scene.camera.fov_degrees);
}

}  // namespace

bool RenderOptions::smooths() const { return smooth && scene.depth && can_smooth({format, dither}); }

bool RenderOptions::has_outlines() const { return smooths() || (ink && scene.depth); }

std::string RenderOptions::outline_text() const {
  if (!ink) return smooths() ? "smoothed" : "";
  return smooths() ? "inked and smoothed" : "inked";
}

bool has_segments(const std::string& shading) {
  return shading == "segment" || shading == "phong-segment" || shading.rfind(kDichotomy, 0) == 0;
}

bool RenderOptions::is_given(const std::string& option) const {
  return std::find(given.begin(), given.end(), option) != given.end();
}

void refuse_adaptive() {
  throw CLI::ValidationError("--shading",
                             "adaptive is now arc with a tolerance: --shading arc --tolerance 1");
}

void add_crease(CLI::App& app, std::optional<double>& degrees) {
  add_parsed<double>(
      app, "--crease", "DEGREES",
      "make normals anew; edges sharper than this (0...180) stay sharp (default: the model's normals; 40 "
      "where "
      "it has none)",
      "a number 0...180",
      [](const std::string& text) {
        const std::optional<double> v = parse_number(text);
        return v && *v >= 0 && *v <= 180 ? v : std::nullopt;
      },
      [&degrees](double v) { degrees = v; });
}

void note_settings(const CLI::App& app, RenderOptions& options) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() != 0) options.given.push_back(option->get_name());
  }
  options.scene.camera.fov_given = options.is_given("--fov");
  options.scene.chosen = {options.is_given("--colour"), options.is_given("--ambient"),
                          options.is_given("--diffuse"), options.is_given("--specular"),
                          options.is_given("--shininess")};
}

std::vector<std::string> dichotomies(const std::string& polynomial) {
  if (!polynomial.empty()) return {std::string(kDichotomy) + "-" + polynomial};
  std::vector<std::string> all;
  for (const char* each : kPolynomials) all.push_back(dichotomies(each).front());
  return all;
}

std::vector<std::string> shading_choices() {
  const std::vector<std::string> several = dichotomies("");
  std::vector<std::string> choices;
  for (const std::string& name : shading_names()) {
    if (std::find(several.begin(), several.end(), name) == several.end()) {
      choices.push_back(name);
    } else if (std::find(choices.begin(), choices.end(), kDichotomy) == choices.end()) {
      choices.push_back(kDichotomy);
    }
  }
  return choices;
}

void add_outline_options(CLI::App& app, RenderOptions& options) {
  app.add_flag("--smooth,!--no-smooth", options.smooth,
               "smooth outlines (default with a depth buffer and at least 4 bits per pixel)");
  add_parsed<OutlineInk>(app, "--ink", "R,G,B[:WIDTH]",
                         "ink outlines in a colour, each of R,G,B 0...1; WIDTH is 1...4 pixels (default 1)",
                         "R,G,B[:WIDTH] with each of R,G,B 0...1 and WIDTH 1...4", parse_ink,
                         [&options](const OutlineInk& ink) { options.ink = ink; });
  app.add_flag("--ink-creases,!--no-ink-creases", options.ink_creases, "ink creases, too (default)");
  app.add_flag("--curved-outlines", options.curved_outlines, "round the outlines of coarse smooth meshes");
  add_integer(app, "--toon", "STEPS", "light in 2...16 steps and hard highlights, by --shading arc", 2, 16,
              options.scene.toon_steps);
}

void add_render_options(CLI::App& app, RenderOptions& options) {
  app.add_option("MESH", options.mesh,
                 "an .obj, .gltf, .glb, .fbx, .dae, .3ds, .ply, .stl, .off or .bin (mesh binary) file, or "
                 "sphere:32x16, torus:48x24")
      ->required();
  add_pose(app, options.pose);
  add_picture_options(app, options);
  add_shading_options(app, options);
  add_camera_options(app, options);
}

}  // namespace arcspan::tools
