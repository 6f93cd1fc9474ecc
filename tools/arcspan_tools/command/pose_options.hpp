// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <optional>
#include <string>

namespace arcspan::tools {

/// A moment of a clip of a model.
struct PoseChoice {
  std::string clip{};  ///< empty for the pose of the file's nodes
  double seconds = 0;
};

/// Adds --pose CLIP@T.
void add_pose(CLI::App& app, std::optional<PoseChoice>& pose);

/// Adds --clip NAME.
void add_clip(CLI::App& app, std::string& clip);

/// Refuses --clip with --pose.
void check_clip(const CLI::App& app);

/// The clip of a model's rig that has this name. Throws a Failure about `subject` that lists the clips if
/// there is none, or names the `option` if there are no clips at all.
[[nodiscard]] const RigClip& find_clip(const Model& model, const std::string& name,
                                       const std::string& subject, const char* option);

/// The model in this pose, without a rig. Throws a Failure about `subject` if there is no such clip or it is
/// shorter.
[[nodiscard]] Model posed(const Model& model, const PoseChoice& pose, const std::string& subject);

/// The names of all clips and their durations: "walk (2 s), wave (0.5 s)".
[[nodiscard]] std::string clip_list(const Rig& rig);

}  // namespace arcspan::tools
