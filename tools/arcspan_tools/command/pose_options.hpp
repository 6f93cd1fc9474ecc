// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <arcspan_tools/command/runtime_model.hpp>

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

/// The clip of a model that has this name. Throws a Failure about `subject` that lists the clips if there is
/// none, or names the `option` if there are no clips at all.
[[nodiscard]] ClipLength find_clip(const Model& model, const std::string& name, const std::string& subject,
                                   const char* option);

/// Throws a Failure about `subject` if a model has no such clip or it is shorter.
void check_pose(const Model& model, const PoseChoice& pose, const std::string& subject);

/// The model in this pose, without what moves it: of a rig in doubles, of a binary as a device poses it.
/// Throws as check_pose() does.
[[nodiscard]] Model posed(const Model& model, const PoseChoice& pose, const std::string& subject);

/// The names of all clips and their durations: "walk (2 s), wave (0.5 s)".
[[nodiscard]] std::string clip_list(const Model& model);

}  // namespace arcspan::tools
