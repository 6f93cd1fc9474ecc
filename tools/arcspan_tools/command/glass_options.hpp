// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/glass.hpp>
#include <arcspan/hal/panel/panel.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>

#include <CLI/CLI.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// What is told of a panel's glass, in the same words to `show` and to `simulate`.
struct GlassOptions {
  std::optional<Size> size;                 ///< that of the usual module if unset
  std::optional<std::array<int, 2>> first;  ///< column and row of the controller where the glass begins
  int rotation = 0;                         ///< degrees clockwise: 0, 90, 180, 270
  bool inverted = false;
  int spi_mode = 0;  ///< 0...3
  std::optional<bool> charge_pump;
  std::optional<bool> internal_reference;
  std::optional<bool> alternating_coms;
};

/// A controller with a glass. The names of both commands.
struct PanelModule {
  std::string controller;
  hal::Glass glass;
  hal::PanelSettings settings;
  hal::Ssd1306Wiring wiring;  ///< of an ssd1306
  double most_spi_mhz = 0;    ///< for writing, by the data sheet
};

/// The names of all modules: controllers, which stand for the usual modules, and others.
[[nodiscard]] std::vector<std::string> module_names();

/// Adds the options. `options` must live as long as `app`.
void add_glass_options(CLI::App& app, GlassOptions& options);

/// The module `name` with the glass that the options describe. Throws Failure about `option` if there is no
/// such module, and about another option if the controller cannot have such a glass.
[[nodiscard]] PanelModule find_module(const std::string& option, const std::string& name,
                                      const GlassOptions& options);

}  // namespace arcspan::tools
