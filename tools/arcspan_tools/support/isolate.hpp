// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace arcspan::tools {

/// Runs `work` in a child process and hands its result back, so that no crash, endless loop or memory hunger
/// of a library takes this process down: each becomes a Failure about `subject`, and so does a Failure of
/// `work`. The child is killed when this process ends. It may have 512 MiB of memory, and more in proportion
/// to `input_bytes`.
[[nodiscard]] std::string run_isolated(const std::string& subject, std::size_t input_bytes,
                                       const std::function<std::string()>& work);

}  // namespace arcspan::tools
