// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/command/typed_options.hpp>
#include <arcspan_tools/font/font_picture.hpp>
#include <arcspan_tools/font/make_font.hpp>
#include <arcspan_tools/font/source_font.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/parse.hpp>
#include <arcspan_tools/support/printable.hpp>
#include <arcspan_tools/support/result_files.hpp>
#include <arcspan_tools/support/text.hpp>

#include <memory>

namespace arcspan::tools {
namespace {

struct FontArguments {
  std::string input;
  std::string output;
  std::string name;
  std::string report;
  std::string bits = "1";
  FontOptions options;
};

/// `N` or `1/N`, up to 8.
std::optional<FontScale> parse_scale(const std::string& text) {
  constexpr std::int64_t kMost = 8;
  const bool smaller = text.starts_with("1/");
  const auto factor = parse_integer(std::string_view(text).substr(smaller ? 2 : 0));
  if (!factor || *factor < 1 || *factor > kMost) return std::nullopt;
  const auto n = static_cast<std::int32_t>(*factor);
  return smaller ? FontScale{1, n} : FontScale{n, 1};
}

std::string report_text(const FontArguments& arguments, const MadeFont& made) {
  const std::size_t count = made.glyphs.size() - 1;
  return printable(arguments.output) +
         formatted(": %zu %s of %u %s per pixel, lines of %d rows, %zu bytes\n", count,
                   count == 1 ? "character" : "characters", made.bits, made.bits == 1 ? "bit" : "bits",
                   made.line_height, made.bytes()) +
         "other characters are shown as " + made.placeholder + "\n";
}

/// Warns of the characters that were asked for and do not exist.
void warn_of_left_out(const FontArguments& arguments, const MadeFont& made) {
  if (made.left_out.empty()) return;
  const std::size_t more = made.left_out.size() - 1;
  warn(arguments.input, formatted("has no U+%04X", static_cast<unsigned>(made.left_out[0])) +
                            (more == 0 ? "" : formatted(", and %zu more of --range", more)));
}

void run_font(const FontArguments& arguments) {
  const std::string kind = output_kind(arguments.output, "hpp");
  if (kind != "hpp" && kind != "h")
    throw Failure(arguments.output, "a compiled font is a header: its name must end in .hpp or .h");
  check_results({arguments.output, arguments.report}, {arguments.input});
  if (!arguments.report.empty()) (void)image_format(arguments.report);
  const MadeFont made = make_font(read_font(arguments.input), arguments.options, arguments.input);
  const std::filesystem::path named =
      is_standard_output(arguments.output) ? arguments.input : arguments.output;
  const std::string name = arguments.name.empty() ? identifier(named.stem().string()) : arguments.name;
  const std::string origin = std::filesystem::path(arguments.input).filename().string();
  std::vector<ResultFile> results = {{arguments.output, font_header(made, name, origin)}};
  if (!arguments.report.empty())
    results.push_back({arguments.report, encode_image(font_picture(made), image_format(arguments.report))});
  write_results(results, report_text(arguments, made));
  warn_of_left_out(arguments, made);
}

}  // namespace

void add_font_command(CLI::App& app) {
  auto arguments = std::make_shared<FontArguments>();
  CLI::App* font = app.add_subcommand("font", "Compile a bitmap font for flash");
  font->add_option("FONT", arguments->input, "a BDF, PCF or Unifont .hex file, also compressed (.gz)")
      ->required();
  font->add_option("-o,--output", arguments->output,
                   "a header of constexpr arrays (.hpp, .h); hpp:- is standard output")
      ->required();
  add_parsed<std::vector<CodeRange>>(
      *font, "--range", "LIST", "characters, such as 32-126,0xB0,U+2190-U+2193 [32-126]",
      "code points or ranges with commas between them, such as 32-126,0xB0", parse_ranges,
      [arguments](const std::vector<CodeRange>& ranges) { arguments->options.ranges = ranges; });
  add_choice(*font, "--bits",
             "bits per pixel: 1, or 4 for smooth edges, of a font that --scale makes smaller", {"1", "4"},
             arguments->bits);
  add_parsed<FontScale>(*font, "--scale", "SCALE",
                        "makes the font N times as large (N) or as small (1/N), N 1...8 [1]",
                        "1...8 or 1/2...1/8", parse_scale,
                        [arguments](const FontScale& scale) { arguments->options.scale = scale; });
  font->add_option("--name", arguments->name, "the header's namespace (default: from the file's name)")
      ->check([](const std::string& text) {
        return is_identifier(text) ? "" : "'" + text + "' cannot name a namespace";
      });
  font->add_option("--report", arguments->report, "draw all characters into this picture");
  font->footer(
      "Examples:\n"
      "  arcspan font ter-u24n_unicode.pcf.gz -o label.hpp --range 32-126,0xB0 --report label.png\n"
      "  arcspan font ter-u32b_unicode.pcf.gz -o small.hpp --bits 4 --scale 1/2");
  font->callback([arguments] {
    arguments->options.bits = arguments->bits == "4" ? 4 : 1;
    if (arguments->options.bits == 4 && arguments->options.scale.down == 1)
      throw CLI::ValidationError("--bits",
                                 "4 needs --scale 1/2 or smaller: the pixels of the file are set or not");
    run_font(*arguments);
  });
}

}  // namespace arcspan::tools
