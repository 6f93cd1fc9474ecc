// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/import.hpp>

#include <functional>
#include <string>

namespace arcspan::tools {

/// Runs `import` in a child process and hands its mesh back, so that no crash, endless loop or memory hunger
/// of a loader library takes this process down: each becomes a Failure about `subject`. The child is killed
/// when this process ends. `received` is called with the number of bytes that have come back so far, ten
/// times a second or more often.
[[nodiscard]] ImportedMesh run_isolated(const std::string& subject,
                                        const std::function<ImportedMesh()>& import,
                                        const std::function<void(std::size_t)>& received);

}  // namespace arcspan::tools
