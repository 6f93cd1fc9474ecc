// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/font/make_font.hpp>
#include <arcspan_tools/image/image.hpp>

namespace arcspan::tools {

/// All characters of a font on a sheet, as the library draws them; the placeholder comes last. Throws Failure
/// if the sheet has more than 32,767 columns or rows.
[[nodiscard]] Image font_picture(const MadeFont& font);

}  // namespace arcspan::tools
