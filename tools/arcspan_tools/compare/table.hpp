// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/compare/comparison.hpp>

#include <filesystem>
#include <string>

namespace arcspan::tools {

enum class TableFormat : std::uint8_t { kMarkdown, kCsv, kJson };

/// The format that a file name asks for: .md, .csv or .json. Throws Failure for any other extension.
[[nodiscard]] TableFormat table_format(const std::filesystem::path& path);

/// The figures of all methods. Markdown for people, with rounded figures and a note of what they are; CSV
/// with a head line and JSON with everything. What could not be measured is `-`, empty, or null.
[[nodiscard]] std::string comparison_table(const Comparison& comparison, TableFormat format);

}  // namespace arcspan::tools
