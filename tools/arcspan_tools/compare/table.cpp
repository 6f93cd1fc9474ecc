// SPDX-License-Identifier: MIT
#include <arcspan_tools/compare/table.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/text.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace arcspan::tools {
namespace {

/// One column: what it is called, how many decimals people see, and its value for a method, if there is one.
struct Column {
  std::string key;    ///< for machines
  std::string title;  ///< for people
  int decimals = 0;
  std::function<std::optional<double>(const MethodFigures&)> value;
};

std::optional<double> ratio(std::optional<double> a, std::optional<double> b) {
  if (!a || !b || *b <= 0) return std::nullopt;
  return *a / *b;
}

void add_operation_columns(std::vector<Column>& columns) {
  for (std::size_t i = 0; i < arcspan_counting::kOperationKinds; ++i) {
    const std::string name(arcspan_counting::kOperationNames[i]);
    columns.push_back({name, name, 2, [i](const MethodFigures& m) { return m.per_pixel[i]; }});
  }
  columns.push_back({"around", "set-up", 1, [](const MethodFigures& m) { return m.around; }});
}

void add_cost_columns(std::vector<Column>& columns, const Comparison& comparison) {
  columns.push_back({"nanoseconds", "ns", 2, [](const MethodFigures& m) { return m.nanoseconds; }});
  for (const Yardstick& y : comparison.yardsticks) {
    columns.push_back({"time_per_" + y.shading, "time / " + y.shading, 2,
                       [y](const MethodFigures& m) { return ratio(m.nanoseconds, y.nanoseconds); }});
  }
  columns.push_back({"instructions", "instr.", 1, [](const MethodFigures& m) { return m.instructions; }});
  for (const Yardstick& y : comparison.yardsticks) {
    columns.push_back({"instructions_per_" + y.shading, "instr. / " + y.shading, 2,
                       [y](const MethodFigures& m) { return ratio(m.instructions, y.instructions); }});
  }
}

void add_error_columns(std::vector<Column>& columns) {
  columns.push_back({"max_error", "max", 2, [](const MethodFigures& m) { return m.error.max; }});
  columns.push_back({"rms_error", "RMS", 3, [](const MethodFigures& m) { return m.error.rms; }});
  columns.push_back({"psnr", "PSNR, dB", 1, [](const MethodFigures& m) { return m.error.psnr; }});
  columns.push_back({"ssim", "SSIM", 5, [](const MethodFigures& m) { return m.error.ssim; }});
}

void add_textured_columns(std::vector<Column>& columns, const Comparison& comparison) {
  const auto has_error = [](const MethodFigures& m) { return m.textured.has_value(); };
  if (std::none_of(comparison.methods.begin(), comparison.methods.end(), has_error)) return;
  const auto of = [](double PictureError::*figure) {
    return [figure](const MethodFigures& m) {
      return m.textured ? std::optional(*m.textured.*figure) : std::nullopt;
    };
  };
  columns.push_back({"textured_max_error", "max, textured", 2, of(&PictureError::max)});
  columns.push_back({"textured_rms_error", "RMS, textured", 3, of(&PictureError::rms)});
  columns.push_back({"textured_psnr", "PSNR, textured", 1, of(&PictureError::psnr)});
}

std::vector<Column> all_columns(const Comparison& comparison) {
  std::vector<Column> columns;
  add_operation_columns(columns);
  add_cost_columns(columns, comparison);
  add_error_columns(columns);
  add_textured_columns(columns, comparison);
  return columns;
}

std::string number_text(std::optional<double> value, int decimals, const char* missing) {
  if (!value || !std::isfinite(*value)) return missing;
  return formatted("%.*f", decimals, *value);
}

constexpr const char* kNotes =
    "Operations, ns and instructions are per drawn pixel. The operations by kind are those of the pixels "
    "themselves;\n`set-up` is all kinds together for vertices, triangles and row starts. ns and instr. are "
    "of "
    "the whole draw on\nthis machine. Errors are in 8-bit steps from the double reference before rounding, "
    "half a "
    "step of which is rounding.\nThe largest error (max) is usually where N·L changes sign: a highlight ends "
    "abruptly there, and pixels on the other\nside of that border than the reference's differ by the whole "
    "highlight (--highlight-fade softens the border).\n";

std::string markdown(const Comparison& c, const std::vector<Column>& columns) {
  std::string text =
      c.mesh_name + ", " + std::to_string(c.mesh_triangles) + " triangles, " + std::to_string(c.width) + "x" +
      std::to_string(c.height) + ", against " +
      (c.reference_kind == ReferenceKind::kPhong ? "classic Phong" : "spherical interpolation") +
      " in double precision.\n\n| shading |";
  std::string rule = "|---|";
  for (const Column& column : columns) {
    text += " " + column.title + " |";
    rule += "---:|";
  }
  text += "\n" + rule + "\n";
  for (const MethodFigures& method : c.methods) {
    text += "| " + method.shading + " |";
    for (const Column& column : columns) {
      text += " " + number_text(column.value(method), column.decimals, "-") + " |";
    }
    text += "\n";
  }
  return text + "\n" + kNotes;
}

std::string csv(const Comparison& c, const std::vector<Column>& columns) {
  std::string text = "shading";
  for (const Column& column : columns) text += "," + column.key;
  text += "\n";
  for (const MethodFigures& method : c.methods) {
    text += method.shading;
    for (const Column& column : columns) text += "," + number_text(column.value(method), 6, "");
    text += "\n";
  }
  return text;
}

std::string json(const Comparison& c, const std::vector<Column>& columns) {
  nlohmann::ordered_json methods = nlohmann::ordered_json::array();
  for (const MethodFigures& method : c.methods) {
    nlohmann::ordered_json entry = {{"shading", method.shading}};
    for (const Column& column : columns) {
      const std::optional<double> value = column.value(method);
      entry[column.key] = value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nullptr;
    }
    methods.push_back(entry);
  }
  const nlohmann::ordered_json all = {
      {"mesh", {{"name", c.mesh_name}, {"triangles", c.mesh_triangles}}},
      {"picture", {{"width", c.width}, {"height", c.height}}},
      {"reference", c.reference_kind == ReferenceKind::kPhong ? "phong" : "slerp"},
      {"methods", methods},
  };
  return all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace

TableFormat table_format(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".md") return TableFormat::kMarkdown;
  if (extension == ".csv") return TableFormat::kCsv;
  if (extension == ".json") return TableFormat::kJson;
  throw Failure(path.string(), "a table's name must end in .md, .csv or .json");
}

std::string comparison_table(const Comparison& comparison, TableFormat format) {
  const std::vector<Column> columns = all_columns(comparison);
  switch (format) {
    case TableFormat::kCsv:
      return csv(comparison, columns);
    case TableFormat::kJson:
      return json(comparison, columns);
    case TableFormat::kMarkdown:
      break;
  }
  return markdown(comparison, columns);
}

}  // namespace arcspan::tools
