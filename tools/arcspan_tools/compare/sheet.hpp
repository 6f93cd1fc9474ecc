// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/compare/comparison.hpp>

namespace arcspan::tools {

/// The colour of an error in 8-bit steps: black up to half a step, then brighter with every doubling, white
/// from 128 on.
[[nodiscard]] Rgb8 error_colour(double steps);

/// A picture of the errors; what the reference does not cover is grey.
[[nodiscard]] Image error_picture(const Image& picture, const ReferencePicture& reference);

/// The contact sheet: the reference with the scale of colours, then every method's picture with its error map
/// under it. Throws Failure if it would be larger than a picture may be.
[[nodiscard]] Image contact_sheet(const Comparison& comparison, const ReferencePicture& reference);

}  // namespace arcspan::tools
