// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/glass_options.hpp>
#include <catch2/catch.hpp>

using namespace arcspan::tools;

namespace {

bool has_alternating_coms(const char* name, const GlassOptions& options) {
  return find_module("--panel", name, options).wiring.alternating_coms;
}

}  // namespace

// As U8g2 and Adafruit's driver set up these modules.
TEST_CASE("rows of an SSD1306 are wired as modules of that size are, unless an option says otherwise") {
  CHECK(has_alternating_coms("ssd1306", {}));
  CHECK(has_alternating_coms("ssd1306-72x40", {}));
  GlassOptions options;
  const struct {
    Size size;
    bool alternating;
  } modules[] = {{{128, 64}, true}, {{128, 32}, false}, {{96, 16}, false},
                 {{64, 32}, true},  {{64, 48}, true},   {{70, 40}, true}};
  for (const auto& module : modules) {
    CAPTURE(module.size.width, module.size.height);
    options.size = module.size;
    CHECK(has_alternating_coms("ssd1306", options) == module.alternating);
  }
  for (const bool alternating : {false, true}) {
    options.alternating_coms = alternating;
    options.size = Size{128, 32};
    CHECK(has_alternating_coms("ssd1306", options) == alternating);
  }
}
