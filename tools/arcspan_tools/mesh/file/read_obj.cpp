// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/file_mesh.hpp>
#include <arcspan_tools/mesh/file/obj_looks.hpp>
#include <arcspan_tools/mesh/file/read_mesh.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <functional>
#include <map>
#include <utility>

namespace arcspan::tools {
namespace {

/// The elements that a corner may refer to: those of the whole file, because a face may stand before its
/// vertices, or, for negative references, those before its line.
struct Counts {
  std::int64_t vertices = 0;
  std::int64_t texture = 0;
  std::int64_t normals = 0;

  void add(std::string_view keyword) {
    if (keyword == "v") ++vertices;
    if (keyword == "vt") ++texture;
    if (keyword == "vn") ++normals;
  }
};

/// Words of `v` with a colour: x, y, z, red, green and blue.
constexpr std::size_t kWordsOfColouredVertex = 7;

/// The index, from 0, of what a part of a corner refers to: from 1 on, or negative, back from the last
/// element so far. Nothing if there is no such element.
std::optional<std::uint32_t> index_of(std::string_view text, std::int64_t so_far, std::int64_t total) {
  const std::optional<std::int64_t> value = parse_integer(text);
  if (!value || *value == 0 || *value > total || *value < -so_far) return std::nullopt;
  return static_cast<std::uint32_t>(*value < 0 ? so_far + *value : *value - 1);
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& subject, const SideFiles& files)
      : lines_(text, subject, TextLines::Joining::kBackslash), mesh_(subject) {
    std::vector<Readings> libraries;
    TextLines lines = lines_;
    while (lines.next()) {
      if (lines.words().empty()) continue;
      total_.add(lines.words()[0]);
      if (lines.words()[0] == "mtllib") libraries.push_back(lines.name());
    }
    if (total_.vertices == 0) throw Failure(subject, "not an OBJ mesh (no vertices)");
    looks_.read_libraries(libraries, files);
  }

  RawModel read(const SideFiles& files) {
    while (lines_.next()) {
      if (!lines_.words().empty()) statement(lines_.words()[0]);
    }
    std::vector<std::string> warnings;
    std::vector<PartLook> looks = looks_.finish(files, warnings);
    return mesh_.model(std::move(looks), std::move(warnings));
  }

 private:
  void statement(std::string_view keyword) {
    so_far_.add(keyword);
    looks_.note(lines_);
    if (keyword == "v") {
      vertex();
    } else if (keyword == "vn") {
      mesh_.normals.push_back(mesh_.if_right(kWrongNormals, [this] { return triple(1); }));
    } else if (keyword == "vt") {
      mesh_.texture_points.push_back(mesh_.if_right(kWrongTexturePoints, [this] { return texture_point(); }));
    } else if (keyword == "s") {
      smoothing_ = smoothing_group();
    } else if (keyword == "f" || keyword == "fo") {
      face();
    } else if (keyword == "l" || keyword == "p") {
      mesh_.left_out.add("lines and points");
    } else if (keyword == "curv" || keyword == "curv2" || keyword == "surf") {
      mesh_.left_out.add("curves and free-form surfaces");
    }
  }

  [[nodiscard]] Vec3 triple(std::size_t first) const {
    return {lines_.number_at(first), lines_.number_at(first + 1), lines_.number_at(first + 2)};
  }

  void vertex() {
    mesh_.add_position([this] { return triple(1); });
    const bool coloured = lines_.words().size() >= kWordsOfColouredVertex;
    if (!coloured && mesh_.colours.empty()) return;
    mesh_.colours.resize(mesh_.position_count());
    if (coloured) mesh_.colours.back() = mesh_.if_right(kWrongColours, [this] { return triple(4); });
  }

  // A single number is a point of a texture with one row. OBJ's v is up.
  [[nodiscard]] Uv texture_point() const {
    return {lines_.number_at(1), lines_.words().size() > 2 ? 1 - lines_.number_at(2) : 0};
  }

  // "s off" and "s 0" are flat. Faces before the first statement are a group of their own.
  std::uint32_t smoothing_group() {
    const std::string_view name = lines_.words().size() > 1 ? lines_.words()[1] : "off";
    if (name == "off" || name == "0") return RawMesh::kFlat;
    const auto next = static_cast<std::uint32_t>(RawMesh::kSmooth + 1 + smoothing_groups_.size());
    return smoothing_groups_.try_emplace(std::string(name), next).first->second;
  }

  /// A normal or a texture point of a corner, which may not be there.
  std::uint32_t optional_index(std::string_view text, std::int64_t so_far, std::int64_t total,
                               const char* what) {
    if (text.empty()) return FileMesh::kNone;
    const std::optional<std::uint32_t> index = index_of(text, so_far, total);
    if (!index) mesh_.left_out.add(std::string(what) + " of corners that do not exist");
    return index.value_or(FileMesh::kNone);
  }

  // One corner of a face: v, v/t, v//n or v/t/n.
  FileMesh::Corner corner(std::string_view word) {
    std::string_view part[3];
    std::size_t parts = 0;
    for (std::string_view rest = word; parts < 3; ++parts) {
      const std::size_t slash = rest.find('/');
      part[parts] = rest.substr(0, slash);
      if (slash == std::string_view::npos) break;
      if (parts == 2) lines_.fail(in_quotes(word) + " is not a corner of a face");
      rest.remove_prefix(slash + 1);
    }
    const std::optional<std::uint32_t> vertex = index_of(part[0], so_far_.vertices, total_.vertices);
    if (!vertex && !parse_integer(part[0])) lines_.fail(in_quotes(part[0]) + " is not a vertex index");
    if (!vertex) {
      lines_.fail("vertex index out of range (" + std::string(part[0]) + "; there are " +
                  std::to_string(total_.vertices) + ")");
    }
    return {*vertex, optional_index(part[2], so_far_.normals, total_.normals, "normals"),
            optional_index(part[1], so_far_.texture, total_.texture, "texture coordinates")};
  }

  void face() {
    const std::size_t corners = lines_.words().size() - 1;
    if (corners > static_cast<std::size_t>(kMostCorners)) {
      lines_.fail("a face has too many corners (" + std::to_string(corners) + "; the limit is " +
                  std::to_string(kMostCorners) + ")");
    }
    corners_.clear();
    for (std::size_t i = 1; i <= corners; ++i) corners_.push_back(corner(lines_.words()[i]));
    mesh_.add_face(corners_, {looks_.current(), smoothing_, {}});
  }

  TextLines lines_;
  FileMesh mesh_;
  Counts total_{};
  Counts so_far_{};
  ObjLooks looks_{};
  std::vector<FileMesh::Corner> corners_{};
  std::uint32_t smoothing_ = RawMesh::kSmooth;
  std::map<std::string, std::uint32_t, std::less<>> smoothing_groups_{};
};

}  // namespace

RawModel read_obj(std::string_view bytes, const std::string& subject, const SideFiles& files) {
  const std::string text = plain_text(bytes);
  require_text(text, subject);
  return ObjReader(text, subject, files).read(files);
}

}  // namespace arcspan::tools
