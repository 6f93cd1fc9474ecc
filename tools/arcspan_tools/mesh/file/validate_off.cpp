// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/file/validate.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <utility>

namespace arcspan::tools {
namespace {

/// The first word of an OFF file: [ST][C][N]OFF in either case. Without it a file is a plain OFF.
struct OffKeyword {
  bool texture = false;
  bool colours = false;
  bool normals = false;
};

bool take(std::string_view& word, std::string_view prefix) {
  if (!same_letters(word.substr(0, prefix.size()), prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

OffKeyword read_keyword(const TextLines& lines) {
  OffKeyword keyword;
  std::string_view word = lines.words()[0];
  keyword.texture = take(word, "ST");
  keyword.colours = take(word, "C");
  keyword.normals = word.size() > 3 && take(word, "N");
  if (same_letters(word, "4OFF") || same_letters(word, "nOFF") || same_letters(word, "4nOFF")) {
    lines.fail("only three dimensions can be read, not those of " + in_quotes(lines.words()[0]));
  }
  if (!same_letters(word, "OFF")) lines.fail("expected OFF, not " + in_quotes(lines.words()[0]));
  return keyword;
}

struct OffScreen {
  TextLines lines;
  TriangleCount triangles;
  OffKeyword keyword{};
  std::string out{};
  bool vertex_colours = false;
  bool face_colours = false;

  void vertex() {
    const std::size_t numbers = keyword.normals ? 6 : 3;
    for (std::size_t i = 0; i < numbers; ++i) {
      (void)lines.number_at(i);
      (out += lines.words()[i]) += i + 1 < numbers ? ' ' : '\n';
    }
    // Some programs write colours without announcing them.
    const bool has_three_more = !keyword.texture && lines.words().size() >= numbers + 3;
    vertex_colours = vertex_colours || keyword.colours || has_three_more;
  }

  void face(std::int64_t vertices) {
    const std::int64_t corners = lines.integer_at(0, 1, kMostCorners, "number of corners");
    triangles.add_face(corners);
    out += std::to_string(corners);
    for (std::int64_t i = 1; i <= corners; ++i) {
      out += ' ' +
             std::to_string(lines.integer_at(static_cast<std::size_t>(i), 0, vertices - 1, "vertex index"));
    }
    out += '\n';
    face_colours = face_colours || lines.words().size() > static_cast<std::size_t>(corners) + 1;
  }

  [[nodiscard]] std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    if (vertex_colours) all.emplace_back("vertex colours are not drawn");
    if (face_colours) all.emplace_back("face colours are not drawn");
    return all;
  }
};

}  // namespace

ScreenedMesh screened_off(std::string_view bytes, const std::string& subject) {
  const std::string text = plain_text(bytes);
  OffScreen screen{TextLines(text, subject), TriangleCount(subject)};
  TextLines& lines = screen.lines;
  lines.next_words("its header");
  std::size_t first = 0;
  if (lines.words().size() > 1 && same_letters(lines.words()[1], "BINARY")) {
    lines.fail("a binary OFF file cannot be read");
  }
  require_text(text, subject);
  if (!parse_integer(lines.words()[0])) {
    screen.keyword = read_keyword(lines);
    first = 1;
  }
  if (first == 1 && lines.words().size() == 1) {
    lines.next_words("its counts");
    first = 0;
  }
  // A file can hold more vertices than faces use; the limit on those is checked later.
  const std::int64_t most = static_cast<std::int64_t>(text.size());
  const std::int64_t vertices = lines.integer_at(first, 1, most, "vertex count");
  const std::int64_t faces = lines.integer_at(first + 1, 1, kMaxTriangles, "face count");
  screen.out = screen.keyword.normals ? "NOFF\n" : "OFF\n";
  screen.out += std::to_string(vertices) + ' ' + std::to_string(faces) + " 0\n";
  for (std::int64_t v = 0; v < vertices; ++v) {
    lines.next_words("vertex " + std::to_string(v + 1) + " of " + std::to_string(vertices));
    screen.vertex();
  }
  for (std::int64_t f = 0; f < faces; ++f) {
    lines.next_words("face " + std::to_string(f + 1) + " of " + std::to_string(faces));
    screen.face(vertices);
  }
  return {std::move(screen.out), MeshFormat::kOff, screen.warnings()};
}

}  // namespace arcspan::tools
