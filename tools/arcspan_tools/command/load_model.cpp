// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/support/printable.hpp>

#include <cstdio>

namespace arcspan::tools {

Model load_model(const std::string& name, const std::optional<double>& crease_degrees) {
  Model model = load_model_file(name);
  for (const std::string& warning : model.warnings) warn(name, warning);
  return crease_degrees ? with_crease(model, *crease_degrees, name) : model;
}

void warn(const std::string& subject, const std::string& text) {
  std::fprintf(stderr, "arcspan: warning: %s\n", printable(subject + ": " + text).c_str());
}

}  // namespace arcspan::tools
