// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/pose_options.hpp>
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/mesh/plain/rig_pose.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/parse.hpp>
#include <arcspan_tools/support/text.hpp>

namespace arcspan::tools {
namespace {

constexpr const char* kRest = "rest";

std::optional<PoseChoice> parse_pose(const std::string& text) {
  if (text == kRest) return PoseChoice{};
  const std::size_t at = text.rfind('@');  // names may have one too
  if (at == std::string::npos || at == 0) return std::nullopt;
  const std::optional<double> seconds = parse_number(text.substr(at + 1));
  if (!seconds || !(*seconds >= 0)) return std::nullopt;
  return PoseChoice{text.substr(0, at), *seconds};
}

}  // namespace

void add_pose(CLI::App& app, std::optional<PoseChoice>& pose) {
  add_parsed<PoseChoice>(
      app, "--pose", "CLIP@T",
      "the model as it is at T seconds of a clip of its file (.gltf, .glb, .fbx, .dae, .3ds, .bin); rest is "
      "without a clip, as it is by default",
      "CLIP@SECONDS or rest", parse_pose, [&pose](const PoseChoice& choice) { pose = choice; });
}

void add_clip(CLI::App& app, std::string& clip) {
  app.add_option(
         "--clip", clip,
         "play this clip of the file (.gltf, .glb, .fbx, .dae, .3ds, .bin), a whole number of times a turn")
      ->type_name("NAME");
}

void check_clip(const CLI::App& app) {
  if (app.count("--clip") != 0 && app.count("--pose") != 0)
    throw CLI::ValidationError("--clip", "excludes --pose");
}

std::string clip_list(const Model& model) {
  constexpr std::size_t kMostListed = 20;
  std::vector<std::string> names;
  for (const ClipLength& clip : clips_of(model)) {
    if (names.size() == kMostListed) {
      names.emplace_back("...");
      break;
    }
    names.push_back(clip.name + formatted(" (%g s)", clip.seconds));
  }
  return joined(names, ", ");
}

ClipLength find_clip(const Model& model, const std::string& name, const std::string& subject,
                     const char* option) {
  const std::vector<ClipLength> clips = clips_of(model);
  if (clips.empty()) throw Failure(subject, std::string("has no clips for ") + option);
  for (const ClipLength& clip : clips) {
    if (clip.name == name) return clip;
  }
  throw Failure(subject, "no clip '" + name + "' (there are: " + clip_list(model) + ")");
}

void check_pose(const Model& model, const PoseChoice& pose, const std::string& subject) {
  if (pose.clip.empty()) return;
  const ClipLength clip = find_clip(model, pose.clip, subject, "--pose");
  const std::string asked = formatted("%g", pose.seconds);
  const std::string end = formatted("%g", clip.seconds);
  // Lists print the end rounded, perhaps up.
  if (pose.seconds > clip.seconds && asked != end)
    throw Failure("--pose", asked + " is after the end of the clip '" + clip.name + "' at " + end + " s");
}

Model posed(const Model& model, const PoseChoice& pose, const std::string& subject) {
  check_pose(model, pose, subject);
  if (model.binary != nullptr)
    return posed_like(model, RuntimeModel(model, subject).posed(pose.clip, pose.seconds));
  if (model.rig == nullptr) return model;
  if (pose.clip.empty()) return posed(model, rest_pose(*model.rig), subject);
  for (const RigClip& clip : model.rig->clips) {
    if (clip.name == pose.clip) return posed(model, pose_at(*model.rig, clip, pose.seconds), subject);
  }
  return model;
}

}  // namespace arcspan::tools
