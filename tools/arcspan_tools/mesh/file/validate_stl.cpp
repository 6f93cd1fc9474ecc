// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/file/validate.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <bit>
#include <cmath>

namespace arcspan::tools {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kFacetBytes = 50;

std::uint32_t little_u32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

void check_facet_count(std::uint64_t count, const std::string& subject) {
  if (count == 0) throw Failure(subject, "no faces");
  if (count > kMaxTriangles) {
    throw Failure(subject, "too many triangles (" + std::to_string(count) + "; the limit is " +
                               std::to_string(kMaxTriangles) + ")");
  }
}

// Two conventions: "COLOR=" in the header (Magics), or bit 15 of the last two bytes of a facet (VisCAM).
bool has_colours(std::string_view bytes, std::uint32_t facets) {
  if (bytes.substr(0, kHeaderBytes).find("COLOR=") != std::string_view::npos) return true;
  for (std::size_t f = 0; f < facets; ++f) {
    if ((bytes[kHeaderBytes + 4 + f * kFacetBytes + kFacetBytes - 1] & 0x80) != 0) return true;
  }
  return false;
}

// 80 bytes of header, a count, then per facet a normal, three corners (float32) and two bytes of colour.
ScreenedMesh screened_binary(std::string_view bytes, const std::string& subject) {
  const std::uint32_t facets = little_u32(bytes, kHeaderBytes);
  check_facet_count(facets, subject);
  const std::uint64_t wanted = kHeaderBytes + 4 + std::uint64_t{kFacetBytes} * facets;
  if (bytes.size() < wanted) {
    throw Failure(subject, "truncated (" + std::to_string(bytes.size()) + " bytes of " +
                               std::to_string(wanted) + " for " + std::to_string(facets) + " triangles)");
  }
  for (std::size_t f = 0; f < facets; ++f) {
    for (std::size_t i = 3; i < 12; ++i) {
      const std::size_t at = kHeaderBytes + 4 + f * kFacetBytes + 4 * i;
      const float value = std::bit_cast<float>(little_u32(bytes, at));
      if (!std::isfinite(value)) {
        throw Failure(subject, "a coordinate of triangle " + std::to_string(f) + " is not a finite number");
      }
    }
  }
  // A blank header: one that says "solid" or "COLOR=" would send the library elsewhere.
  return {std::string(kHeaderBytes, '\0') + std::string(bytes.substr(kHeaderBytes, wanted - kHeaderBytes)),
          MeshFormat::kStl,
          has_colours(bytes, facets) ? std::vector<std::string>{"face colours are not drawn"}
                                     : std::vector<std::string>{}};
}

void expect(const TextLines& lines, std::size_t i, std::string_view word) {
  if (i < lines.words().size() && same_letters(lines.words()[i], word)) return;
  lines.fail("expected '" + std::string(word) + "'" +
             (i < lines.words().size() ? ", not " + in_quotes(lines.words()[i]) : ""));
}

void copy_numbers(const TextLines& lines, std::size_t first, std::string& out) {
  for (std::size_t i = first; i < first + 3; ++i) {
    (void)lines.number_at(i);
    (out += ' ') += lines.words()[i];
  }
  out += '\n';
}

void validate_facet(TextLines& lines, std::string& out) {
  expect(lines, 1, "normal");
  // Normals of facets are not used; some programs write NaN for a facet without area.
  out += "facet normal 0 0 0\n outer loop\n";
  lines.next_words("outer loop");
  expect(lines, 0, "outer");
  for (int corner = 0; corner < 3; ++corner) {
    lines.next_words("the facet's third vertex");
    expect(lines, 0, "vertex");
    out += "  vertex";
    copy_numbers(lines, 1, out);
  }
  lines.next_words("endloop");
  expect(lines, 0, "endloop");
  lines.next_words("endfacet");
  expect(lines, 0, "endfacet");
  out += " endloop\nendfacet\n";
}

ScreenedMesh screened_ascii(std::string_view bytes, const std::string& subject) {
  require_text(bytes, subject);
  TextLines lines(bytes, subject);
  std::string out = "solid mesh\n";
  std::uint64_t facets = 0;
  bool open = false;
  while (lines.next()) {
    if (lines.words().empty()) continue;
    const std::string_view keyword = lines.words()[0];
    if (same_letters(keyword, "solid")) {
      open = true;
    } else if (same_letters(keyword, "endsolid")) {
      open = false;
    } else {
      expect(lines, 0, "facet");
      validate_facet(lines, out);
      check_facet_count(++facets, subject);
    }
  }
  if (open) lines.fail("the file ends before endsolid");
  check_facet_count(facets, subject);
  return {out + "endsolid mesh\n", MeshFormat::kStl};
}

}  // namespace

ScreenedMesh screened_stl(std::string_view bytes, const std::string& subject) {
  // A binary file may start with "solid", too. Its exact size decides first, then the upper byte of its
  // count, which is 0 in every file that is not too large and nowhere in a text.
  const bool has_count = bytes.size() >= kHeaderBytes + 4;
  const bool exact =
      has_count &&
      bytes.size() == kHeaderBytes + 4 + std::uint64_t{kFacetBytes} * little_u32(bytes, kHeaderBytes);
  const bool is_utf16 = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
  const bool can_be_text = !has_count || is_utf16 || bytes[kHeaderBytes + 3] != 0;
  if (exact || !can_be_text) return screened_binary(bytes, subject);
  const std::string text = plain_text(bytes);
  TextLines lines(text, subject);
  while (lines.words().empty() && lines.next()) {
  }
  if (!lines.words().empty() && same_letters(lines.words()[0], "solid")) return screened_ascii(text, subject);
  throw Failure(subject, "not an STL mesh (neither text that begins with 'solid' nor binary)");
}

}  // namespace arcspan::tools
