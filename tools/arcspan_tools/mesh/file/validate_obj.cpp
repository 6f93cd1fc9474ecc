// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/colour_scale.hpp>
#include <arcspan_tools/mesh/file/obj_looks.hpp>
#include <arcspan_tools/mesh/file/tagged_obj.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/file/validate.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <functional>
#include <map>
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

/// Words of `v` with a colour: x, y, z, red, green and blue.
constexpr std::size_t kWordsOfColouredVertex = 7;

/// What is known of a file before its faces are read.
struct Overview {
  Counts total{};
  bool tagged = false;  ///< whether faces may differ in more than their corners
};

void count(Counts& counts, std::string_view keyword) {
  if (keyword == "v") ++counts.vertices;
  if (keyword == "vt") ++counts.texture;
  if (keyword == "vn") ++counts.normals;
}

Overview overview_of(std::string_view text, const std::string& subject) {
  Overview overview;
  TextLines lines(text, subject, TextLines::Joining::kBackslash);
  while (lines.next()) {
    if (lines.words().empty()) continue;
    const std::string_view keyword = lines.words()[0];
    count(overview.total, keyword);
    const bool coloured = keyword == "v" && lines.words().size() >= kWordsOfColouredVertex;
    const bool divides =
        keyword == "o" || keyword == "g" || keyword == "s" || keyword == "usemtl" || keyword == "vt";
    overview.tagged = overview.tagged || coloured || divides;
  }
  return overview;
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

struct ObjScreen {
  TextLines lines;
  Counts total;
  TaggedObj out;
  TriangleCount triangles;
  Counts so_far{};
  ObjLooks looks{};
  std::vector<FaceTag> faces{};
  std::vector<std::optional<Vec3>> colours{};
  std::vector<Uv> texture_points{};
  /// Numbers of the pairs of a vertex and a texture point that corners have, both from 1; 0 is no point.
  std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> pairs{};
  std::uint32_t smoothing = RawMesh::kSmooth;
  std::map<std::string, std::uint32_t, std::less<>> smoothing_groups{};
  bool surfaces = false;  ///< whether there are any

  void statement(std::string_view keyword) {
    looks.note(lines);
    if (keyword == "v" || keyword == "vn") numbers(keyword);
    if (keyword == "v" && out.tagged()) colours.push_back(vertex_colour());
    if (keyword == "vt") texture_points.push_back(texture_point());
    if (keyword == "s") smoothing = smoothing_group();
    if (keyword == "curv" || keyword == "curv2" || keyword == "surf") surfaces = true;
    if (keyword == "f") face();
  }

  void numbers(std::string_view keyword) {
    std::string line(keyword);
    for (std::size_t i = 1; i <= 3; ++i) {
      (void)lines.number_at(i);
      (line += ' ') += lines.words()[i];
    }
    out.line(line);
  }

  [[nodiscard]] std::optional<Vec3> vertex_colour() const {
    if (lines.words().size() < kWordsOfColouredVertex) return std::nullopt;
    return Vec3{lines.number_at(4), lines.number_at(5), lines.number_at(6)};
  }

  // A single number is a point of a texture with one row. OBJ's v is up.
  [[nodiscard]] Uv texture_point() const {
    return {lines.number_at(1), lines.words().size() > 2 ? 1 - lines.number_at(2) : 0};
  }

  // "s off" and "s 0" are flat. Faces before the first statement are a group of their own.
  std::uint32_t smoothing_group() {
    const std::string_view name = lines.words().size() > 1 ? lines.words()[1] : "off";
    if (name == "off" || name == "0") return RawMesh::kFlat;
    const auto next = static_cast<std::uint32_t>(RawMesh::kSmooth + 1 + smoothing_groups.size());
    return smoothing_groups.try_emplace(std::string(name), next).first->second;
  }

  // One corner of a face: v, v/t, v//n or v/t/n.
  void corner(std::string_view word) {
    std::string_view part[3];
    std::size_t parts = 0;
    for (std::string_view rest = word; parts < 3; ++parts) {
      const std::size_t slash = rest.find('/');
      part[parts] = rest.substr(0, slash);
      if (slash == std::string_view::npos) break;
      if (parts == 2) lines.fail(in_quotes(word) + " is not a corner of a face");
      rest.remove_prefix(slash + 1);
    }
    const std::int64_t vertex = resolve(lines, part[0], so_far.vertices, total.vertices, "vertex");
    const std::int64_t point =
        part[1].empty() ? 0 : resolve(lines, part[1], so_far.texture, total.texture, "texture");
    const std::int64_t normal =
        part[2].empty() ? 0 : resolve(lines, part[2], so_far.normals, total.normals, "normal");
    const auto next = static_cast<std::int64_t>(pairs.size());
    out.corner(vertex, normal, out.tagged() ? pairs.try_emplace({vertex, point}, next).first->second : 0);
  }

  /// The colours and texture points of the pairs, by their numbers.
  void finish(ScreenedMesh& result) {
    const std::vector<std::optional<Vec3>> of_vertices = scaled_colours(std::move(colours));
    if (!of_vertices.empty()) result.vertex_colours.resize(pairs.size());
    if (!texture_points.empty()) result.texture_points.resize(pairs.size());
    for (const auto& [pair, number] : pairs) {
      const auto at = static_cast<std::size_t>(number);
      if (!of_vertices.empty()) {
        result.vertex_colours[at] = of_vertices[static_cast<std::size_t>(pair.first - 1)];
      }
      if (pair.second > 0) {
        result.texture_points[at] = texture_points[static_cast<std::size_t>(pair.second - 1)];
      }
    }
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
    for (std::size_t i = 1; i < lines.words().size(); ++i) corner(lines.words()[i]);
    out.end_face();
    if (out.tagged()) faces.push_back({looks.current(), smoothing, {}});
  }
};

}  // namespace

ScreenedMesh screened_obj(std::string_view bytes, const std::string& subject, const SideFiles& files) {
  const std::string text = plain_text(bytes);
  require_text(text, subject);
  const Overview overview = overview_of(text, subject);
  ObjScreen screen{TextLines(text, subject, TextLines::Joining::kBackslash), overview.total,
                   TaggedObj(overview.tagged), TriangleCount(subject)};
  while (screen.lines.next()) {
    if (screen.lines.words().empty()) continue;
    const std::string_view keyword = screen.lines.words()[0];
    count(screen.so_far, keyword);
    if (keyword == "f" && screen.out.faces() == static_cast<std::int64_t>(kMaxTriangles)) {
      throw Failure(subject, "too many faces (more than " + std::to_string(kMaxTriangles) + ", the limit)");
    }
    screen.statement(keyword);
  }
  if (screen.total.vertices == 0) throw Failure(subject, "not an OBJ mesh (no vertices)");
  if (screen.out.faces() == 0) throw Failure(subject, "no faces");
  ScreenedMesh result{screen.out.text(), MeshFormat::kObj};
  if (screen.surfaces) result.warnings.emplace_back("curves and free-form surfaces are not drawn");
  if (!screen.out.tagged()) return result;
  result.looks = screen.looks.finish(files, result.warnings);
  result.faces = std::move(screen.faces);
  screen.finish(result);
  return result;
}

}  // namespace arcspan::tools
