// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/command/clip_sheet.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/command/render_options.hpp>
#include <arcspan_tools/command/render_report.hpp>
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/image/reduced.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/support/progress.hpp>
#include <arcspan_tools/support/result_files.hpp>
#include <arcspan_tools/support/text.hpp>

#include <chrono>
#include <cstdio>
#include <memory>

namespace arcspan::tools {
namespace {

struct RenderArguments {
  RenderOptions options;
  std::string output;
  std::string stats;
  std::int32_t samples = 1;  ///< along each side of a pixel
};

struct Loaded {
  FixedModel model;
  RenderReport report;
};

Loaded load(RenderArguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const Model model = load_drawn_model(arguments.options);
  Loaded loaded{to_fixed(model, arguments.options), {}};
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  RenderReport& report = loaded.report;
  report.mesh_name = arguments.options.mesh;
  report.output = arguments.output;
  report.shading = arguments.options.shading;
  report.vertices = model.vertex_count();
  report.mesh_triangles = model.triangle_count();
  report.parts = model.parts.size();
  report.dropped_faces = model.dropped_faces;
  report.crease_degrees = model.crease_degrees;
  report.mesh_bytes = loaded.model.bytes();
  report.load_milliseconds = elapsed.count();
  report.outlines = arguments.options.outline_text();
  return loaded;
}

/// Says where the model is if the fog hides all of it or nothing.
void warn_of_fog(const RenderOptions& options, const RenderJob& job) {
  const std::optional<SceneFog>& fog = options.scene.fog;
  if (!fog) return;
  const std::string place =
      formatted("the model, which is %g...%g from the camera", job.nearest, job.farthest);
  if (fog->near_distance >= job.farthest) warn("--fog", "begins behind " + place);
  if (fog->far_distance <= job.nearest) warn("--fog", "hides all of " + place);
}

/// The size of what is drawn for a picture of the size that was asked for.
Size drawn_size(const RenderArguments& arguments) {
  const Size& size = arguments.options.scene.size;
  const std::int32_t n = arguments.samples;
  const Size drawn{n * size.width, n * size.height};
  if (drawn.width <= kMostRenderedSide && drawn.height <= kMostRenderedSide) return drawn;
  throw CLI::ValidationError(
      "--samples", formatted("%d times %dx%d is more than %dx%d, which is the largest picture", n, size.width,
                             size.height, kMostRenderedSide, kMostRenderedSide));
}

/// The width of ink that has its own width in the picture that was asked for.
std::uint8_t drawn_width(const OutlineInk& ink, std::int32_t samples) {
  const std::int32_t width = ink.width * samples;
  if (width <= OutlineInk::kWidest) return static_cast<std::uint8_t>(width);
  throw CLI::ValidationError("--samples", formatted("with ink that is %d wide at most %d", ink.width,
                                                    OutlineInk::kWidest / ink.width));
}

void run_sheet(RenderArguments& arguments) {
  RenderOptions& options = arguments.options;
  (void)image_format(arguments.output);
  check_results({arguments.output}, {options.mesh, options.texture, options.matcap});
  const Model model = load_drawn_model(options);
  const Image sheet = clip_sheet(options, model);
  write_image(sheet, arguments.output,
              printable(arguments.output) + ": clips of " + printable(options.mesh) + ": " +
                  printable(clip_list(model)) + "\n");
}

void run_render(RenderArguments& arguments) {
  const RenderOptions& options = arguments.options;
  const ImageFormat format = image_format(arguments.output);
  check_results({arguments.output, arguments.stats}, {options.mesh, options.texture, options.matcap});
  Loaded loaded = load(arguments);
  const Size size = options.scene.size;
  Scene scene = options.scene;
  scene.size = drawn_size(arguments);
  if (scene.outlines.ink) scene.outlines.ink->width = drawn_width(*scene.outlines.ink, arguments.samples);
  const RenderJob job = make_job(scene, loaded.model, options.mesh);
  warn_of_fog(options, job);
  Progress progress("drawing", static_cast<std::size_t>(scene.size.height));
  const Renderer& renderer = find_renderer(options.shading, options.format, options.dither);
  const RenderResult result = renderer.render(job, [&progress](std::size_t rows) { progress.show(rows); });
  loaded.report.format = options.format + (renderer.pixels.dithers ? ", dithered" : "");
  if (arguments.samples > 1)
    loaded.report.format += formatted(", %dx%d samples a pixel", arguments.samples, arguments.samples);
  loaded.report.width = size.width;
  loaded.report.height = size.height;
  loaded.report.stats = result.stats;
  std::vector<ResultFile> results = {
      {arguments.output, encode_image(reduced(result.image, arguments.samples), format)}};
  if (!arguments.stats.empty()) results.push_back({arguments.stats, to_json(loaded.report)});
  write_results(results, to_text(loaded.report));
}

}  // namespace

void add_render_command(CLI::App& app) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* render = app.add_subcommand("render", "Draw a mesh with the integer pipeline");
  add_outline_options(*render, arguments->options);
  add_render_options(*render, arguments->options);
  render
      ->add_option("-o,--output", arguments->output,
                   "the picture: .png, .ppm or .pgm; - is standard output (PNG), so are ppm:- and pgm:-")
      ->required();
  add_integer(
      *render, "--samples", "N",
      "N*N samples a pixel, N 1...8 (default 1), for paper: draws N times as large, and takes the mean", 1, 8,
      arguments->samples);
  render->add_option("--stats", arguments->stats, "write the printed figures as JSON");
  render->add_flag("--clips", arguments->options.all_clips,
                   "a sheet of all clips of the file (.gltf, .glb, .fbx, .dae, .3ds, .bin): a row for each, "
                   "with eight pictures");
  render->footer(
      "Examples:\n"
      "  arcspan render bunny.obj -o bunny.png --size 640x480\n"
      "  arcspan render torus:48x24 -o torus.png --shading gouraud --light 1,1,1 --light -1,0,0.5\n"
      "  arcspan render part.obj -o part.png --texture wood.jpg\n"
      "  arcspan render bunny.obj -o bunny.png --matcap gold.png --fog 2,4#0.6,0.7,0.8\n"
      "  arcspan render man.glb -o step.png --pose Walk@0.25\n"
      "  arcspan render man.glb -o clips.png --clips --size 120x160\n"
      "  arcspan render part.stl -o - --format mono --size 128x64 | display");
  render->callback([render, arguments] {
    for (const char* option : {"--stats", "--pose"}) {
      if (arguments->options.all_clips && render->count(option) != 0)
        throw CLI::ValidationError(option, "excludes --clips");
    }
    if (arguments->options.all_clips) {
      run_sheet(*arguments);
    } else {
      run_render(*arguments);
    }
  });
}

}  // namespace arcspan::tools
