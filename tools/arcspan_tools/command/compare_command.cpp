// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/command/effect_options.hpp>
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/command/render_options.hpp>
#include <arcspan_tools/compare/instructions.hpp>
#include <arcspan_tools/compare/sheet.hpp>
#include <arcspan_tools/compare/table.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/support/progress.hpp>
#include <arcspan_tools/support/result_files.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>

namespace arcspan::tools {
namespace {

struct CompareArguments {
  RenderOptions options;
  std::string output;
  std::vector<std::string> tables;
  std::vector<std::string> shadings;
  ReferenceKind reference = ReferenceKind::kPhong;
  bool instructions = true;
  std::string draw_only;
};

constexpr const char* kYardsticks[] = {"gouraud", "phong", "phong-reciprocal"};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_shading(const std::string& name) { return contains(shading_names(), name); }

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  return parts;
}

[[noreturn]] void refuse_shading(const std::string& name) {
  std::string complaint = "expected names out of ";
  for (const std::string& known : shading_choices()) complaint.append(known).append("|");
  complaint.back() = ' ';
  throw CLI::ValidationError("--shading", complaint + "with commas, not '" + name + "'");
}

std::vector<std::string> parse_shadings(const std::string& text) {
  std::vector<std::string> wanted;
  for (const std::string& name : split(text, ',')) {
    if (name == kAdaptive) refuse_adaptive();
    if (!contains(shading_choices(), name) && !is_shading(name)) refuse_shading(name);
    if (!contains(wanted, name)) wanted.push_back(name);
  }
  if (wanted.empty()) throw CLI::ValidationError("--shading", "names no shading");
  return wanted;
}

/// The renderers that are wanted: all if none was named; dichotomy is that of its polynomial, or all.
void choose_renderers(CompareArguments& a) {
  const std::vector<std::string> wanted = a.shadings.empty() ? shading_choices() : a.shadings;
  const std::string& polynomial = a.options.polynomial;
  if (!polynomial.empty() && !contains(wanted, kDichotomy)) {
    throw CLI::ValidationError("--polynomial", "only dichotomy has one, which --shading leaves out");
  }
  if (a.options.is_given("--segment") && std::none_of(wanted.begin(), wanted.end(), has_segments)) {
    throw CLI::ValidationError(
        "--segment", "only segment, phong-segment and dichotomy have some, which --shading leaves out");
  }
  if (a.options.is_given("--tolerance") && !contains(wanted, "arc")) {
    throw CLI::ValidationError("--tolerance", "only arc has one, which --shading leaves out");
  }
  a.shadings.clear();
  for (const std::string& name : wanted) {
    const std::vector<std::string> meant =
        name == kDichotomy ? dichotomies(polynomial) : std::vector<std::string>{name};
    for (const std::string& each : meant) {
      if (!contains(a.shadings, each)) a.shadings.push_back(each);
    }
  }
}

/// The command line of this process, with arguments that make it draw with one method and do nothing else.
std::vector<std::string> drawing_command(const std::string& shading) {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  const std::string line{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::vector<std::string> command = split(line, '\0');
  std::error_code failed;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failed);
  if (failed || command.empty()) return {};
  command[0] = self.string();
  command.push_back("--draw-only");
  command.push_back(shading);
  return command;
}

/// Instructions per pixel; nothing where they cannot be counted.
std::optional<double> instructions_per_pixel(const std::string& shading, std::size_t pixels, bool wanted) {
  if (!wanted || pixels == 0) return std::nullopt;
  const std::vector<std::string> command = drawing_command(shading);
  if (command.empty()) return std::nullopt;
  const std::optional<std::uint64_t> count = drawing_instructions(command);
  if (!count) return std::nullopt;
  return static_cast<double>(*count) / static_cast<double>(pixels);
}

std::uint64_t drawn_pixels(const std::string& shading, const RenderJob& job) {
  return find_renderer(shading, "rgb565", false).render(job, [](std::size_t) {}).stats.pixels;
}

/// Measures one shading method.
MethodFigures figures_of(const std::string& shading, const RenderJob& job, const FixedMeshes& meshes,
                         const ReferencePicture& reference, bool instructions) {
  MethodFigures figures = measure_method(shading, job, meshes, reference);
  figures.instructions = instructions_per_pixel(shading, drawn_pixels(shading, job), instructions);
  return figures;
}

Comparison compare(const CompareArguments& arguments, const RenderJob& job, const FixedMeshes& meshes,
                   const ReferencePicture& reference, const std::optional<TexturedScene>& textured) {
  std::vector<std::string> measured = arguments.shadings;
  const std::size_t shown = measured.size();
  for (const char* name : kYardsticks) {
    if (is_shading(name) && !contains(measured, name)) measured.push_back(name);
  }
  Comparison comparison;
  Progress progress("comparing", measured.size());
  for (std::size_t i = 0; i < measured.size(); ++i) {
    progress.show(i);
    MethodFigures figures = figures_of(measured[i], job, meshes, reference, arguments.instructions);
    if (std::find(std::begin(kYardsticks), std::end(kYardsticks), measured[i]) != std::end(kYardsticks)) {
      comparison.yardsticks.push_back({measured[i], figures.nanoseconds, figures.instructions});
    }
    if (textured) figures.textured = textured_error(measured[i], *textured);
    if (i < shown) comparison.methods.push_back(figures);
  }
  return comparison;
}

void run_compare(const CompareArguments& arguments) {
  (void)image_format(arguments.output);
  for (const std::string& table : arguments.tables) (void)table_format(table);
  const RenderOptions& options = arguments.options;
  std::vector<std::filesystem::path> written(arguments.tables.begin(), arguments.tables.end());
  written.emplace_back(arguments.output);
  check_results(written, {options.mesh, options.texture});
  Model loaded =
      load_model(options.mesh, options.crease_degrees, options.texture, VertexColours::kMean, options.pose);
  warn_of_clips(loaded, options.mesh);
  if (loaded.binary != nullptr) loaded = posed(loaded, PoseChoice{}, options.mesh);
  if (make_opaque(loaded)) warn(options.mesh, "transparent surfaces are compared opaque");
  const FixedModel skinned = to_fixed(loaded);
  const bool has_textures = remove_textures(loaded);
  const FixedModel model = to_fixed(loaded);
  const RenderJob job = make_job(options.scene, model, options.mesh);
  if (!arguments.draw_only.empty()) {
    (void)drawn_pixels(arguments.draw_only, job);
    return;
  }
  const ReferencePicture reference = draw_reference(job, arguments.reference);
  std::optional<TexturedScene> textured;
  if (has_textures) {
    textured = textured_scene(make_job(options.scene, skinned, options.mesh), arguments.reference);
  }
  Comparison comparison = compare(arguments, job, model, reference, textured);
  comparison.mesh_name = printable(options.mesh);
  comparison.mesh_triangles = model.triangle_count();
  comparison.width = reference.width;
  comparison.height = reference.height;
  comparison.reference_kind = arguments.reference;
  comparison.reference = reference.image(job.background);
  const Image sheet = contact_sheet(comparison, reference);
  std::vector<ResultFile> results = {{arguments.output, encode_image(sheet, image_format(arguments.output))}};
  for (const std::string& table : arguments.tables) {
    results.push_back({table, comparison_table(comparison, table_format(table))});
  }
  write_results(results, comparison_table(comparison, TableFormat::kMarkdown));
}

void add_options(CLI::App& app, CompareArguments& a) {
  add_render_options(app, a.options);
  app.remove_option(app.get_option("--shading"));
  app.remove_option(app.get_option("--format"));
  app.remove_option(app.get_option("--dither"));
  for (const char* effect : kEffectOptions) app.remove_option(app.get_option(effect));
  app.add_option("-o,--output", a.output, "the contact sheet: .png, .ppm or .pgm")->required();
  app.add_option("--table", a.tables, "write the printed figures as .md, .csv or .json; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option_function<std::string>(
         "--shading", [&a](const std::string& text) { a.shadings = parse_shadings(text); },
         "only these, with commas between them (default: all)")
      ->type_name("A,B,C");
  app.parse_complete_callback([&app, &a] {  // in place of that for one shading
    note_settings(app, a.options);
    choose_renderers(a);
  });
  app.add_option_function<std::string>(
         "--reference",
         [&a](const std::string& text) {
           if (text != "phong" && text != "slerp") {
             throw CLI::ValidationError("--reference", "expected phong or slerp, not '" + text + "'");
           }
           a.reference = text == "phong" ? ReferenceKind::kPhong : ReferenceKind::kSlerp;
         },
         "what errors are measured from: normals along chords (default) or along great circles")
      ->type_name("phong|slerp");
  app.add_flag("--instructions,!--no-instructions", a.instructions,
               "count instructions by valgrind, if it is installed (default)");
  // How this program asks itself, under valgrind, to draw once; not for people.
  app.add_option("--draw-only", a.draw_only)->group("");
}

}  // namespace

void add_compare_command(CLI::App& app) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* compare = app.add_subcommand(
      "compare", "Draw a mesh by every shading method: a contact sheet and what each costs");
  add_options(*compare, *arguments);
  compare->footer(
      "Two or three lights are drawn, timed and counted as four, of which the others are dark. Several "
      "lights\n"
      "are drawn through virtual calls, and the methods of the papers reach them by further ones; so are\n"
      "highlights that fade. Textures have errors of their own: against the texels that are shown, times "
      "light in\n"
      "doubles. Operations are counted as of white lights and of highlights that do not fade.\n"
      "Examples:\n"
      "  arcspan compare bunny.obj -o sheet.png\n"
      "  arcspan compare sphere:32x16 -o sheet.png --shading gouraud,phong,arc --table costs.md");
  compare->callback([arguments] { run_compare(*arguments); });
}

}  // namespace arcspan::tools
