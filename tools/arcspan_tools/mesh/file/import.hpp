// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/load.hpp>

#include <string>
#include <string_view>

namespace arcspan::tools {

/// Reads screened mesh bytes (see screen.hpp) with the loader library. Polygons are triangulated; points and
/// lines are ignored. The only file of this project that knows the library.
[[nodiscard]] RawMesh import_mesh(std::string_view screened, MeshFormat format, const std::string& subject);

}  // namespace arcspan::tools
