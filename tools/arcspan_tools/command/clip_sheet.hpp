// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/command/render_options.hpp>
#include <arcspan_tools/image/image.hpp>

namespace arcspan::tools {

/// A sheet of all clips of a model: a row for each, with eight pictures at even steps of its time, from where
/// the model is in view all the time. The model has clips. Throws a Failure if the sheet would be larger than
/// a picture may be.
[[nodiscard]] Image clip_sheet(const RenderOptions& options, const Model& model);

}  // namespace arcspan::tools
