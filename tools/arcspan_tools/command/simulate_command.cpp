// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/command/method_advice.hpp>
#include <arcspan_tools/command/played_model.hpp>
#include <arcspan_tools/command/render_options.hpp>
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/output/frame_output.hpp>
#include <arcspan_tools/render/surface_drawer.hpp>
#include <arcspan_tools/render/turntable.hpp>
#include <arcspan_tools/simulate/processor_cost.hpp>
#include <arcspan_tools/simulate/simulated_display.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/parse.hpp>
#include <arcspan_tools/support/result_files.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace arcspan::tools {
namespace {

struct SimulateArguments {
  RenderOptions options;
  std::string output;
  DisplayOptions display;
  std::string panel = "ili9341";
  GlassOptions glass;
  std::string bus = "spi";
  double spi_mhz = 0;  ///< 0: the most that the controller takes
  double i2c_khz = 400;
  double cpu_mhz = 50;
  std::int32_t frames = 1;
  bool planes = false;
};

/// Sums over all frames.
struct Totals {
  double instructions = 0;
  double outline_instructions = 0;  ///< of these
  double other_instructions = 0;    ///< for clearing, and for packing what is sent
  std::uint64_t draw_ns = 0;
  std::uint64_t frame_ns = 0;
  hal::sim::BusCount bus;
  std::string without_figures;    ///< empty: all was estimated
  std::string other_methods;      ///< by_other_methods() of the first frame
  bool other_pixels = false;      ///< shown in another format than rgb565, or with dither
  bool grey = false;              ///< textures are estimated as drawn by GreyGouraud
  bool borders = false;           ///< a texture does not repeat
  std::string outlines;           ///< RenderOptions::outline_text()
  std::size_t outline_bytes = 0;  ///< the most of a frame; 0 without smoothing and ink
};

constexpr std::int32_t kTurnMilliseconds = 2000;

DisplayOptions options_of(const SimulateArguments& arguments) {
  DisplayOptions options = arguments.display;
  options.i2c = arguments.bus == "i2c";
  options.hertz = static_cast<std::uint64_t>(
      std::llround(options.i2c ? arguments.i2c_khz * 1e3 : arguments.spi_mhz * 1e6));
  options.module = find_module("--panel", arguments.panel, arguments.glass);
  if (arguments.options.scene.band_rows > 0) options.band_rows = arguments.options.scene.band_rows;
  return options;
}

/// Where the glass is shown after each frame: one picture, or a moving one.
class GlassOutput {
 public:
  GlassOutput(const std::string& path, std::int32_t frames, const Image& like) : path_(path) {
    if (frames == 1) {
      (void)image_format(path);
      return;
    }
    FrameFormat format;
    format.frames = static_cast<std::size_t>(frames);
    format.size = {like.width, like.height};
    format.milliseconds = std::max(20, kTurnMilliseconds / frames);
    moving_ = make_frame_output(path, format);
  }
  void add(Image glass) {
    if (moving_) {
      moving_->add(std::move(glass));
    } else {
      still_ = std::move(glass);
    }
  }
  void finish(const std::string& summary) {
    if (moving_) {
      moving_->finish(summary);
    } else {
      write_image(still_, path_, summary);
    }
  }

 private:
  std::string path_;
  Image still_;
  std::unique_ptr<FrameOutput> moving_;
};

// The part of the job for which draw_instructions() has no estimate.
std::string without_figures(const std::string& shading, const RenderJob& job) {
  if (has_surfaces(job)) return "textures and effects";
  if (job.lights.size() != 1) return "several lights";
  return job.toon_steps != 0 && shading == "arc" ? "toon light" : shading + " shading";
}

bool has_textures(const RenderJob& job) {
  return std::any_of(job.parts.begin(), job.parts.end(),
                     [](const RenderPart& part) { return part.texture != nullptr; });
}

bool has_borders(const RenderJob& job) {
  return std::any_of(job.parts.begin(), job.parts.end(), [](const RenderPart& part) {
    return part.texture != nullptr && !part.texture->view.sampler().repeats();
  });
}

/// Estimates for the other main methods: "flat 569880 (-42 %), ...", compared with the frame's own method,
/// which takes `own` instructions; and in a second line which one to take.
std::string by_other_methods(double own, const std::string& shading, const RenderJob& job) {
  std::string text;
  MethodCosts costs;
  costs.textured = has_textures(job);
  bool complete = true;
  for (const auto& [other, cost] :
       {std::pair("flat", &costs.flat), std::pair("gouraud", &costs.gouraud), std::pair("arc", &costs.arc)}) {
    const std::optional<double> instructions = draw_instructions(kSimulatedCore, other, job);
    complete = complete && instructions;
    if (!instructions) continue;
    *cost = *instructions;
    if (shading == other) continue;
    const bool grey = costs.textured && cost == &costs.gouraud;
    text += formatted("%s%s%s %.0f (%+.0f %%)", text.empty() ? "" : ", ", grey ? "grey " : "", other,
                      *instructions, 100 * (*instructions / own - 1));
  }
  return complete ? text + "\nadvice: " + method_advice(costs) : text;
}

Totals show_all(const SimulateArguments& arguments, SimulatedDisplay& display, GlassOutput& output) {
  RenderOptions options = arguments.options;
  options.scene.size = display.size();
  options.scene.band_rows = options_of(arguments).band_rows;
  options.format = display.format();
  if (options.is_given("--smooth") && options.smooth && !options.smooths())
    warn("--smooth", "has no effect: the panel has fewer than 4 bits per pixel");
  if (options.curved_outlines && !options.has_outlines())
    warn("--curved-outlines", "has no effect: outlines are neither smoothed nor inked");
  options.scene.outlines.smooth = options.smooths();
  PlayedModel played(options, static_cast<std::size_t>(arguments.frames),
                     arguments.frames * 1000.0 / kTurnMilliseconds);
  FixedModel planed = played.frame(0);
  for (FixedMesh& mesh : planed.meshes) {
    if (arguments.planes) mesh = with_planes(std::move(mesh), options.mesh);
  }
  const Renderer& renderer = find_renderer(options.shading, display.format(), options.dither);
  const auto frames = static_cast<std::size_t>(arguments.frames);
  const Turntable turntable(options.scene, played.extent(), frames);
  display.start();
  const hal::sim::BusCount start = display.count();
  const double all_pixels = double(display.size().width) * display.size().height;
  const double pixel_cost =
      pose_cost(kSimulatedCore, "clear") + pose_cost(kSimulatedCore, "pack " + display.format());
  Totals totals;
  totals.outlines = options.outline_text();
  for (std::size_t i = 0; i < frames; ++i) {
    const Scene scene = frames == 1 ? options.scene : turntable.scene(i);
    const FixedModel& model = arguments.planes ? planed : played.frame(i);
    const RenderJob job = make_job(scene, model, options.mesh);
    const RenderResult drawn = renderer.render(job, [](std::size_t) {});
    const auto events = picture_events(options.shading, job);
    const std::optional<double> instructions =
        events ? instructions_on(kSimulatedCore, *events) : std::nullopt;
    if (instructions && events->back().weights == kOutlineWeights)
      totals.outline_instructions += instructions_on(kSimulatedCore, {events->back()}).value();
    if (instructions && i == 0) totals.other_methods = by_other_methods(*instructions, options.shading, job);
    totals.other_pixels = display.format() != "rgb565" || options.dither;
    totals.grey = options.shading == "gouraud" && has_textures(job);
    totals.borders = has_borders(job);
    if (!instructions) totals.without_figures = without_figures(options.shading, job);
    const double others = instructions ? all_pixels * pixel_cost : 0;
    const auto draw_ns =
        static_cast<std::uint64_t>((instructions.value_or(0) + others) * 1000 / arguments.cpu_mhz);
    const std::uint64_t before = display.now_ns();
    display.show(drawn.image, job.background, draw_ns);
    totals.outline_bytes = std::max(totals.outline_bytes, drawn.stats.outline_bytes);
    totals.instructions += instructions.value_or(0);
    totals.other_instructions += others;
    totals.draw_ns += draw_ns;
    totals.frame_ns += display.now_ns() - before;
    output.add(display.picture());
  }
  totals.bus = display.count();
  totals.bus.bytes -= start.bytes;
  totals.bus.busy_ns -= start.busy_ns;
  totals.bus.transfers -= start.transfers;
  return totals;
}

/// How the drawing that is estimated differs from the one that is shown, as text that follows the figures.
std::string assumptions(const SimulateArguments& arguments, const Totals& totals) {
  std::string text;
  if (totals.grey) text += "; textures in grey light";
  if (arguments.options.shading == "segment") text += "; flat faces by segment take up to a quarter more";
  if (totals.borders) text += "; for textures that repeat: others take up to 45 instructions more a pixel";
  if (arguments.options.plays()) text += "; without posing, see mesh --forecast";
  if (totals.other_pixels)
    text += "; for rgb565 without dither: other pixels take up to 40 instructions more each";
  if (arguments.options.scene.surface.highlight_fade != 0) text += "; without the fade of highlights";
  if (!arguments.options.scene.depth) text += "; with a depth buffer: without one it takes less";
  return text;
}

std::string report(const SimulateArguments& arguments, const SimulatedDisplay& display,
                   const Totals& totals) {
  const double frames = arguments.frames;
  const double bus_ms = static_cast<double>(totals.bus.busy_ns) / 1e6 / frames;
  const double draw_ms = static_cast<double>(totals.draw_ns) / 1e6 / frames;
  const Size size = display.size();
  const bool i2c = arguments.bus == "i2c";
  const std::string bus =
      i2c ? formatted("I2C at %g kHz", arguments.i2c_khz)
          : formatted("SPI at %g MHz, mode %d", arguments.spi_mhz, arguments.glass.spi_mode);
  std::string text = formatted("%s: %dx%d, %s, rotation %d, %s\n", arguments.panel.c_str(), size.width,
                               size.height, display.format().c_str(), arguments.glass.rotation, bus.c_str());
  text += formatted("sent: %.0f bytes a frame in %.0f transfers\n",
                    static_cast<double>(totals.bus.bytes) / frames,
                    static_cast<double>(totals.bus.transfers) / frames);
  text += formatted("bus: %.3f ms a frame; allows %.1f frames a second\n", bus_ms, 1000 / bus_ms);
  if (totals.without_figures.empty()) {
    const double frame_ms = static_cast<double>(totals.frame_ns) / 1e6 / frames;
    text += formatted(
        "drawing: %.0f instructions, clearing and packing %.0f: %.3f ms a frame on a Cortex-M3 at %g MHz (an "
        "estimate; vertices and rows of triangles are kept",
        totals.instructions / frames, totals.other_instructions / frames, draw_ms, arguments.cpu_mhz);
    text += assumptions(arguments, totals) + ")\n";
    if (!totals.other_methods.empty())
      text += formatted("the first frame by other methods: %s\n", totals.other_methods.c_str());
    text += formatted("both, %s: %.3f ms, %.1f frames a second; bottleneck: %s\n",
                      i2c ? "one after the other" : "overlapped", frame_ms, 1000 / frame_ms,
                      draw_ms > bus_ms ? "shading" : "the bus");
  } else {
    text += formatted("drawing: no figures of %s on a Cortex-M3\n", totals.without_figures.c_str());
  }
  if (totals.outline_bytes != 0) {
    text += "outlines: " + totals.outlines;
    if (totals.without_figures.empty())
      text += formatted(" by %.0f of these instructions", totals.outline_instructions / frames);
    text += formatted(", with %zu bytes of RAM that are not in what follows\n", totals.outline_bytes);
  }
  return text + formatted("RAM for buffers: %zu bytes; a whole frame would take %zu\n",
                          display.buffer_bytes(), display.frame_bytes());
}

// The SSD1306 on I2C: a clock cycle takes at least 2.5 us.
constexpr double kMostI2cKhz = 400;

void warn_of_clock(const SimulateArguments& arguments, const PanelModule& module) {
  const auto compare = [&module](const char* option, double given, double most, const char* unit) {
    if (given <= most) return;
    warn(option,
         formatted("%g is more than the %g %s of the data sheet of %s; many modules work, none has to", given,
                   most, unit, module.controller.c_str()));
  };
  if (arguments.bus == "i2c") return compare("--i2c-khz", arguments.i2c_khz, kMostI2cKhz, "kHz");
  compare("--spi-mhz", arguments.spi_mhz, module.most_spi_mhz, "MHz");
}

void run_simulate(SimulateArguments arguments) {
  const RenderOptions& given = arguments.options;
  check_results({arguments.output}, {given.mesh, given.texture, given.matcap});
  const PanelModule module = find_module("--panel", arguments.panel, arguments.glass);
  if (arguments.spi_mhz == 0) arguments.spi_mhz = module.most_spi_mhz;
  warn_of_clock(arguments, module);
  const std::unique_ptr<SimulatedDisplay> display = make_display(options_of(arguments));
  GlassOutput output(arguments.output, arguments.frames, display->picture());
  const Totals totals = show_all(arguments, *display, output);
  output.finish(report(arguments, *display, totals));
}

void add_display_options(CLI::App& app, SimulateArguments& a) {
  add_choice(app, "--panel,--device", "the display's module or controller", module_names(), a.panel);
  add_glass_options(app, a.glass);
  app.add_flag("--changes", a.display.changes_only, "send only what changed since the last frame");
  add_choice(app, "--bus", "what the panel hangs on; i2c for ssd1306", {"spi", "i2c"}, a.bus);
  add_parsed<double>(
      app, "--spi-mhz", "0.01...200",
      "clock of the SPI bus (default: the most that the controller's data sheet allows)",
      "a number 0.01...200",
      [](const std::string& text) {
        const std::optional<double> mhz = parse_number(text);
        return mhz && *mhz >= 0.01 && *mhz <= 200 ? mhz : std::nullopt;
      },
      [&a](double mhz) { a.spi_mhz = mhz; });
  add_number(app, "--i2c-khz", "clock of the I2C bus", 1, 5000, a.i2c_khz);
  add_number(app, "--cpu-mhz", "million instructions a second of the processor that draws", 0.1, 10000,
             a.cpu_mhz);
  app.add_flag("--planes", a.planes, "estimate for a mesh with planes, as `arcspan mesh --planes` makes it");
  add_integer(app, "--turntable", "N", "frames of a turn, 1...3600 (default 1: a still picture)", 1, 3600,
              a.frames);
  add_clip(app, a.options.clip);
}

}  // namespace

void add_simulate_command(CLI::App& app) {
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* simulate = app.add_subcommand(
      "simulate", "Draw a mesh on a simulated panel, through its driver and a model of its controller");
  add_outline_options(*simulate, arguments->options);
  add_render_options(*simulate, arguments->options);
  // The panel says these.
  simulate->remove_option(simulate->get_option("--size"));
  simulate->remove_option(simulate->get_option("--format"));
  add_display_options(*simulate, *arguments);
  simulate
      ->add_option(
          "-o,--output", arguments->output,
          "what the glass shows: .png, .ppm or .pgm; with --turntable an animation (.gif, .png) or a folder")
      ->required();
  simulate->footer(
      "Examples:\n"
      "  arcspan simulate torus:48x24 --panel ili9341 --rotate 90 -o panel.png\n"
      "  arcspan simulate torus:48x24 --panel st7789 --glass 135x240 --glass-at 52,40 -o small.png\n"
      "  arcspan simulate bunny.obj --panel ssd1306 --bus i2c --turntable 36 --changes -o oled.gif");
  simulate->callback([simulate, arguments] {
    check_clip(*simulate);
    if (simulate->count("--clip") != 0 && arguments->frames == 1)
      throw CLI::ValidationError("--clip", "needs --turntable");
    if (simulate->count("--clip") != 0 && arguments->planes)
      throw CLI::ValidationError("--planes", "excludes --clip: planes do not move");
    const bool i2c = arguments->bus == "i2c";
    for (const char* other : {"--spi-mhz", "--spi-mode", "--i2c-khz"}) {
      const bool is_of_i2c = std::string(other) == "--i2c-khz";
      if (simulate->count(other) != 0 && is_of_i2c != i2c)
        throw CLI::ValidationError(other, "is of --bus " + std::string(is_of_i2c ? "i2c" : "spi"));
    }
    run_simulate(*arguments);
  });
}

}  // namespace arcspan::tools
