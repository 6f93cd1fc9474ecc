// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace arcspan::tools {

/// The bytes that a text in base64 (RFC 4648) stands for; nothing if it is none. Padding may be missing.
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

}  // namespace arcspan::tools
