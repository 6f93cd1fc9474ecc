// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/command/played_model.hpp>
#include <arcspan_tools/command/render_options.hpp>
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/output/frame_output.hpp>
#include <arcspan_tools/render/turntable.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/support/progress.hpp>
#include <arcspan_tools/support/result_files.hpp>
#include <arcspan_tools/support/text.hpp>

#include <cmath>
#include <cstdio>
#include <memory>

namespace arcspan::tools {
namespace {

struct TurntableArguments {
  RenderOptions options;
  std::string output;
  std::int32_t frames = 36;
  double frames_per_second = 18;
  std::string pictures = "png";
};

FrameFormat format_of(const TurntableArguments& arguments) {
  FrameFormat format;
  format.frames = static_cast<std::size_t>(arguments.frames);
  format.size = arguments.options.scene.size;
  format.milliseconds = static_cast<std::int32_t>(std::lround(1000 / arguments.frames_per_second));
  format.pictures = arguments.pictures == "ppm" ? ImageFormat::kPpm : ImageFormat::kPng;
  return format;
}

void run_turntable(TurntableArguments& arguments) {
  RenderOptions& options = arguments.options;
  const FrameFormat format = format_of(arguments);
  check_results({arguments.output}, {options.mesh, options.texture, options.matcap});
  const std::unique_ptr<FrameOutput> output = make_frame_output(arguments.output, format);
  PlayedModel model(options, format.frames, arguments.frames_per_second);
  const Renderer& renderer = find_renderer(options.shading, options.format, options.dither);
  const Turntable turntable(options.scene, model.extent(), format.frames);
  Progress progress("drawing", format.frames);
  double milliseconds = 0;
  double smooth_milliseconds = 0;
  for (std::size_t frame = 0; frame < format.frames; ++frame) {
    RenderJob job = make_job(turntable.scene(frame), model.frame(frame), options.mesh);
    job.counts = false;
    RenderResult result = renderer.render(job, [](std::size_t) {});
    milliseconds += result.stats.draw_milliseconds;
    smooth_milliseconds += result.stats.smooth_milliseconds;
    output->add(std::move(result.image));
    progress.show(frame + 1);
  }
  const auto frames = static_cast<double>(format.frames);
  std::string text =
      printable(arguments.output) + formatted(": %zu frames of %dx%d, %d ms each, drawn in %.2f ms each",
                                              format.frames, format.size.width, format.size.height,
                                              format.milliseconds, milliseconds / frames);
  if (options.has_outlines())
    text += formatted(", outlines %s in %.2f ms each", options.outline_text().c_str(),
                      smooth_milliseconds / frames);
  output->finish(text + "\n");
}

}  // namespace

void add_turntable_command(CLI::App& app) {
  auto arguments = std::make_shared<TurntableArguments>();
  CLI::App* turntable =
      app.add_subcommand("turntable", "Draw a turn of a mesh as an animation or numbered pictures");
  add_outline_options(*turntable, arguments->options);
  add_render_options(*turntable, arguments->options);
  turntable
      ->add_option(
          "-o,--output", arguments->output,
          "an animation (.gif, .png; gif:- and png:- are standard output), or a folder for numbered pictures")
      ->required();
  add_clip(*turntable, arguments->options.clip);
  add_integer(*turntable, "--frames", "N", "pictures of a turn, 2...3600 (default 36)", 2, 3600,
              arguments->frames);
  add_number(*turntable, "--fps", "pictures a second of an animation", 1, 50, arguments->frames_per_second);
  add_choice(*turntable, "--pictures", "format of a folder's pictures", {"png", "ppm"}, arguments->pictures);
  turntable->footer(
      "Examples:\n"
      "  arcspan turntable bunny.obj -o bunny.gif --size 160x120\n"
      "  arcspan turntable torus:48x24 -o turn.png --frames 72 --fps 30 --shading gouraud\n"
      "  arcspan turntable man.glb -o walk.gif --clip Walk --frames 48\n"
      "  arcspan turntable part.stl -o frames/ --frames 360 --pictures ppm");
  turntable->callback([turntable, arguments] {
    check_clip(*turntable);
    const bool is_folder = is_frame_folder(arguments->output);
    if (is_folder && turntable->count("--fps") != 0)
      throw CLI::ValidationError("--fps", "is of animations, not of a folder's pictures");
    if (!is_folder && turntable->count("--pictures") != 0)
      throw CLI::ValidationError("--pictures", "is of folders, not of an animation");
    run_turntable(*arguments);
  });
}

}  // namespace arcspan::tools
