// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>

#include <optional>
#include <string>

namespace arcspan::tools {

/// load_model_file(), and its warnings on standard error. With `crease_degrees` the normals are made anew:
/// see with_crease().
[[nodiscard]] Model load_model(const std::string& name, const std::optional<double>& crease_degrees = {});

/// Prints the line `arcspan: warning: SUBJECT: TEXT` on standard error.
void warn(const std::string& subject, const std::string& text);

}  // namespace arcspan::tools
