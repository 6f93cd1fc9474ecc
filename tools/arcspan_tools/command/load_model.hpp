// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/mesh_data.hpp>

#include <string>

namespace arcspan::tools {

/// load_mesh(), and its warnings on standard error.
[[nodiscard]] MeshData load_model(const std::string& name);

/// Prints the line `arcspan: warning: SUBJECT: TEXT` on standard error.
void warn(const std::string& subject, const std::string& text);

}  // namespace arcspan::tools
