// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <arcspan_tools/command/render_options.hpp>

namespace arcspan::tools {

/// The names of the options that add_effects() adds.
inline constexpr const char* kEffectOptions[] = {"--vertex-colours", "--alpha", "--blend", "--fog",
                                                 "--matcap"};

/// The options that say how surfaces are lit.
inline constexpr const char* kLightOptions[] = {"--tolerance", "--illumination", "--ambient",
                                                "--diffuse",   "--specular",     "--shininess",
                                                "--light",     "--attenuation",  "--highlight-fade"};

/// Adds --vertex-colours, --alpha, --blend, --fog and --matcap.
void add_effects(CLI::App& app, RenderOptions& options);

/// Refuses effects that the chosen shading or painter's order does not have. To be called when all options
/// are parsed.
void check_effects(const CLI::App& app, const RenderOptions& options);

}  // namespace arcspan::tools
