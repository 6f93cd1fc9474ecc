// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/command/pose_options.hpp>
#include <arcspan_tools/command/render_options.hpp>
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <functional>
#include <optional>
#include <string>

namespace arcspan::tools {

/// load_model_file(), and its warnings on standard error. With `crease_degrees` the normals are made anew:
/// see with_crease(). `texture`, unless it is empty, is a picture file that replaces the textures of all
/// parts that have texture points. Without a `pose` a model keeps what moves it; it loses it by one, and by
/// `crease_degrees`. `check`, unless it is empty, gets the model before the warnings, so that what it throws
/// is the only line.
[[nodiscard]] Model load_model(const std::string& name, const std::optional<double>& crease_degrees = {},
                               const std::string& texture = {}, VertexColours colours = VertexColours::kMean,
                               const std::optional<PoseChoice>& pose = {},
                               const std::function<void(const Model&)>& check = {});

/// Says which clips of a model are not played, if it has some.
void warn_of_clips(const Model& model, const std::string& name);

/// The model that options ask for, which keeps what moves it unless normals are made anew, and that is not
/// done if a clip is to be played; reads the picture of --matcap into their scene. What the shading does not
/// draw is removed, with a warning.
[[nodiscard]] Model load_drawn_model(RenderOptions& options);

/// The model with the neighbours of its triangles, if outlines are smoothed or inked.
[[nodiscard]] FixedModel with_outlines(FixedModel model, const RenderOptions& options);

/// That model in fixed point and in the pose of the options, with_outlines().
[[nodiscard]] FixedModel to_fixed(const Model& model, const RenderOptions& options);

/// Removes the textures and the texture points of all parts. Returns whether there were any.
bool remove_textures(Model& model);

/// Makes the materials and the textures of all parts opaque. Returns whether there were others.
bool make_opaque(Model& model);

/// Prints the line `arcspan: warning: SUBJECT: TEXT` on standard error.
void warn(const std::string& subject, const std::string& text);

}  // namespace arcspan::tools
