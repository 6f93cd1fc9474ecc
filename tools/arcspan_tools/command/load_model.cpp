// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/effect_options.hpp>
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/mesh/compile/neighbours.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/texture/plain/surface_texture.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

namespace arcspan::tools {

namespace {

/// Gives all parts with texture points this picture.
void put_texture(const std::string& picture, const std::string& name, Model& model) {
  const auto texture = std::make_shared<FileTexture>(
      FileTexture{std::filesystem::path(picture).filename().string(), read_rgba(picture)});
  bool is_used = false;
  for (ModelPart& part : model.parts) {
    if (part.mesh.texture_points.empty()) continue;
    is_used = true;
    part.look.material.texture = texture;
    part.look.material.alpha_mode = alpha_mode_of(texture->picture);
    part.look.material.alpha_cutoff = 0.5;
  }
  if (!is_used) throw Failure(name, "has no texture coordinates for --texture");
}

bool is_transparent(const ModelPart& part) {
  const FileMaterial& material = part.look.material;
  return material.opacity < 1 || (material.texture != nullptr && material.alpha_mode == AlphaMode::kBlend);
}

/// Names the options that have no effect on this model.
void warn_without_effect(const RenderOptions& options, const Model& model) {
  const auto all = [&model](const auto& is_so) {
    return std::all_of(model.parts.begin(), model.parts.end(), is_so);
  };
  const auto warn_of = [&options](const char* option, const std::string& why) {
    if (options.is_given(option)) warn(option, "has no effect: " + why);
  };
  const auto has_colours = [](const ModelPart& part) { return !part.mesh.colours.empty(); };
  if (options.vertex_colours == true && options.shading != "flat" && !all(has_colours)) {
    const bool none = std::none_of(model.parts.begin(), model.parts.end(), has_colours);
    if (none) warn_of("--vertex-colours", "no colours of the model differ within a triangle");
  }
  if (all(has_colours) && !options.scene.chosen.colour)
    warn_of("--tolerance", "the colours of the model's vertices are lit as by gouraud");
  if (!options.scene.alpha && std::none_of(model.parts.begin(), model.parts.end(), is_transparent))
    warn_of("--blend", "no surface is transparent (see --alpha)");
  if (all([](const ModelPart& part) { return part.look.material.unlit; })) {
    for (const char* option : kLightOptions) warn_of(option, "the model's materials are unlit");
  }
}

}  // namespace

Model load_model(const std::string& name, const std::optional<double>& crease_degrees,
                 const std::string& texture, VertexColours colours, const std::optional<PoseChoice>& pose,
                 const std::function<void(const Model&)>& check) {
  Model model =
      load_model_file(name, texture.empty() ? TexturePointsOf::kTexturedParts : TexturePointsOf::kAllParts,
                      colours, crease_degrees ? kSmoothEverything : kCreaseOfFiles);
  if (!texture.empty()) put_texture(texture, name, model);
  if (check) check(model);
  const bool has_motion = moves(model);
  const std::vector<std::string> warnings = model.warnings;
  if (pose) model = posed(model, *pose, name);
  // An error is the only line.
  for (const std::string& warning : warnings) warn(name, warning);
  if (pose && pose->clip.empty() && !has_motion) warn("--pose", "has no effect: nothing moves the model");
  if (!crease_degrees) return model;
  return with_crease(model.binary != nullptr ? posed(model, PoseChoice{}, name) : model, *crease_degrees,
                     name);
}

void warn_of_clips(const Model& model, const std::string& name) {
  if (clips_of(model).empty()) return;
  warn(name, "clips are not played, the model stands at rest: " + clip_list(model) + "; see --pose");
}

Model load_drawn_model(RenderOptions& options) {
  if (!options.matcap.empty()) {
    options.scene.matcap =
        surface_texture(read_rgba(options.matcap), 0, {TextureWrap::kClamp, TextureWrap::kClamp});
  }
  const bool kept =
      options.shading != "flat" &&
      options.vertex_colours.value_or(!options.is_given("--shading") || options.shading == "gouraud");
  // Vertices that move are posed by to_fixed(), as on a device. Here only the rest pose is set, and poses
  // whose normals are made anew.
  const auto anew =
      options.crease_degrees || (options.pose && options.pose->clip.empty()) ? options.pose : std::nullopt;
  Model model = load_model(options.mesh, options.plays() ? std::nullopt : options.crease_degrees,
                           options.texture, kept ? VertexColours::kKept : VertexColours::kMean, anew,
                           [&options, &anew](const Model& loaded) {
                             if (options.all_clips && clips_of(loaded).empty())
                               throw Failure(options.mesh, "has no clips for --clips");
                             if (options.pose && !anew) check_pose(loaded, *options.pose, options.mesh);
                           });
  const bool rests = !options.plays() && !options.pose;
  if (rests) warn_of_clips(model, options.mesh);
  if (rests && model.binary != nullptr) model = posed(model, PoseChoice{}, options.mesh);
  const bool keeps_positions = model.binary != nullptr;  // a binary that moves leaves curves no room
  model.has_curves = options.curved_outlines && !keeps_positions;
  warn_without_effect(options, model);
  if (shading_draws_effects(options.shading)) return model;
  const std::string by = " by --shading " + options.shading;
  if (remove_textures(model)) warn(options.mesh, "textures are not drawn" + by);
  if (make_opaque(model)) warn(options.mesh, "transparent materials are drawn opaque" + by);
  return model;
}

FixedModel with_outlines(FixedModel model, const RenderOptions& options) {
  return options.has_outlines() ? with_neighbours(std::move(model), options.mesh) : model;
}

FixedModel to_fixed(const Model& model, const RenderOptions& options) {
  if (!options.pose || !moves(model)) return with_outlines(to_fixed(model), options);
  const PoseChoice& pose = *options.pose;
  return with_outlines(RuntimeModel(model, options.mesh).posed(pose.clip, pose.seconds), options);
}

bool remove_textures(Model& model) {
  bool any = false;
  for (ModelPart& part : model.parts) {
    any = any || part.look.material.texture != nullptr;
    part.look.material.texture.reset();
    part.mesh.texture_points.clear();
  }
  return any;
}

bool make_opaque(Model& model) {
  bool any = false;
  for (ModelPart& part : model.parts) {
    FileMaterial& material = part.look.material;
    any = std::exchange(material.opacity, 1.0) < 1 || any;
    any = (std::exchange(material.alpha_mode, AlphaMode::kOpaque) != AlphaMode::kOpaque &&
           material.texture != nullptr) ||
          any;
  }
  return any;
}

void warn(const std::string& subject, const std::string& text) {
  print_message("warning: " + subject + ": " + text);
}

}  // namespace arcspan::tools
