// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/element_text.hpp>
#include <arcspan_tools/mesh/file/file_mesh.hpp>
#include <arcspan_tools/mesh/file/read_mesh.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <algorithm>

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

/// Whether each element has a line of its own, which may hold more than the file announces.
bool has_own_lines(TextLines lines, std::int64_t vertices, std::int64_t faces, const OffKeyword& keyword) {
  const auto of_vertex = [&keyword](const auto&) -> std::size_t { return keyword.normals ? 6 : 3; };
  const auto of_face = [](const std::vector<std::string_view>& words) -> std::size_t {
    return 1u + static_cast<std::size_t>(
                    std::clamp<std::int64_t>(parse_integer(words[0]).value_or(0), 0, kMostCorners));
  };
  return has_lines(lines, vertices, of_vertex) && has_lines(lines, faces, of_face);
}

void read_vertex(ElementText& text, const OffKeyword& keyword, FileMesh& mesh) {
  text.read_triple();
  mesh.add_position([&text] { return text.triple(); });
  if (keyword.normals) {
    text.read_triple();
    mesh.normals.push_back(mesh.if_right(kWrongNormals, [&text] { return text.triple(); }));
  }
  // Some programs write colours without announcing them.
  const bool more = text.has_own_lines() && !keyword.texture && text.left_on_line() >= 3;
  if (keyword.colours || more) mesh.left_out.add("vertex colours");
  const int others = (keyword.colours ? 4 : 0) + (keyword.texture ? 2 : 0);
  for (int i = 0; i < others && !text.has_own_lines(); ++i) (void)text.word();
}

void read_face(ElementText& text, const OffKeyword& keyword, FileMesh& mesh) {
  std::vector<FileMesh::Corner> corners(
      static_cast<std::size_t>(text.integer(0, kMostCorners, "number of corners")));
  const auto vertices = static_cast<std::int64_t>(mesh.position_count());
  for (FileMesh::Corner& corner : corners) {
    corner.position = static_cast<std::uint32_t>(text.integer(0, vertices - 1, "vertex index"));
    if (keyword.normals) corner.normal = corner.position;
  }
  mesh.add_face(corners, {});
  if (text.has_own_lines() && text.left_on_line() > 0) mesh.left_out.add("face colours");
}

}  // namespace

RawModel read_off(std::string_view bytes, const std::string& subject) {
  const std::string plain = plain_text(bytes);
  TextLines lines(plain, subject);
  lines.next_words("its header");
  if (lines.words().size() > 1 && same_letters(lines.words()[1], "BINARY")) {
    lines.fail("a binary OFF file cannot be read");
  }
  require_text(plain, subject);
  OffKeyword keyword;
  std::size_t used = 0;
  if (!parse_integer(lines.words()[0])) {
    keyword = read_keyword(lines);
    used = 1;
  }
  ElementText header(lines, ElementText::Breaks::kAnywhere, used);
  header.begin("its counts");
  // A file can hold more vertices than faces use; the limit on those is checked later.
  const std::int64_t vertices = header.integer(1, static_cast<std::int64_t>(plain.size()), "vertex count");
  const std::int64_t faces = header.integer(1, kMaxTriangles, "face count");
  if (header.left_on_line() > 0) (void)header.word();  // the number of edges, which some programs leave out
  const std::size_t left = header.left_on_line();
  ElementText text(lines,
                   left == 0 && has_own_lines(lines, vertices, faces, keyword)
                       ? ElementText::Breaks::kAfterElements
                       : ElementText::Breaks::kAnywhere,
                   lines.words().size() - left);
  FileMesh mesh(subject);
  for (std::int64_t v = 1; v <= vertices; ++v) {
    text.begin("vertex " + std::to_string(v) + " of " + std::to_string(vertices));
    read_vertex(text, keyword, mesh);
  }
  for (std::int64_t f = 1; f <= faces; ++f) {
    text.begin("face " + std::to_string(f) + " of " + std::to_string(faces));
    read_face(text, keyword, mesh);
  }
  text.end();
  return mesh.model();
}

}  // namespace arcspan::tools
