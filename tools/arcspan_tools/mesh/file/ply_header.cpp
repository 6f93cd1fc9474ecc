// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/ply_header.hpp>

#include <limits>

namespace arcspan::tools {
namespace {

PlyType type_at(const TextLines& lines, std::size_t i) {
  using Kind = PlyType::Kind;
  struct Named {
    std::string_view name;
    std::string_view other_name;
    PlyType type;
  };
  static constexpr Named kTypes[] = {
      {"char", "int8", {Kind::kSigned, 1}},    {"uchar", "uint8", {Kind::kUnsigned, 1}},
      {"short", "int16", {Kind::kSigned, 2}},  {"ushort", "uint16", {Kind::kUnsigned, 2}},
      {"int", "int32", {Kind::kSigned, 4}},    {"uint", "uint32", {Kind::kUnsigned, 4}},
      {"float", "float32", {Kind::kFloat, 4}}, {"double", "float64", {Kind::kFloat, 8}},
  };
  if (i >= lines.words().size()) lines.fail("the type of a property is missing");
  for (const Named& t : kTypes) {
    if (lines.words()[i] == t.name || lines.words()[i] == t.other_name) return t.type;
  }
  lines.fail(in_quotes(lines.words()[i]) + " is not a type");
}

PlyEncoding encoding_of(const TextLines& lines) {
  const std::string_view name = lines.words().size() > 1 ? lines.words()[1] : "";
  if (name == "ascii") return PlyEncoding::kText;
  if (name == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (name == "binary_big_endian") return PlyEncoding::kBigEndian;
  lines.fail(in_quotes(name) + " is not a format");
}

PlyProperty property_of(const TextLines& lines) {
  const std::vector<std::string_view>& words = lines.words();
  PlyProperty property;
  const bool is_list = words.size() > 1 && words[1] == "list";
  if (is_list) {
    property.count_type = type_at(lines, 2);
    if (property.count_type->kind == PlyType::Kind::kFloat) lines.fail("a list's length must be an integer");
  }
  const std::size_t type = is_list ? 3 : 1;
  property.type = type_at(lines, type);
  if (words.size() <= type + 1) lines.fail("the name of a property is missing");
  property.name = words[type + 1];
  return property;
}

}  // namespace

PlyHeader read_ply_header(TextLines& lines) {
  constexpr std::size_t kMostProperties = 1000;
  PlyHeader header;
  if (!lines.next() || lines.words().empty() || lines.words()[0] != "ply") lines.fail("expected 'ply'");
  lines.next_words("its format");
  if (lines.words()[0] != "format") lines.fail("expected 'format', not " + in_quotes(lines.words()[0]));
  header.encoding = encoding_of(lines);
  for (std::size_t properties = 0;;) {
    lines.next_words("end_header");
    const std::string_view keyword = lines.words()[0];
    if (keyword == "end_header") return header;
    if (keyword == "element") {
      if (lines.words().size() < 2) lines.fail("the name of an element is missing");
      const std::int64_t count =
          lines.integer_at(2, 0, std::numeric_limits<std::int32_t>::max(), "number of elements");
      header.elements.push_back({std::string(lines.words()[1]), count, {}});
    } else if (keyword == "property") {
      if (header.elements.empty()) lines.fail("a property before any element");
      if (++properties > kMostProperties) lines.fail("too many properties");
      header.elements.back().properties.push_back(property_of(lines));
    }
    // Anything else is a comment: some exporters write theirs without the keyword.
  }
}

}  // namespace arcspan::tools
