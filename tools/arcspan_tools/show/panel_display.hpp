// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/show/display.hpp>
#include <arcspan_tools/show/panel_options.hpp>

#include <memory>
#include <string>

namespace arcspan::tools {

/// The panel `name`, one of module_names(), wired as `options` say, reset and switched on. At the end it is
/// dark and asleep, its backlight off. Throws Failure.
[[nodiscard]] std::unique_ptr<Display> open_panel_display(const std::string& name,
                                                          const PanelOptions& options);

}  // namespace arcspan::tools
