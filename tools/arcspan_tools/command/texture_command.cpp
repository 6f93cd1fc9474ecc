// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/command/texture_options.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/output/texture_writer.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/support/result_files.hpp>
#include <arcspan_tools/support/text.hpp>
#include <arcspan_tools/texture/compile/texture_error.hpp>
#include <arcspan_tools/texture/compile/texture_picture.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace arcspan::tools {
namespace {

struct TextureArguments {
  std::string picture;
  std::string output;
  std::string name;
  std::string report;
  TextureOptions options = default_texture_options();
};

std::string error_text(const TextureError& error) {
  if (error.largest == 0) return "exact";
  return formatted("PSNR %.1f dB, mean error %.2f, largest %d of 255", error.psnr, error.mean, error.largest);
}

std::string report_text(const TextureArguments& arguments, const RgbaImage& picture,
                        const TextureAndLevels& made) {
  const TextureSize& size = made.texture.size;
  const RgbaImage& first = made.levels[0];
  const bool resized = picture.width != first.width || picture.height != first.height;
  std::string text = printable(arguments.picture) + formatted(": %dx%d", picture.width, picture.height);
  if (resized) text += formatted(", resized to %dx%d", first.width, first.height);
  text +=
      "\n" + printable(arguments.output) +
      formatted(": %dx%d texels, %s, %d %s, %zu bytes\n", first.width, first.height, made.texture.format.name,
                size.levels, size.levels == 1 ? "level" : "levels", made.texture.bytes());
  text += left_out_text(made.texture);
  return text + "against the picture" + (resized ? " at that size: " : ": ") +
         error_text(texture_error(first, drawn_level(made.texture, 0))) + "\n";
}

/// Warns if the format leaves out what is transparent.
void warn_of_opacity(const TextureArguments& arguments, const RgbaImage& picture) {
  const auto is_transparent = [](Rgba8 c) { return c.a < 255; };
  if (arguments.options.format.alpha_bits > 0 ||
      std::none_of(picture.pixels.begin(), picture.pixels.end(), is_transparent)) {
    return;
  }
  warn(arguments.picture,
       std::string("is transparent in places, which ") + arguments.options.format.name + " cannot store");
}

std::string name_of(const TextureArguments& arguments) {
  if (!arguments.name.empty()) return arguments.name;
  const std::filesystem::path from =
      is_standard_output(arguments.output) ? arguments.picture : arguments.output;
  return identifier(from.stem().string());
}

void run_texture(const TextureArguments& arguments) {
  const CompiledOutput output = compiled_output(arguments.output, "texture");
  check_results({arguments.output, arguments.report}, {arguments.picture});
  if (!arguments.report.empty()) (void)image_format(arguments.report);
  const RgbaImage picture = read_rgba(arguments.picture);
  const TextureAndLevels made = make_texture(picture, arguments.options, arguments.picture);
  const std::string origin = std::filesystem::path(arguments.picture).filename().string();
  std::vector<ResultFile> results = {
      {arguments.output, output == CompiledOutput::kBinary
                             ? texture_binary_file(made.texture)
                             : texture_header(made.texture, name_of(arguments), origin)}};
  if (!arguments.report.empty()) {
    results.push_back(
        {arguments.report, encode_image(before_and_after(made), image_format(arguments.report))});
  }
  write_results(results, report_text(arguments, picture, made));
  warn_of_opacity(arguments, picture);
}

}  // namespace

void add_texture_command(CLI::App& app) {
  auto arguments = std::make_shared<TextureArguments>();
  CLI::App* texture = app.add_subcommand("texture", "Compile a picture into a texture for flash");
  texture->add_option("PICTURE", arguments->picture, "a PNG, JPEG, BMP, TGA, PPM or PGM file")->required();
  texture
      ->add_option("-o,--output", arguments->output,
                   "a header of constexpr arrays (.hpp, .h) or a binary (.bin); hpp:- and bin:- are standard "
                   "output")
      ->required();
  add_texture_format(*texture, "--format", arguments->options.format);
  add_texture_size(*texture, "--size", "", arguments->options.size);
  add_texture_levels(*texture, "--levels", arguments->options.levels);
  texture->add_flag("--dither", arguments->options.dither,
                    "mix colours that the format lacks of neighbouring texels");
  texture->add_flag("--exact", arguments->options.exact,
                    "refuse a picture that would have to be resized or has too many colours for the palette");
  add_sampler(*texture, arguments->options.sampler);
  texture->add_option("--name", arguments->name, "the header's namespace (default: from the file's name)")
      ->check([](const std::string& text) {
        return is_identifier(text) ? "" : "'" + text + "' cannot name a namespace";
      });
  texture->add_option("--report", arguments->report,
                      "draw the picture and the texture side by side, and the levels");
  texture->footer(
      "Examples:\n"
      "  arcspan texture wood.jpg -o wood.hpp --size 128 --format pal8 --levels all --report wood.png\n"
      "  arcspan texture leaf.png -o leaf.bin --format pal4-5551 --wrap clamp");
  texture->callback([texture, arguments] {
    if (texture->count("--name") != 0 &&
        compiled_output(arguments->output, "texture") == CompiledOutput::kBinary)
      throw CLI::ValidationError("--name", "is of headers, not of binaries");
    run_texture(*arguments);
  });
}

}  // namespace arcspan::tools
