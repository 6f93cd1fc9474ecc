// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/show/display.hpp>

#include <memory>
#include <string>

namespace arcspan::tools {

/// The first connected display of the graphics card at `path`, e.g. /dev/dri/card0. Throws Failure.
[[nodiscard]] std::unique_ptr<Display> open_drm_display(const std::string& path);

}  // namespace arcspan::tools
