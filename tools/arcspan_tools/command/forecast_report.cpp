// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/forecast_report.hpp>
#include <arcspan_tools/command/method_advice.hpp>
#include <arcspan_tools/support/text.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>

namespace arcspan::tools {
namespace {

/// "1.23 M, 40.7", or a dash.
std::string figure_text(const std::optional<double>& instructions, double mips) {
  if (!instructions) return "-";
  return formatted("%.2f M %6.1f", *instructions / 1e6, mips * 1e6 / *instructions);
}

/// The advice by the figures of a Cortex-M3, or why there are none.
std::string advice_text(const Forecast& f) {
  constexpr std::size_t kCortexM3 = 1;
  MethodCosts costs;
  costs.textured = f.textured;
  double* const places[] = {&costs.flat, &costs.gouraud, &costs.arc};
  for (std::size_t i = 0; i < std::size(places); ++i) {
    const std::optional<double>& figure = f.methods[i].instructions[kCortexM3];
    if (!figure) return "  no figures for colours of vertices and for transparency\n";
    *places[i] = *figure;
  }
  return "  advice: " + method_advice(costs) + "\n";
}

}  // namespace

std::string to_text(const Forecast& f) {
  std::string text = formatted(
      "forecast: %dx%d in rgb565 with depth, one light, the model as large as fits, mean of %zu pictures, "
      "whole or in bands\n  of %d rows, with clearing%s; instructions, and frames per second at %g million "
      "of "
      "them per second\n",
      f.size.width, f.size.height, f.pictures, static_cast<int>(Forecast::kBandRows),
      f.outlined ? " and smooth outlines" : "", f.mips);
  text += formatted("  %-13s", "");
  for (const ForecastCore& core : kForecastCores) text += formatted(" %16s", core.name);
  text += "\n";
  for (const Forecast::Method& method : f.methods) {
    text += formatted("  %-13s", method.name.c_str());
    for (const std::optional<double>& figure : method.instructions)
      text += formatted(" %16s", figure_text(figure, f.mips).c_str());
    text += "\n";
  }
  text += advice_text(f);
  if (f.pose_bytes != 0) {
    const CoreFigures& posing = f.methods.back().posing;
    text += "  of arc, for joints and vertices:";
    for (std::size_t i = 0; i < posing.size(); ++i)
      text += formatted("%s %.2f M", i == 0 ? "" : ",", posing[i].value_or(0) / 1e6);
    text += "\n";
  }
  text +=
      "  mostly within 5 % of a program with one method and one kind of mesh, 7 % of others, as measured\n";
  if (f.borders) text += "  textures that do not repeat take up to 45 instructions more per pixel\n";
  return text + formatted(
                    "  flash: %zu bytes of model, and the program; RAM: %zu bytes of colours and depths, or "
                    "%zu in bands,\n    %zu of vertices, or in bands %zu and %zu of rows of triangles "
                    "(fewer or none is slower), %zu of nodes, joints and morph targets\n",
                    f.model_bytes, f.frame_bytes, f.band_bytes, f.cache_bytes, f.kept_bytes, f.row_bytes,
                    f.pose_bytes);
}

nlohmann::ordered_json to_json(const Forecast& f) {
  nlohmann::ordered_json methods = nlohmann::ordered_json::object();
  for (const Forecast::Method& method : f.methods) {
    nlohmann::ordered_json& of_cores = methods[method.name];
    for (std::size_t i = 0; i < kForecastCores.size(); ++i) {
      const std::optional<double>& figure = method.instructions[i];
      of_cores[kForecastCores[i].name] =
          figure ? nlohmann::ordered_json(std::round(*figure)) : nlohmann::ordered_json();
    }
  }
  nlohmann::ordered_json posing = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < kForecastCores.size(); ++i)
    posing[kForecastCores[i].name] = std::round(f.methods.back().posing[i].value_or(0));
  return {{"width", f.size.width},
          {"height", f.size.height},
          {"instructions", methods},
          {"posing", posing},
          {"flash", f.model_bytes},
          {"ram",
           {{"frame", f.frame_bytes},
            {"band", f.band_bytes},
            {"vertices", f.cache_bytes},
            {"kept_vertices", f.kept_bytes},
            {"rows", f.row_bytes},
            {"pose", f.pose_bytes}}}};
}

}  // namespace arcspan::tools
