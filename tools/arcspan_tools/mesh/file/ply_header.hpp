// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/text_lines.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// A number type of PLY: its size in bytes and how its bits are to be read.
struct PlyType {
  enum class Kind : std::uint8_t { kSigned, kUnsigned, kFloat };
  Kind kind = Kind::kSigned;
  std::uint8_t bytes = 1;
};

struct PlyProperty {
  std::string name;
  PlyType type;
  /// Set for a list: the type of its length.
  std::optional<PlyType> count_type;
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding : std::uint8_t { kText, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kText;
  std::vector<PlyElement> elements;
};

/// Reads the header up to and with `end_header`, leaving `lines` at the body. Throws Failure.
[[nodiscard]] PlyHeader read_ply_header(TextLines& lines);

}  // namespace arcspan::tools
