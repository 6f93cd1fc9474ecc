// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/ssd0323.hpp>
#include <arcspan/hal/panel/ssd1351.hpp>
#include <arcspan/hal/panel/st7789.hpp>

#include <arcspan_tools/command/glass_options.hpp>
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

using namespace hal;

constexpr const char* kSsd1306 = "ssd1306";

/// What a controller's memory allows.
struct KnownModule {
  const char* name;
  const char* controller;
  Glass glass;
  Size memory;          ///< of the controller
  Size step;            ///< a glass has a multiple of these
  std::int32_t least;   ///< rows of a glass
  bool row_offset;      ///< the glass may begin at another row than the first
  double most_spi_mhz;  ///< 1 / the least serial clock cycle for writing, of the data sheet
};

// Least clock cycles: ILI9341 V1.11, 19.3.4, 100 ns; ST7789V, 66 ns (an ST7789VW, 16 ns); SSD1351 rev 1.5,
// 220 ns (rev 1.3, 50 ns); SSD1306 rev 1.1, 100 ns. The SSD0323's datasheet was not available: not verified.
constexpr KnownModule kModules[] = {
    {"ili9341", "ili9341", kIli9341Module, {240, 320}, {1, 1}, 1, true, 10},
    {"st7789", "st7789", kSt7789Module, {240, 320}, {1, 1}, 1, true, 15},
    {"ssd1351", "ssd1351", kSsd1351Module, {128, 128}, {1, 1}, 16, false, 4.5},
    {kSsd1306, kSsd1306, kSsd1306Module, {128, 64}, {1, 8}, 16, true, 10},
    {"ssd1306-72x40", kSsd1306, kSsd1306Module72x40, {128, 64}, {1, 8}, 16, true, 10},
    {"ssd0323", "ssd0323", kSsd0323Module, {128, 80}, {2, 1}, 16, true, 4},
};

std::optional<std::array<int, 2>> parse_place(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return std::nullopt;
  const std::optional<std::int64_t> column = parse_integer(text.substr(0, comma));
  const std::optional<std::int64_t> row = parse_integer(text.substr(comma + 1));
  if (!column || !row || *column < 0 || *row < 0 || *column > 1000 || *row > 1000) return std::nullopt;
  return std::array<int, 2>{static_cast<int>(*column), static_cast<int>(*row)};
}

std::optional<int> parse_rotation(const std::string& text) {
  const std::optional<std::int64_t> degrees = parse_integer(text);
  if (!degrees || *degrees < 0 || *degrees > 270 || *degrees % 90 != 0) return std::nullopt;
  return static_cast<int>(*degrees);
}

/// Refuses a glass that the controller's memory does not hold.
void check_glass(const KnownModule& known, const Glass& glass) {
  const Size size{glass.width, glass.height};
  const std::string subject = glass.column_offset + glass.row_offset == 0 ? "--glass" : "--glass-at";
  const std::string what =
      formatted("%s at %d,%d", size_text(size).c_str(), glass.column_offset, glass.row_offset);
  if (size.width + glass.column_offset > known.memory.width ||
      size.height + glass.row_offset > known.memory.height) {
    throw Failure(subject,
                  what + " does not fit the " + size_text(known.memory) + " pixels of " + known.controller);
  }
  if (glass.row_offset != 0 && !known.row_offset)
    throw Failure(subject, std::string(known.controller) + " has its glass at row 0");
  if (size.height < known.least)
    throw Failure("--glass", formatted("%s has at least %d rows", known.controller, known.least));
  if (size.width % known.step.width != 0 || size.height % known.step.height != 0 ||
      glass.column_offset % known.step.width != 0) {
    throw Failure("--glass", what + formatted(" is not in steps of %dx%d, as %s needs", known.step.width,
                                              known.step.height, known.controller));
  }
}

}  // namespace

std::vector<std::string> module_names() {
  std::vector<std::string> names;
  for (const KnownModule& known : kModules) names.emplace_back(known.name);
  return names;
}

void add_glass_options(CLI::App& app, GlassOptions& options) {
  add_parsed<Size>(
      app, "--glass", "WxH", "size of the glass in pixels (default: the usual module's)",
      "WxH with each 1...320",
      [](const std::string& text) {
        const std::optional<Size> size = parse_size(text);
        return size && size->width <= 320 && size->height <= 320 ? size : std::nullopt;
      },
      [&options](const Size& size) { options.size = size; });
  add_parsed<std::array<int, 2>>(
      app, "--glass-at", "COLUMN,ROW",
      "where the glass begins in the controller's memory, as a stripe does (default: the usual module's)",
      "COLUMN,ROW with each 0...1000", parse_place,
      [&options](const std::array<int, 2>& first) { options.first = first; });
  add_parsed<int>(app, "--rotate,--rotation", "0|90|180|270", "degrees clockwise (default 0)",
                  "0, 90, 180 or 270", parse_rotation,
                  [&options](int degrees) { options.rotation = degrees; });
  app.add_flag("--inverted", options.inverted, "let the controller show complements");
  add_parsed<int>(
      app, "--spi-mode", "0|1|2|3",
      "clock polarity and phase of the SPI bus (default 0; some modules need 3)", "an integer 0...3",
      [](const std::string& text) -> std::optional<int> {
        const std::optional<std::int64_t> mode = parse_integer(text);
        return mode && *mode >= 0 && *mode <= 3 ? std::optional<int>(static_cast<int>(*mode)) : std::nullopt;
      },
      [&options](int mode) { options.spi_mode = mode; });
  app.add_flag_function(
      "--charge-pump,!--no-charge-pump", [&options](std::int64_t count) { options.charge_pump = count > 0; },
      "of an ssd1306: it makes VCC itself (8Dh, default), or the module does");
  app.add_flag_function(
      "--internal-reference,!--no-internal-reference",
      [&options](std::int64_t count) { options.internal_reference = count > 0; },
      "of an ssd1306: the segments' current has the controller's own reference (ADh; default for up to 72x40 "
      "pixels), or a resistor of the module");
  app.add_flag_function(
      "--alternating-coms,!--sequential-coms",
      [&options](std::int64_t count) { options.alternating_coms = count > 0; },
      "of an ssd1306: its rows are wired to alternating sides, or one after the other (DAh; default for up "
      "to 32 rows of 96 or more columns)");
}

PanelModule find_module(const std::string& option, const std::string& name, const GlassOptions& options) {
  for (const KnownModule& known : kModules) {
    if (name != known.name) continue;
    PanelModule module{known.controller, known.glass, {}, {}, known.most_spi_mhz};
    if (options.size) {
      module.glass.width = static_cast<std::uint16_t>(options.size->width);
      module.glass.height = static_cast<std::uint16_t>(options.size->height);
    }
    if (options.first) {
      module.glass.column_offset = static_cast<std::uint16_t>((*options.first)[0]);
      module.glass.row_offset = static_cast<std::uint16_t>((*options.first)[1]);
    }
    check_glass(known, module.glass);
    module.settings.orientation = static_cast<Orientation>(options.rotation / 90);
    module.settings.inverted = options.inverted;
    const bool is_ssd1306 = module.controller == kSsd1306;
    if (options.charge_pump && !is_ssd1306)
      throw Failure("--charge-pump", "only an ssd1306 has one, not " + name);
    if (options.internal_reference && !is_ssd1306)
      throw Failure("--internal-reference", "only an ssd1306 has one, not " + name);
    if (options.alternating_coms && !is_ssd1306)
      throw Failure("--alternating-coms", "only an ssd1306 has a choice, not " + name);
    module.wiring.charge_pump = options.charge_pump.value_or(true);
    const bool is_small = module.glass.width <= 72 && module.glass.height == 40;
    module.wiring.internal_reference = options.internal_reference.value_or(is_small);
    // Modules of 128x32 and 96x16 pixels; those of 64x32, 64x48 and 72x40 are wired as 128x64 is.
    const bool is_low = module.glass.width >= 96 && module.glass.height <= 32;
    module.wiring.alternating_coms = options.alternating_coms.value_or(!is_low);
    return module;
  }
  throw Failure(option, "expected " + joined(module_names(), ", ") + ", not '" + name + "'");
}

}  // namespace arcspan::tools
