// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/show/display.hpp>

#include <memory>
#include <string>

namespace arcspan::tools {

/// The framebuffer of the kernel at `path`, e.g. /dev/fb0. Throws Failure.
[[nodiscard]] std::unique_ptr<Display> open_framebuffer_display(const std::string& path);

}  // namespace arcspan::tools
