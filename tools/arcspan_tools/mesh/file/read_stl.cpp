// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/element_text.hpp>
#include <arcspan_tools/mesh/file/file_mesh.hpp>
#include <arcspan_tools/mesh/file/read_mesh.hpp>

#include <bit>

namespace arcspan::tools {
namespace {

constexpr std::size_t kStlHeaderBytes = 80;
constexpr std::size_t kFacetBytes = 50;

std::uint32_t little_u32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

std::size_t size_of(std::uint64_t facets) { return kStlHeaderBytes + 4 + kFacetBytes * facets; }

void add_facet(FileMesh& mesh) {
  const auto next = static_cast<std::uint32_t>(mesh.position_count());
  mesh.add_face(std::vector<FileMesh::Corner>{{next - 3}, {next - 2}, {next - 1}}, {});
}

// Two conventions: "COLOR=" in the header (Magics), or bit 15 of the last two bytes of a facet (VisCAM).
void count_colours(std::string_view bytes, std::uint32_t facets, LeftOut& left_out) {
  const bool all = bytes.substr(0, kStlHeaderBytes).find("COLOR=") != std::string_view::npos;
  std::size_t coloured = 0;
  for (std::size_t f = 1; f <= facets; ++f) {
    if (all || (bytes[size_of(f) - 1] & 0x80) != 0) ++coloured;
  }
  left_out.add("face colours", coloured);
}

// 80 bytes of header, a count, then per facet a normal, three corners (float32) and two bytes of colour. The
// normal is that of the facet: taken for one of vertices it would shade every mesh flat.
RawModel read_binary(std::string_view bytes, const std::string& subject) {
  const std::uint32_t facets = little_u32(bytes, kStlHeaderBytes);
  if (facets > kMaxTriangles) {
    throw Failure(subject, "too many triangles (" + std::to_string(facets) + "; the limit is " +
                               std::to_string(kMaxTriangles) + ")");
  }
  if (bytes.size() < size_of(facets)) {
    throw Failure(subject, "truncated (" + std::to_string(bytes.size()) + " bytes of " +
                               std::to_string(size_of(facets)) + " for " + std::to_string(facets) +
                               " triangles)");
  }
  FileMesh mesh(subject);
  for (std::size_t f = 0; f < facets; ++f) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      const auto number = [&](std::size_t i) {
        return double{std::bit_cast<float>(little_u32(bytes, size_of(f) + 12 * corner + 4 * i))};
      };
      mesh.add_position([&] {
        const Vec3 position{number(0), number(1), number(2)};
        if (is_coordinate(position)) return position;
        throw Failure(subject,
                      "a coordinate of triangle " + std::to_string(f + 1) + " is not a finite number");
      });
    }
    add_facet(mesh);
  }
  count_colours(bytes, facets, mesh.left_out);
  mesh.left_out.add("bytes after the last of " + std::to_string(facets) + " triangles",
                    bytes.size() - size_of(facets));
  return mesh.model();
}

void read_facet(ElementText& text, FileMesh& mesh) {
  text.expect("normal");
  for (int i = 0; i < 3; ++i) (void)text.word();  // some programs write NaN for a facet without area
  text.expect("outer");
  text.expect("loop");
  for (int corner = 0; corner < 3; ++corner) {
    text.expect("vertex");
    text.read_triple();
    mesh.add_position([&text] { return text.triple(); });
  }
  text.expect("endloop");
  text.expect("endfacet");
  add_facet(mesh);
}

RawModel read_text(TextLines& lines, const std::string& subject) {
  ElementText text(lines, ElementText::Breaks::kAnywhere);
  FileMesh mesh(subject);
  bool open = false;
  for (std::size_t facets = 0; text.has_more();) {
    const std::string_view keyword = text.word();
    if (same_letters(keyword, "solid") || same_letters(keyword, "endsolid")) {
      open = keyword.size() == 5;
      text.skip_to("facet", "normal");  // over a name
    } else if (same_letters(keyword, "facet")) {
      text.begin("the rest of facet " + std::to_string(++facets));
      read_facet(text, mesh);
    } else {
      lines.fail("expected 'facet', not " + in_quotes(keyword));
    }
  }
  if (open) lines.fail("the file ends before endsolid");
  return mesh.model();
}

}  // namespace

RawModel read_stl(std::string_view bytes, const std::string& subject) {
  // A binary file may start with "solid", too. Its exact size decides first, then the upper byte of its
  // count, which is 0 in every file that is not too large and nowhere in a text.
  const bool has_count = bytes.size() >= kStlHeaderBytes + 4;
  const bool exact = has_count && bytes.size() == size_of(little_u32(bytes, kStlHeaderBytes));
  const bool is_utf16 = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
  const bool can_be_text = !has_count || is_utf16 || bytes[kStlHeaderBytes + 3] != 0;
  if (exact || !can_be_text) return read_binary(bytes, subject);
  const std::string text = plain_text(bytes);
  TextLines lines(text, subject);
  while (lines.words().empty() && lines.next()) {
  }
  if (lines.words().empty() || !same_letters(lines.words()[0], "solid")) {
    throw Failure(subject, "not an STL mesh (neither text that begins with 'solid' nor binary)");
  }
  require_text(text, subject);
  return read_text(lines, subject);
}

}  // namespace arcspan::tools
