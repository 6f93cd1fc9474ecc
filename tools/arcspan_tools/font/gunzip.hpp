// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace arcspan::tools {

/// Whether bytes begin as a gzip file does.
[[nodiscard]] bool is_gzip(std::string_view bytes);

/// The content of a gzip file (RFC 1952) of one member, at most `limit` bytes. Throws a Failure about
/// `subject`.
[[nodiscard]] std::string gunzip(std::string_view bytes, std::size_t limit, const std::string& subject);

}  // namespace arcspan::tools
