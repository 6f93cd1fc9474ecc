// SPDX-License-Identifier: MIT
#include <arcspan/literature/segment.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/textured.hpp>

#include <arcspan_tools/simulate/count_events.hpp>
#include <arcspan_tools/simulate/estimates_json.hpp>
#include <arcspan_tools/simulate/outline_events.hpp>
#include <arcspan_tools/simulate/processor_cost.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>

namespace arcspan::tools {
namespace {

const nlohmann::json& estimates() {
  static const nlohmann::json kEstimates = nlohmann::json::parse(kEstimatesJson);
  return kEstimates;
}

/// The lightings of methods are too large for the stack.
template <class Method, class Light>
std::unique_ptr<typename Method::Lighting> make_lighting(const RenderPart& part, const RenderJob& job) {
  Material material = part.material;
  material.highlight_fade = {};
  Light light;
  if (!ok(Light::make(material, {job.lights[0]}, job.to_eye, light)))
    throw Failure("simulate", "the material cannot be lit");
  auto lighting = std::make_unique<typename Method::Lighting>(light);
  Status status = Status::kOk;
  if constexpr (requires { lighting->set_segment_bits(1); }) {
    if (job.segment_bits < 0) status = lighting->set_adaptive_segments(material.shininess);
    if (job.segment_bits > 0) status = lighting->set_segment_bits(job.segment_bits);
  }
  if constexpr (requires { lighting->set_tolerance(1); }) status = lighting->set_tolerance(job.tolerance);
  if (!ok(status)) throw Failure("simulate", "the method rejects its settings");
  return lighting;
}

/// True if highlights are not white.
bool has_tint(const Material& material, const DirectionalLight& light) {
  const auto product = [](Coefficient a, Coefficient b) { return std::int64_t{a.raw()} * b.raw(); };
  const std::int64_t red = product(material.specular.r, light.colour.r);
  return red == 0 || red != product(material.specular.g, light.colour.g) ||
         red != product(material.specular.b, light.colour.b);
}

template <class Method, class Light>
void count_part(const RenderPart& part, const RenderJob& job, EventPicture& picture, DrawEvents& events) {
  const auto lighting = make_lighting<Method, Light>(part, job);
  if constexpr (requires { lighting->texture; })
    lighting->texture = part.texture->view.with(TextureSampler{});  // estimated as one that repeats
  count_events<Method>(part, job.transform, *lighting, has_tint(part.material, job.lights[0]), picture,
                       events);
}

using Blinn = Illumination<1, Highlight::kBlinn>;
using Phong = Illumination<1, Highlight::kPhong>;
template <class Method>
using WithTexels = Textured<Method, SurfaceTexels>;

/// The texels that a method draws. All textures of a model have the same: with a bit of alpha (kMasked) if
/// any texel is transparent.
enum class Texels { kNone, kOpaque, kMasked };

/// A method with weights.
struct CountedMethod {
  const char* weights;
  std::string_view shading;
  Texels texels;
  std::optional<Highlight> highlight;  ///< of methods whose pixels depend on it
  void (*count)(const RenderPart&, const RenderJob&, EventPicture&, DrawEvents&);
};

constexpr std::array<CountedMethod, 12> kCountedMethods = {{
    {"flat", "flat", Texels::kNone, {}, count_part<Flat<Blinn>, Blinn>},
    {"gouraud", "gouraud", Texels::kNone, {}, count_part<Gouraud<Blinn>, Blinn>},
    {"segment phong", "segment", Texels::kNone, Highlight::kPhong, count_part<Segment<Phong>, Phong>},
    {"segment blinn", "segment", Texels::kNone, Highlight::kBlinn, count_part<Segment<Blinn>, Blinn>},
    {"arc phong", "arc", Texels::kNone, Highlight::kPhong, count_part<Arc<Phong>, Phong>},
    {"arc blinn", "arc", Texels::kNone, Highlight::kBlinn, count_part<Arc<Blinn>, Blinn>},
    {"textured flat", "flat", Texels::kOpaque, {}, count_part<WithTexels<Flat<Blinn>>, Blinn>},
    {"textured gouraud", "gouraud", Texels::kOpaque, {}, count_part<WithTexels<GreyGouraud<Blinn>>, Blinn>},
    {"textured arc", "arc", Texels::kOpaque, Highlight::kBlinn, count_part<WithTexels<Arc<Blinn>>, Blinn>},
    {"masked flat", "flat", Texels::kMasked, {}, count_part<WithTexels<Flat<Blinn>>, Blinn>},
    {"masked gouraud", "gouraud", Texels::kMasked, {}, count_part<WithTexels<GreyGouraud<Blinn>>, Blinn>},
    {"masked arc", "arc", Texels::kMasked, Highlight::kBlinn, count_part<WithTexels<Arc<Blinn>>, Blinn>},
}};

/// True if any texel is transparent.
bool has_masks(const RenderJob& job) {
  const auto is_transparent = [](std::uint32_t texel) {
    return SurfaceTexels::ColourFormat::alpha(texel) == 0;
  };
  return std::any_of(job.parts.begin(), job.parts.end(), [&](const RenderPart& part) {
    if (part.texture == nullptr) return false;
    const std::vector<std::uint32_t>& texels = part.texture->texels;
    return std::any_of(texels.begin(), texels.end(), is_transparent);
  });
}

const CountedMethod* find_method(std::string_view shading, const RenderPart& part, bool masks,
                                 Highlight highlight) {
  if (part.vertex_colours || part.transparency != Transparency::kNone) return nullptr;
  const Texels texels = part.texture == nullptr ? Texels::kNone : masks ? Texels::kMasked : Texels::kOpaque;
  for (const CountedMethod& method : kCountedMethods) {
    if (method.shading == shading && method.texels == texels &&
        method.highlight.value_or(highlight) == highlight)
      return &method;
  }
  return nullptr;
}

/// All pixels are drawn where depth is not tested.
void draw_hidden(DrawEvents& events) {
  for (auto* paths : {&events.small, &events.large, &events.perspective}) {
    for (DrawEvents::Path& path : *paths) path.written = path.pixels;
  }
}

/// Events are counted with the nearest texel of 8 bits: others are drawn in the same pixels. Adds what these
/// take more or less, for each pixel whose texel is looked up.
void add_texels(const RenderPart& part, TexelLayout layout, const DrawEvents& events,
                std::vector<CostTerm>& terms) {
  if (part.texture == nullptr) return;
  double texels = events.masked;
  for (const auto* paths : {&events.small, &events.large, &events.perspective}) {
    for (const DrawEvents::Path& path : *paths) texels += path.written;
  }
  if (part.texture->view.sampler().filter == TextureFilter::kBilinear)
    terms.push_back({"bilinear texel", texels});
  if (layout == TexelLayout::kDirect) terms.push_back({"direct texel", texels});
  if (layout == TexelLayout::kPalette4) terms.push_back({"pal4 texel", texels});
  if (layout == TexelLayout::kGray) terms.push_back({"gray texel", texels});
}

}  // namespace

std::optional<std::vector<PartEvents>> picture_events(std::string_view shading, const RenderJob& job,
                                                      TexelLayout layout) {
  if (job.lights.size() != 1 || job.fog != nullptr || job.matcap != nullptr) return std::nullopt;
  // The weights of arc are those of gradual highlights; the others draw no toon highlights.
  if (job.toon_steps != 0 && shading == "arc") return std::nullopt;
  JobOutlines outlines(job);
  const bool masks = has_masks(job);
  EventPicture picture(job.transform.viewport(), job.band_rows, outlines.margin());
  std::vector<PartEvents> found;
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    RenderPart part = job.parts[i];
    const CountedMethod* const method = find_method(shading, part, masks, job.highlight);
    if (method == nullptr) return std::nullopt;
    for (const MeshView& mesh : {part.mesh, outlines.curves(i)}) {
      if (mesh.triangle_count() == 0) continue;
      part.mesh = mesh;
      DrawEvents events;
      method->count(part, job, picture, events);
      if (!job.depth) draw_hidden(events);
      found.push_back({method->weights, events.terms()});
      add_texels(part, layout, events, found.back().terms);
    }
  }
  if (!outlines.empty()) found.push_back({kOutlineWeights, count_outlines(job, outlines, picture).terms()});
  return found;
}

std::optional<double> instructions_on(std::string_view core, const std::vector<PartEvents>& picture) {
  const auto of_core = estimates().find(std::string(core));
  if (of_core == estimates().end()) return std::nullopt;
  double instructions = 0;
  for (const PartEvents& part : picture) {
    const auto weights = of_core->find(part.weights);
    if (weights == of_core->end()) return std::nullopt;
    for (const CostTerm& term : part.terms) instructions += weights->value(term.name, 0.0) * term.amount;
  }
  return instructions;
}

std::optional<double> draw_instructions(std::string_view core, std::string_view shading,
                                        const RenderJob& job) {
  const auto picture = picture_events(shading, job);
  return picture ? instructions_on(core, *picture) : std::nullopt;
}

double pose_cost(std::string_view core, const std::string& name) {
  return estimates().at(std::string(core)).at("pose").at(name).get<double>();
}

}  // namespace arcspan::tools
