// SPDX-License-Identifier: MIT
#include <arcspan_tools/plot/gnuplot.hpp>
#include <arcspan_tools/support/child_process.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <cstdio>

namespace arcspan::tools {
namespace {

constexpr std::size_t kMostPlotBytes = std::size_t{1} << 26;

/// `text` as gnuplot's double-quoted string.
std::string double_quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string plotted_number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", v);
  return text;
}

std::string data_block(std::size_t index, const Curve& curve) {
  std::string text = "$curve" + std::to_string(index) + " << EOD\n";
  for (const auto& [x, y] : curve.points) text += plotted_number(x) + " " + plotted_number(y) + "\n";
  return text + "EOD\n";
}

/// gnuplot has eight colours; the ninth curve is the first one's colour again, and dashed.
std::string line_style(std::size_t index) {
  constexpr std::size_t kColours = 8;
  return "lines lw 2 lt " + std::to_string(1 + index % kColours) + " dt " +
         std::to_string(1 + index / kColours);
}

std::string plot_item(std::size_t index, const Curve& curve) {
  return "$curve" + std::to_string(index) + " using 1:2 with " +
         (curve.marks ? "points pt 7 ps 1.2" : line_style(index)) + " title " + double_quoted(curve.label);
}

std::string message_line(const std::string& text) {
  const std::size_t from = text.find_first_not_of("\n ");
  if (from == std::string::npos) return "no message";
  return text.substr(from, text.find('\n', from) - from);
}

}  // namespace

std::string gnuplot_script(const Figure& figure, PlotFormat format, const std::string& output) {
  std::string script = "set encoding utf8\n";
  script += format == PlotFormat::kSvg
                ? "set terminal svg size 1120,600 noenhanced font 'DejaVu Sans,14' background rgb 'white'\n"
                : "set terminal pngcairo size 1120,600 noenhanced font 'DejaVu Sans,12'\n";
  script += "set output " + double_quoted(output) + "\nset grid\n";
  script += "set title " + double_quoted(figure.title) + "\n";
  script +=
      "set xlabel " + double_quoted(figure.x_label) + "\nset ylabel " + double_quoted(figure.y_label) + "\n";
  script += "set key outside right top\nset autoscale xfix\n";
  if (figure.logarithmic_x) script += "set logscale x\n";
  if (figure.logarithmic_y) script += "set logscale y\nset format y '%.0e'\n";
  std::string plot;
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    script += data_block(i, figure.curves[i]);
    plot += (i == 0 ? "plot " : ", ") + plot_item(i, figure.curves[i]);
  }
  return script + plot + "\nset output\n";
}

std::string draw_figure(const Figure& figure, PlotFormat format) {
  ScratchFolder folder;
  const std::string& output = folder.file("figure").path();
  // -d: without the user's settings, which would change the figure.
  const std::optional<ChildEnd> end = run_child("gnuplot", {"-d"}, gnuplot_script(figure, format, output));
  if (!end) throw Failure("gnuplot", "not found; figures are drawn by it (Debian package gnuplot-nox)");
  if (end->status != 0) throw Failure("gnuplot", message_line(end->error_text));
  if (!std::filesystem::exists(output)) throw Failure("gnuplot", "drew nothing");
  return read_whole_file(output, kMostPlotBytes);
}

}  // namespace arcspan::tools
