// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/image/difference.hpp>
#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/result_files.hpp>
#include <arcspan_tools/support/text.hpp>

#include <cstdio>
#include <memory>
#include <string>

namespace arcspan::tools {
namespace {

struct DiffArguments {
  std::string a;
  std::string b;
  std::string out;
  int limit = 255;
};

std::string size_text(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

void run_diff(const DiffArguments& arguments) {
  if (!arguments.out.empty()) (void)image_format(arguments.out);
  check_results({arguments.out}, {arguments.a, arguments.b});
  const Image a = read_image(arguments.a);
  const Image b = read_image(arguments.b);
  if (a.width != b.width || a.height != b.height) {
    throw Failure(arguments.b, "is " + size_text(b) + ", but " + arguments.a + " is " + size_text(a));
  }
  const Difference d = difference(a, b);
  const std::string summary = formatted("largest difference %d, mean %.4f, %zu of %zu pixels differ\n",
                                        d.largest, d.mean, d.differing_pixels, a.pixels.size());
  if (arguments.out.empty()) {
    write_results({}, summary);
  } else {
    write_image(difference_picture(a, b), arguments.out, summary);
  }
  if (d.largest > arguments.limit) throw ExitStatus{1};
}

}  // namespace

void add_diff_command(CLI::App& app) {
  auto arguments = std::make_shared<DiffArguments>();
  CLI::App* diff = app.add_subcommand("diff", "Compare two pictures of one size (PNG, PPM, PGM)");
  diff->add_option("A", arguments->a, "the one picture")->required();
  diff->add_option("B", arguments->b, "the other picture")->required();
  diff->add_option("-o,--output", arguments->out,
                   "write a picture of the differences, scaled to full brightness");
  diff->add_option("--limit", arguments->limit, "end with status 1 if any channel differs by more (0...255)")
      ->check(CLI::Range(0, 255));
  diff->footer(
      "Examples:\n"
      "  arcspan diff before.png after.png\n"
      "  arcspan diff arc.png gouraud.png -o difference.png --limit 8");
  diff->callback([arguments] { run_diff(*arguments); });
}

}  // namespace arcspan::tools
