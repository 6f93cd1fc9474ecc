// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/file/validate.hpp>
#include <arcspan_tools/support/failure.hpp>

namespace arcspan::tools {
std::string screened_off(std::string_view bytes, const std::string& subject) {
  const std::string text = plain_text(bytes);
  require_text(text, subject);
  TextLines lines(text, subject);
  lines.next_words("its header");
  if (lines.words()[0] != "OFF") lines.fail("expected OFF, not " + in_quotes(lines.words()[0]));
  std::string out = "OFF\n";
  std::size_t first = 1;
  if (lines.words().size() == 1) {
    lines.next_words("its counts");
    first = 0;
  }
  // A file can hold more vertices than faces use; the limit on those is checked later.
  const std::int64_t most = static_cast<std::int64_t>(text.size());
  const std::int64_t vertices = lines.integer_at(first, 1, most, "vertex count");
  const std::int64_t faces = lines.integer_at(first + 1, 1, kMaxTriangles, "face count");
  out += std::to_string(vertices) + ' ' + std::to_string(faces) + " 0\n";
  for (std::int64_t v = 0; v < vertices; ++v) {
    lines.next_words("vertex " + std::to_string(v + 1) + " of " + std::to_string(vertices));
    for (std::size_t i = 0; i < 3; ++i) {
      (void)lines.number_at(i);
      (out += lines.words()[i]) += i < 2 ? ' ' : '\n';
    }
  }
  for (std::int64_t f = 0; f < faces; ++f) {
    lines.next_words("face " + std::to_string(f + 1) + " of " + std::to_string(faces));
    const std::int64_t corners = lines.integer_at(0, 1, kMostCorners, "number of corners");
    out += std::to_string(corners);
    for (std::int64_t i = 1; i <= corners; ++i) {
      out += ' ' +
             std::to_string(lines.integer_at(static_cast<std::size_t>(i), 0, vertices - 1, "vertex index"));
    }
    out += '\n';
  }
  return out;
}

}  // namespace arcspan::tools
