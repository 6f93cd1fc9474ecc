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

/// A method with weights.
struct CountedMethod {
  const char* weights;
  std::string_view shading;
  bool textured;
  std::optional<Highlight> highlight;  ///< of methods whose pixels depend on it
  void (*count)(const RenderPart&, const RenderJob&, EventPicture&, DrawEvents&);
};

constexpr std::array<CountedMethod, 9> kCountedMethods = {{
    {"flat", "flat", false, {}, count_part<Flat<Blinn>, Blinn>},
    {"gouraud", "gouraud", false, {}, count_part<Gouraud<Blinn>, Blinn>},
    {"segment phong", "segment", false, Highlight::kPhong, count_part<Segment<Phong>, Phong>},
    {"segment blinn", "segment", false, Highlight::kBlinn, count_part<Segment<Blinn>, Blinn>},
    {"arc phong", "arc", false, Highlight::kPhong, count_part<Arc<Phong>, Phong>},
    {"arc blinn", "arc", false, Highlight::kBlinn, count_part<Arc<Blinn>, Blinn>},
    {"textured flat", "flat", true, {}, count_part<WithTexels<Flat<Blinn>>, Blinn>},
    {"textured gouraud", "gouraud", true, {}, count_part<WithTexels<GreyGouraud<Blinn>>, Blinn>},
    {"textured arc", "arc", true, Highlight::kBlinn, count_part<WithTexels<Arc<Blinn>>, Blinn>},
}};

const CountedMethod* find_method(std::string_view shading, const RenderPart& part, Highlight highlight) {
  if (part.vertex_colours || part.transparency != Transparency::kNone) return nullptr;
  for (const CountedMethod& method : kCountedMethods) {
    if (method.shading == shading && method.textured == (part.texture != nullptr) &&
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

/// Events are counted with the nearest texel: a bilinear filter draws the same pixels.
void count_bilinear(const RenderPart& part, DrawEvents& events) {
  if (part.texture == nullptr || part.texture->view.sampler().filter != TextureFilter::kBilinear) return;
  for (const auto* paths : {&events.small, &events.large, &events.perspective}) {
    for (const DrawEvents::Path& path : *paths) events.bilinear += path.written;
  }
}

}  // namespace

std::optional<std::vector<PartEvents>> picture_events(std::string_view shading, const RenderJob& job) {
  if (job.lights.size() != 1 || job.fog != nullptr || job.matcap != nullptr) return std::nullopt;
  // The weights of arc are those of gradual highlights; the others draw no toon highlights.
  if (job.toon_steps != 0 && shading == "arc") return std::nullopt;
  JobOutlines outlines(job);
  EventPicture picture(job.transform.viewport(), job.band_rows, outlines.margin());
  std::vector<PartEvents> found;
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    RenderPart part = job.parts[i];
    const CountedMethod* const method = find_method(shading, part, job.highlight);
    if (method == nullptr) return std::nullopt;
    for (const MeshView& mesh : {part.mesh, outlines.curves(i)}) {
      if (mesh.triangle_count() == 0) continue;
      part.mesh = mesh;
      DrawEvents events;
      method->count(part, job, picture, events);
      if (!job.depth) draw_hidden(events);
      count_bilinear(part, events);
      found.push_back({method->weights, events.terms()});
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
