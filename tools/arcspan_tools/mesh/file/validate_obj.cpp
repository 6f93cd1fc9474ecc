// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/file/validate.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <functional>
#include <set>
#include <utility>

namespace arcspan::tools {
namespace {

// The vertices and normals that a face may refer to: the whole file's counts (a face may stand before its
// vertices) and, for negative references, how many there were when its line came.
struct Counts {
  std::int64_t vertices = 0;
  std::int64_t texture = 0;
  std::int64_t normals = 0;
};

void count(Counts& counts, std::string_view keyword) {
  if (keyword == "v") ++counts.vertices;
  if (keyword == "vt") ++counts.texture;
  if (keyword == "vn") ++counts.normals;
}

Counts count_all(std::string_view text, const std::string& subject) {
  Counts counts;
  TextLines lines(text, subject, TextLines::Joining::kBackslash);
  while (lines.next()) {
    if (!lines.words().empty()) count(counts, lines.words()[0]);
  }
  return counts;
}

// A reference as a positive number; OBJ counts from 1, negative ones back from the last element so far.
std::int64_t resolve(const TextLines& lines, std::string_view text, std::int64_t so_far, std::int64_t total,
                     const char* what) {
  const std::optional<std::int64_t> value = parse_integer(text);
  if (!value) lines.fail(in_quotes(text) + " is not a " + what + " index");
  const std::int64_t index = *value < 0 ? so_far + 1 + *value : *value;
  if (index < 1 || index > total) {
    lines.fail(std::string(what) + " index out of range (" + std::to_string(*value) + "; there are " +
               std::to_string(total) + ")");
  }
  return index;
}

/// Statements of the file that would change the picture, for the warnings.
struct NotDrawn {
  bool materials = false;
  bool colours = false;
  bool flat_faces = false;
  bool surfaces = false;
  std::set<std::string, std::less<>> smooth_groups{};  ///< of faces without normals

  [[nodiscard]] std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    if (materials) all.emplace_back("materials (usemtl) are not drawn");
    if (colours) all.emplace_back("vertex colours are not drawn");
    if (flat_faces) all.emplace_back("faces that are not to be smoothed (s off) are drawn smooth");
    if (smooth_groups.size() > 1) all.emplace_back("edges between smoothing groups (s) are drawn smooth");
    if (surfaces) all.emplace_back("curves and free-form surfaces are not drawn");
    return all;
  }
};

struct ObjScreen {
  TextLines lines;
  Counts total;
  TriangleCount triangles;
  Counts so_far{};
  std::string out{};
  NotDrawn not_drawn{};
  std::string smooth_group{};  ///< empty before the first statement

  void note(std::string_view keyword) {
    constexpr std::size_t kWordsOfColouredVertex = 7;
    if (keyword == "usemtl") not_drawn.materials = true;
    if (keyword == "curv" || keyword == "curv2" || keyword == "surf") not_drawn.surfaces = true;
    if (keyword == "v" && lines.words().size() >= kWordsOfColouredVertex) not_drawn.colours = true;
    if (keyword == "s") smooth_group = lines.words().size() > 1 ? lines.words()[1] : "off";
  }

  // Normals of the file decide how smooth a face is, whatever its group.
  void note_face(bool has_normals) {
    if (has_normals || smooth_group.empty()) return;
    if (smooth_group == "off" || smooth_group == "0") {
      not_drawn.flat_faces = true;
    } else {
      not_drawn.smooth_groups.insert(smooth_group);
    }
  }

  void numbers(std::size_t wanted) {
    out += lines.words()[0];
    for (std::size_t i = 1; i <= wanted; ++i) {
      (void)lines.number_at(i);
      out += ' ';
      out += lines.words()[i];
    }
    out += '\n';
  }

  // One corner of a face: v, v/t, v//n or v/t/n; texture coordinates are checked and left out. Returns
  // whether it has a normal.
  bool corner(std::string_view word) {
    std::string_view part[3];
    std::size_t parts = 0;
    for (std::string_view rest = word; parts < 3; ++parts) {
      const std::size_t slash = rest.find('/');
      part[parts] = rest.substr(0, slash);
      if (slash == std::string_view::npos) break;
      if (parts == 2) lines.fail(in_quotes(word) + " is not a corner of a face");
      rest.remove_prefix(slash + 1);
    }
    out += ' ' + std::to_string(resolve(lines, part[0], so_far.vertices, total.vertices, "vertex"));
    if (!part[1].empty()) (void)resolve(lines, part[1], so_far.texture, total.texture, "texture");
    if (part[2].empty()) return false;
    out += "//" + std::to_string(resolve(lines, part[2], so_far.normals, total.normals, "normal"));
    return true;
  }

  void face() {
    if (lines.words().size() < 4) {
      lines.fail("a face needs three corners or more (this has " + std::to_string(lines.words().size() - 1) +
                 ")");
    }
    const auto corners = static_cast<std::int64_t>(lines.words().size() - 1);
    if (corners > kMostCorners) {
      lines.fail("a face has too many corners (" + std::to_string(corners) + "; the limit is " +
                 std::to_string(kMostCorners) + ")");
    }
    triangles.add_face(corners);
    out += 'f';
    bool has_normals = true;
    for (std::size_t i = 1; i < lines.words().size(); ++i)
      has_normals = corner(lines.words()[i]) && has_normals;
    out += '\n';
    note_face(has_normals);
  }
};

}  // namespace

ScreenedMesh screened_obj(std::string_view bytes, const std::string& subject) {
  const std::string text = plain_text(bytes);
  require_text(text, subject);
  ObjScreen screen{TextLines(text, subject, TextLines::Joining::kBackslash), count_all(text, subject),
                   TriangleCount(subject)};
  std::size_t faces = 0;
  while (screen.lines.next()) {
    if (screen.lines.words().empty()) continue;
    const std::string_view keyword = screen.lines.words()[0];
    count(screen.so_far, keyword);
    screen.note(keyword);
    if (keyword == "v" || keyword == "vn") screen.numbers(3);
    if (keyword != "f") continue;
    if (++faces > kMaxTriangles) {
      throw Failure(subject, "too many faces (more than " + std::to_string(kMaxTriangles) + ", the limit)");
    }
    screen.face();
  }
  if (screen.total.vertices == 0) throw Failure(subject, "not an OBJ mesh (no vertices)");
  if (faces == 0) throw Failure(subject, "no faces");
  return {std::move(screen.out), screen.not_drawn.warnings()};
}

}  // namespace arcspan::tools
