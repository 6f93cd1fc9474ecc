// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/import.hpp>
#include <arcspan_tools/mesh/file/validate.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <string>

namespace arcspan::tools {

/// The triangles that the library made of a screened file, together with what was kept beside its text.
/// `subject` names the file in the Failure that is thrown if the two do not fit.
[[nodiscard]] RawModel assembled(ImportedMesh mesh, ScreenedMesh file, const std::string& subject);

}  // namespace arcspan::tools
