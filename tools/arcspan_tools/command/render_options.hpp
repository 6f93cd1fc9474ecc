// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <arcspan_tools/command/pose_options.hpp>
#include <arcspan_tools/render/scene.hpp>

#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Pixels of a picture's width or height: the pipeline's guard band.
inline constexpr std::int32_t kMostRenderedSide = 2 * kGuardBand;

/// The options that say what a picture shows and how; shared by the subcommands that render.
struct RenderOptions {
  std::string mesh;
  std::string format = "rgb565";
  bool dither = true;  ///< has no effect on formats of 8 bits per channel
  /// A renderer's name (shading_names()) once the arguments are parsed.
  std::string shading = "arc";
  /// The polynomial of `dichotomy`; empty if it was not given.
  std::string polynomial;
  std::optional<double> crease_degrees;  ///< make normals anew; the model's otherwise
  std::string texture;                   ///< a picture in place of the model's textures, or none
  std::string matcap;                    ///< a picture in place of light, or none
  std::optional<bool> vertex_colours;    ///< whether they are interpolated; by default as the shading wants
  bool smooth = true;                    ///< outlines, where depth and format allow it
  std::optional<OutlineInk> ink;         ///< of outlines
  bool ink_creases = true;
  bool curved_outlines = false;
  std::optional<PoseChoice> pose;  ///< of the model; the file's otherwise
  std::string clip;                ///< the clip that is played, of commands that play some, or none
  bool all_clips = false;          ///< all clips are played
  Scene scene;
  /// Those given; the scene's own stays if there are none.
  std::vector<SceneLight> lights;
  std::vector<std::string> given;  ///< names of the options that the command line has

  /// Whether clips are played, so that the model keeps its rig.
  [[nodiscard]] bool plays() const { return all_clips || !clip.empty(); }
  [[nodiscard]] bool is_given(const std::string& option) const;
  /// Whether outlines are smoothed.
  [[nodiscard]] bool smooths() const;
  /// Whether outlines are smoothed or inked.
  [[nodiscard]] bool has_outlines() const;
  /// How outlines are drawn: "inked and smoothed", "inked", "smoothed" or "".
  [[nodiscard]] std::string outline_text() const;
};

/// A colour of three channels, each 0...1.
[[nodiscard]] std::optional<Vec3> parse_colour(const std::string& text);

/// A former name of arc with a tolerance, which is refused with a message that says so.
inline constexpr const char* kAdaptive = "adaptive";
[[noreturn]] void refuse_adaptive();

/// The name under which the polynomials of dichotomy are offered.
inline constexpr const char* kDichotomy = "dichotomy";

/// Whether --segment has an effect on the shading or renderer of this name.
[[nodiscard]] bool has_segments(const std::string& shading);

/// The renderers of dichotomy: that of the polynomial which was asked for, or all.
[[nodiscard]] std::vector<std::string> dichotomies(const std::string& polynomial);

/// The choices of --shading: every method, with dichotomy once.
[[nodiscard]] std::vector<std::string> shading_choices();

/// Adds --crease.
void add_crease(CLI::App& app, std::optional<double>& degrees);

/// Notes which options were given: some are otherwise chosen, or belong to single methods.
void note_settings(const CLI::App& app, RenderOptions& options);

/// Adds --smooth and --no-smooth, --ink, --curved-outlines and --toon. Call it before add_render_options().
void add_outline_options(CLI::App& app, RenderOptions& options);

/// Adds MESH and the options to a subcommand. `options` must live as long as `app`.
void add_render_options(CLI::App& app, RenderOptions& options);

}  // namespace arcspan::tools
