// SPDX-License-Identifier: MIT
#include <arcspan/animate/joint_matrix.hpp>
#include <arcspan/animate/node_matrix.hpp>
#include <arcspan/draw/triangle_rows.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/textured.hpp>

#include <arcspan_tools/command/runtime_model.hpp>
#include <arcspan_tools/render/turntable.hpp>
#include <arcspan_tools/simulate/forecast.hpp>
#include <arcspan_tools/simulate/pose_cost.hpp>
#include <arcspan_tools/simulate/processor_cost.hpp>
#include <arcspan_tools/support/progress.hpp>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

namespace arcspan::tools {
namespace {

constexpr std::size_t kPictures = 8;

struct Row {
  const char* method;
  bool in_bands;
};
constexpr Row kForecastRows[] = {{"flat", false}, {"gouraud", false}, {"arc", false}, {"arc", true}};

bool has_textures(const FixedModel& model) {
  return std::any_of(model.looks.begin(), model.looks.end(),
                     [](const PartLook& look) { return look.material.texture != nullptr; });
}

bool has_borders(const FixedModel& model) {
  return std::any_of(model.looks.begin(), model.looks.end(), [](const PartLook& look) {
    return look.material.texture != nullptr && !look.material.sampler.repeats();
  });
}

std::string name_of(const Row& row, bool textured) {
  const std::string method(row.method);
  return (textured && method == "gouraud" ? "grey " : "") + method + (row.in_bands ? " in bands" : "");
}

void set_memory(const FixedModel& model, Forecast& made) {
  using Lit = Arc<Illumination<1, Highlight::kBlinn>>;
  using Mapped = Textured<Lit, Palette8Texels<OpaqueColour>>;
  const auto pixels = static_cast<std::size_t>(made.size.width) * static_cast<std::size_t>(made.size.height);
  constexpr std::size_t kBytesPerPixel = 4;
  made.frame_bytes = kBytesPerPixel * pixels;
  made.band_bytes = kBytesPerPixel * static_cast<std::size_t>(made.size.width) * Forecast::kBandRows;
  const std::size_t vertex = has_textures(model) ? sizeof(CachedVertex<Mapped>) : sizeof(CachedVertex<Lit>);
  for (const FixedMesh& mesh : model.meshes) {
    made.cache_bytes = std::max(made.cache_bytes, mesh.positions.size() * vertex);
    made.kept_bytes += mesh.positions.size() * vertex;
    made.row_bytes += TriangleRows::entries(mesh.indices.size() / 3) * sizeof(TriangleRows);
  }
  if (model.animation == nullptr) return;
  made.pose_bytes = model.animation->nodes.size() * sizeof(NodeMatrix);
  for (const FixedSkin& skin : model.animation->skins) made.pose_bytes += skin.size() * sizeof(JointMatrix);
  for (const FixedPartMotion& part : model.animation->parts) {
    if (part.morph) made.pose_bytes += part.morph->weights.size() * sizeof part.morph->weights[0];
  }
}

void add(CoreFigures& sum, std::size_t core, std::optional<double> some) {
  sum[core] = some && sum[core] ? std::optional(*sum[core] + *some / kPictures) : std::nullopt;
}

std::vector<ClipLength> clips_of(const FixedModel& model) {
  std::vector<ClipLength> clips;
  if (model.animation == nullptr) return clips;
  for (const FixedClip& clip : model.animation->clips) clips.push_back({clip.name, clip.duration / 1e6});
  return clips;
}

Poser poser_of(const FixedModel& model, const std::string& subject) {
  if (model.animation == nullptr) return [&model](const std::string&, double) { return model; };
  const auto runtime = std::make_shared<RuntimeModel>(model, subject);
  return [runtime](const std::string& clip, double seconds) { return runtime->posed(clip, seconds); };
}

/// The positions of all pictures, for a camera that sees them.
FixedMesh extent_of(const std::vector<ForecastPicture>& pictures) {
  FixedMesh all;
  for (const ForecastPicture& picture : pictures) {
    for (const FixedMesh& mesh : picture.pose.meshes)
      all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
  }
  all.unit = pictures[0].pose.meshes[0].unit;
  all.centre = pictures[0].pose.meshes[0].centre;
  return all;
}

/// How many normals are shaded, by flat shading those of faces.
double shaded_normals(const std::optional<std::vector<PartEvents>>& events, std::string_view shading) {
  const char* const name = shading == "flat" ? "face" : "shaded vertex";
  double normals = 0;
  for (const PartEvents& part : events.value_or(std::vector<PartEvents>())) {
    for (const CostTerm& term : part.terms) normals += term.name == name ? term.amount : 0;
  }
  return normals;
}

/// Adds the share of a picture to the figures of a method.
void add_picture(const char* method, const FixedModel& model, const ForecastPicture& picture,
                 const RenderJob& job, TexelLayout layout, Forecast::Method& row) {
  const auto events = picture_events(method, job, layout);
  const Size size = picture.scene.size;
  PoseAmounts amounts;
  if (model.animation != nullptr)
    amounts =
        pose_amounts(model, picture.pose, *picture.scene.camera.eye, method, shaded_normals(events, method));
  for (std::size_t i = 0; i < kForecastCores.size(); ++i) {
    const std::string_view core = kForecastCores[i].weights;
    const double posing = pose_instructions(core, amounts);
    std::optional<double> whole = events ? instructions_on(core, *events) : std::nullopt;
    if (whole) *whole += posing + pose_cost(core, "clear") * size.width * size.height;
    add(row.instructions, i, whole);
    add(row.posing, i, posing);
  }
}

}  // namespace

std::vector<ForecastPicture> forecast_pictures(const Poser& posed, const std::vector<ClipLength>& clips,
                                               Size size) {
  std::vector<ForecastPicture> pictures(kPictures);
  for (std::size_t i = 0; i < kPictures; ++i) {
    ForecastPicture& picture = pictures[i];
    if (!clips.empty()) {
      // Times and angles are in different order, so that no pose is always seen from one side.
      const ClipLength& clip = clips[i % clips.size()];
      picture.clip = clip.name;
      picture.seconds = clip.seconds * static_cast<double>(3 * i % kPictures) / kPictures;
    }
    picture.pose = posed(picture.clip, picture.seconds);
  }
  Scene scene;
  scene.size = size;
  const Turntable turntable(scene, extent_of(pictures), kPictures);
  for (std::size_t i = 0; i < kPictures; ++i) pictures[i].scene = turntable.scene(i);
  return pictures;
}

Forecast forecast(const FixedModel& model, std::size_t model_bytes, Size size, double mips,
                  const std::string& subject, TexelLayout layout) {
  Forecast made;
  made.size = size;
  made.mips = mips;
  made.pictures = kPictures;
  made.model_bytes = model_bytes;
  made.textured = has_textures(model);
  made.borders = has_borders(model);
  made.outlined = !model.meshes[0].neighbours.empty();
  set_memory(model, made);
  const std::vector<ForecastPicture> pictures =
      forecast_pictures(poser_of(model, subject), clips_of(model), size);
  Progress progress("forecasting", kPictures * std::size(kForecastRows));
  std::size_t done = 0;
  for (const Row& row : kForecastRows) {
    made.methods.push_back({name_of(row, made.textured), {}, {}});
    made.methods.back().instructions.fill(0);
    made.methods.back().posing.fill(0);
  }
  for (const ForecastPicture& picture : pictures) {
    RenderJob job = make_job(picture.scene, picture.pose, subject);
    for (std::size_t i = 0; i < std::size(kForecastRows); ++i) {
      job.band_rows = kForecastRows[i].in_bands ? Forecast::kBandRows : size.height;
      add_picture(kForecastRows[i].method, model, picture, job, layout, made.methods[i]);
      progress.show(++done);
    }
  }
  return made;
}

}  // namespace arcspan::tools
