// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/colour_scale.hpp>
#include <arcspan_tools/mesh/file/ply_header.hpp>
#include <arcspan_tools/mesh/file/tagged_obj.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/mesh/file/validate.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>

namespace arcspan::tools {
namespace {

constexpr std::int64_t kMostInList = 1 << 20;

void append_decimal(std::string& out, double value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  out.append(text, end);
}

/// How many words an element needs, of which a line holds the first ones.
std::size_t words_needed(const PlyElement& element, const std::vector<std::string_view>& words) {
  std::size_t needed = 0;
  for (const PlyProperty& property : element.properties) {
    if (property.count_type && needed < words.size()) {
      const std::int64_t length = parse_integer(words[needed]).value_or(0);
      needed += static_cast<std::size_t>(std::clamp<std::int64_t>(length, 0, kMostInList));
    }
    ++needed;
  }
  return needed;
}

/// Whether every element has a line of its own in a text, which may hold more than the header says. Otherwise
/// lines may break anywhere.
bool is_line_by_line(std::string_view body, const PlyHeader& header) {
  TextLines lines(body, "");
  const auto next = [&lines] {
    bool more = lines.next();
    while (more && lines.words().empty()) more = lines.next();
    return more;
  };
  for (const PlyElement& element : header.elements) {
    for (std::int64_t i = 0; i < element.count; ++i) {
      if (!next() || lines.words().size() < words_needed(element, lines.words())) return false;
    }
  }
  return !next();
}

/// The numbers of a PLY body, one after the other, from text or from either byte order.
class PlyBody {
 public:
  PlyBody(TextLines& lines, const PlyHeader& header)
      : lines_(lines), encoding_(header.encoding), bytes_(lines.rest()), word_(lines.words().size()) {
    line_by_line_ = encoding_ == PlyEncoding::kText && is_line_by_line(bytes_, header);
  }

  /// Starts the next element; `what` names it in messages.
  void begin(std::string what) {
    what_ = std::move(what);
    if (line_by_line_) next_line();
  }

  double number(PlyType type) {
    const double value = encoding_ == PlyEncoding::kText ? text() : binary(type);
    if (!std::isfinite(value)) fail("a number that is not finite in " + what_);
    if (std::fabs(value) > kMostCoordinate) fail("a number above 1e30 in " + what_);
    return value;
  }

  /// Numbers that are left over in a text without lines mean that others were taken for what they are not.
  void end() {
    if (encoding_ != PlyEncoding::kText || line_by_line_) return;
    if (word_ < lines_.words().size()) fail("more numbers than the header announces");
    while (lines_.next()) {
      if (!lines_.words().empty()) fail("more numbers than the header announces");
    }
  }

  std::int64_t integer(PlyType type, std::int64_t least, std::int64_t most, const char* what) {
    const double value = number(type);
    if (value >= static_cast<double>(least) && value <= static_cast<double>(most) &&
        value == std::floor(value)) {
      return static_cast<std::int64_t>(value);
    }
    std::string text;
    append_decimal(text, value);
    fail(std::string(what) + " out of range (" + text + "; allowed are " + std::to_string(least) + " to " +
         std::to_string(most) + ") in " + what_);
  }

  [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }

 private:
  void next_line() {
    lines_.next_words(what_);
    word_ = 0;
  }

  double text() {
    if (!line_by_line_ && word_ >= lines_.words().size()) next_line();
    return lines_.number_at(word_++);
  }

  double binary(PlyType type) {
    if (bytes_.size() < type.bytes) fail("the file ends before " + what_);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.bytes; ++i) {
      const std::size_t from = encoding_ == PlyEncoding::kBigEndian ? type.bytes - 1 - i : i;
      bits |= std::uint64_t{static_cast<unsigned char>(bytes_[from])} << (8 * i);
    }
    bytes_.remove_prefix(type.bytes);
    if (type.kind == PlyType::Kind::kFloat) {
      return type.bytes == 8 ? std::bit_cast<double>(bits)
                             : double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
    }
    const double magnitude = static_cast<double>(bits);
    const double range = std::ldexp(1.0, 8 * type.bytes);
    return type.kind == PlyType::Kind::kSigned && magnitude >= range / 2 ? magnitude - range : magnitude;
  }

  TextLines& lines_;
  PlyEncoding encoding_;
  std::string_view bytes_;
  std::string what_;
  std::size_t word_;  ///< the next one of the current line
  bool line_by_line_ = false;
};

std::size_t property_index(const PlyElement& element, std::string_view name) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (element.properties[i].name == name && !element.properties[i].count_type) return i;
  }
  return element.properties.size();
}

void skip(PlyBody& body, const PlyProperty& property) {
  std::int64_t numbers = 1;
  if (property.count_type) numbers = body.integer(*property.count_type, 0, kMostInList, "length of a list");
  for (std::int64_t i = 0; i < numbers; ++i) (void)body.number(property.type);
}

std::string nth(const PlyElement& element, std::int64_t i) {
  return element.name + " " + std::to_string(i + 1) + " of " + std::to_string(element.count);
}

using PlyColour = std::optional<Vec3>;

/// The properties of an element that are its colour, if it has one.
class ColourProperties {
 public:
  explicit ColourProperties(const PlyElement& element) : element_(element) {
    static constexpr const char* kNames[2][3] = {{"red", "green", "blue"},
                                                 {"diffuse_red", "diffuse_green", "diffuse_blue"}};
    for (const auto& names : kNames) {
      for (std::size_t i = 0; i < 3; ++i) at_[i] = property_index(element, names[i]);
      const std::size_t none = element.properties.size();
      has_colour_ = at_[0] != none && at_[1] != none && at_[2] != none;
      if (has_colour_) return;
    }
  }

  [[nodiscard]] bool any() const { return has_colour_; }
  /// The colour in an element's values: of integers 0...1; floats are as they are in the file.
  [[nodiscard]] PlyColour colour(const std::vector<double>& values) const {
    if (!has_colour_) return std::nullopt;
    return Vec3{channel(values, at_[0]), channel(values, at_[1]), channel(values, at_[2])};
  }

 private:
  [[nodiscard]] double channel(const std::vector<double>& values, std::size_t i) const {
    const PlyType type = element_.properties[i].type;
    if (type.kind == PlyType::Kind::kFloat) return values[i];
    const int bits = 8 * type.bytes - (type.kind == PlyType::Kind::kSigned ? 1 : 0);
    return std::clamp(values[i] / (std::ldexp(1.0, bits) - 1), 0.0, 1.0);
  }

  const PlyElement& element_;
  std::size_t at_[3]{};
  bool has_colour_ = false;
};

/// The properties of an element that are its texture coordinates, under any of the names in use. `v` is up.
std::optional<std::array<std::size_t, 2>> texture_properties(const PlyElement& element) {
  static constexpr const char* kNames[][2] = {
      {"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}};
  for (const auto& names : kNames) {
    const std::array<std::size_t, 2> at{property_index(element, names[0]), property_index(element, names[1])};
    if (at[0] < element.properties.size() && at[1] < element.properties.size()) return at;
  }
  return std::nullopt;
}

struct PlyScreen {
  const PlyHeader& header;
  PlyBody body;
  TriangleCount triangles;
  std::int64_t vertex_count;  ///< announced, because faces may come first
  TaggedObj faces;
  std::string vertices{};
  std::vector<PlyColour> vertex_colours{};
  std::vector<std::optional<Uv>> texture_points{};
  std::vector<PlyColour> face_colours{};
  bool has_normals = false;

  void read_vertices(const PlyElement& element) {
    static constexpr const char* kNames[] = {"x", "y", "z", "nx", "ny", "nz"};
    std::size_t at[6];
    for (std::size_t i = 0; i < 6; ++i) at[i] = property_index(element, kNames[i]);
    const std::size_t none = element.properties.size();
    if (at[0] == none || at[1] == none || at[2] == none) body.fail("the vertices have no x, y and z");
    has_normals = at[3] != none && at[4] != none && at[5] != none;
    const ColourProperties colours(element);
    std::vector<double> values(element.properties.size());
    for (std::int64_t v = 0; v < element.count; ++v) {
      body.begin(nth(element, v));
      for (std::size_t p = 0; p < none; ++p) {
        if (element.properties[p].count_type) {
          skip(body, element.properties[p]);
        } else {
          values[p] = body.number(element.properties[p].type);
        }
      }
      write_vertex(values, at);
      if (colours.any()) vertex_colours.push_back(colours.colour(values));
      if (const std::optional<std::array<std::size_t, 2>> point = texture_properties(element)) {
        texture_points.emplace_back(Uv{values[(*point)[0]], 1 - values[(*point)[1]]});
      }
    }
  }

  void write_vertex(const std::vector<double>& values, const std::size_t (&at)[6]) {
    for (std::size_t i = 0; i < (has_normals ? 6u : 3u); ++i) {
      if (i % 3 == 0) vertices += i == 0 ? "v" : "\nvn";
      vertices += ' ';
      append_decimal(vertices, values[at[i]]);
    }
    vertices += '\n';
  }

  [[nodiscard]] bool has_indices(const PlyProperty& property) const {
    return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  void add_face(const std::vector<std::int64_t>& corners) {
    triangles.add_face(static_cast<std::int64_t>(corners.size()));
    for (const std::int64_t corner : corners) {
      faces.corner(corner + 1, has_normals ? corner + 1 : 0, corner);
    }
    faces.end_face();
  }

  void read_face(const PlyProperty& property) {
    const std::int64_t corners = body.integer(*property.count_type, 0, kMostCorners, "number of corners");
    std::vector<std::int64_t> face;
    for (std::int64_t c = 0; c < corners; ++c) {
      face.push_back(body.integer(property.type, 0, vertex_count - 1, "vertex index"));
    }
    if (corners >= 3) add_face(face);
  }

  // Every vertex from the third one on makes a triangle with the two before it, turned over at every second
  // one. -1 starts a new strip. A vertex that occurs twice in a triangle joins two strips.
  void read_strips(const PlyProperty& property) {
    const std::int64_t length = body.integer(*property.count_type, 0, kMostInList, "length of a list");
    std::int64_t a = -1;
    std::int64_t b = -1;
    bool turned = false;
    for (std::int64_t i = 0; i < length; ++i) {
      const std::int64_t c = body.integer(property.type, -1, vertex_count - 1, "vertex index");
      if (a >= 0 && c >= 0 && a != b && b != c && c != a) {
        add_face({turned ? b : a, turned ? a : b, c});
      }
      turned = c >= 0 && a >= 0 && !turned;
      a = c < 0 ? -1 : b;
      b = c;
    }
  }

  void read_element(const PlyElement& element, const ColourProperties& colours) {
    std::vector<double> values(element.properties.size());
    for (std::size_t p = 0; p < values.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (element.name == "face" && has_indices(property)) {
        read_face(property);
      } else if (element.name == "tristrips" && has_indices(property)) {
        read_strips(property);
      } else if (property.count_type) {
        skip(body, property);
      } else {
        values[p] = body.number(property.type);
      }
    }
    face_colours.resize(static_cast<std::size_t>(faces.faces()), colours.colour(values));
  }

  void read(const PlyElement& element, const std::string& subject) {
    if (element.name == "vertex") return read_vertices(element);
    if (element.name == "face" && element.count > std::int64_t{kMaxTriangles}) {
      throw Failure(subject, "too many faces (" + std::to_string(element.count) + "; the limit is " +
                                 std::to_string(kMaxTriangles) + ")");
    }
    const ColourProperties colours(element);
    for (std::int64_t i = 0; i < element.count; ++i) {
      body.begin(nth(element, i));
      read_element(element, colours);
    }
  }

  [[nodiscard]] ScreenedMesh result() {
    ScreenedMesh out{vertices + faces.text(), MeshFormat::kObj};
    if (!faces.tagged()) return out;
    out.vertex_colours = scaled_colours(std::move(vertex_colours));
    out.texture_points = std::move(texture_points);
    for (const PlyColour& colour : scaled_colours(std::move(face_colours))) {
      out.faces.push_back({0, RawMesh::kSmooth, colour});
    }
    out.faces.resize(static_cast<std::size_t>(faces.faces()));
    return out;
  }
};

/// Whether an element has colours, or vertices have texture coordinates.
bool needs_tags(const PlyHeader& header) {
  return std::any_of(header.elements.begin(), header.elements.end(), [](const PlyElement& element) {
    return ColourProperties(element).any() ||
           (element.name == "vertex" && texture_properties(element).has_value());
  });
}

/// How many vertices the header announces.
std::int64_t vertex_count_of(const PlyHeader& header, const std::string& subject) {
  std::int64_t count = 0;
  std::size_t elements = 0;
  for (const PlyElement& element : header.elements) {
    if (element.name != "vertex") continue;
    count = element.count;
    ++elements;
  }
  if (elements > 1) throw Failure(subject, "two elements are named 'vertex'");
  if (count == 0) throw Failure(subject, "no vertices");
  return count;
}

}  // namespace

// The file is rewritten as OBJ text for the library, with positions, normals and faces only.
ScreenedMesh screened_ply(std::string_view bytes, const std::string& subject) {
  const std::string plain = plain_text(bytes);
  TextLines lines(plain, subject);
  const PlyHeader header = read_ply_header(lines);
  const std::int64_t vertices = vertex_count_of(header, subject);
  PlyScreen screen{header, PlyBody(lines, header), TriangleCount(subject), vertices,
                   TaggedObj(needs_tags(header))};
  for (const PlyElement& element : header.elements) {
    // Nothing in the file would stop the count of an element without properties.
    if (element.properties.empty() && element.count > 0)
      lines.fail("element " + in_quotes(element.name) + " is empty");
    screen.read(element, subject);
  }
  screen.body.end();
  if (screen.faces.faces() == 0) throw Failure(subject, "no faces");
  return screen.result();
}

}  // namespace arcspan::tools
