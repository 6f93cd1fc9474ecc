// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/plot/figure.hpp>
#include <arcspan_tools/plot/gnuplot.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/result_files.hpp>

#include <filesystem>
#include <memory>

namespace arcspan::tools {
namespace {

struct PlotArguments {
  std::string figure;
  std::string output;
};

std::string figure_list(const char* between) {
  std::string list;
  for (const FigureMaker& maker : figure_makers()) {
    list += (list.empty() ? "" : between) + std::string(maker.name);
  }
  return list;
}

const FigureMaker& find_figure(const std::string& name) {
  for (const FigureMaker& maker : figure_makers()) {
    if (maker.name == name) return maker;
  }
  throw CLI::ValidationError("FIGURE", "expected " + figure_list("|") + ", not '" + name + "'");
}

std::string drawn(const FigureMaker& maker, const std::string& output) {
  const std::string extension = std::filesystem::path(output).extension().string();
  if (extension == ".csv") return to_csv(maker.make());
  if (extension == ".svg") return draw_figure(maker.make(), PlotFormat::kSvg);
  if (extension == ".png") return draw_figure(maker.make(), PlotFormat::kPng);
  throw Failure(output, "a figure's name must end in .svg, .png or .csv");
}

void run_plot(const PlotArguments& arguments) {
  check_results({arguments.output}, {});
  write_whole_file(arguments.output, drawn(find_figure(arguments.figure), arguments.output));
}

}  // namespace

void add_plot_command(CLI::App& app) {
  auto arguments = std::make_shared<PlotArguments>();
  CLI::App* plot =
      app.add_subcommand("plot", "Draw a figure of the papers from our own computation (gnuplot)");
  std::string help = "one of:";
  for (const FigureMaker& maker : figure_makers()) {
    help += "\n  " + std::string(maker.name) + ": " + std::string(maker.help);
  }
  plot->add_option("FIGURE", arguments->figure, help)->required();
  plot->add_option("-o,--output", arguments->output, "the diagram, .svg or .png; or its numbers, .csv")
      ->required();
  plot->footer(
      "Examples:\n"
      "  arcspan plot specular-error -o specular.svg\n"
      "  arcspan plot recurrence-error -o recurrence.csv");
  plot->callback([arguments] { run_plot(*arguments); });
}

}  // namespace arcspan::tools
