// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/load_model.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/support/printable.hpp>

#include <cstdio>

namespace arcspan::tools {

MeshData load_model(const std::string& name) {
  MeshData mesh = load_mesh(name);
  for (const std::string& warning : mesh.warnings) warn(name, warning);
  return mesh;
}

void warn(const std::string& subject, const std::string& text) {
  std::fprintf(stderr, "arcspan: warning: %s\n", printable(subject + ": " + text).c_str());
}

}  // namespace arcspan::tools
