// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <arcspan_tools/render/scene.hpp>

#include <string>
#include <vector>

namespace arcspan::tools {

/// The options that say what a picture shows and how; shared by the subcommands that render.
struct RenderOptions {
  std::string mesh;
  std::string format = "rgb565";
  bool dither = false;
  std::string shading = "arc";
  Scene scene;
  /// Those given; the scene's own stays if there are none.
  std::vector<SceneLight> lights;
};

/// Adds MESH and the options to a subcommand. `options` must live as long as `app`.
void add_render_options(CLI::App& app, RenderOptions& options);

}  // namespace arcspan::tools
