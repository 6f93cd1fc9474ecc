// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/element_text.hpp>
#include <arcspan_tools/mesh/file/file_mesh.hpp>
#include <arcspan_tools/mesh/file/ply_header.hpp>
#include <arcspan_tools/mesh/file/read_mesh.hpp>
#include <arcspan_tools/support/parse.hpp>
#include <arcspan_tools/support/text.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace arcspan::tools {
namespace {

constexpr std::int64_t kMostInList = 1 << 20;

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
ElementText::Breaks breaks_of(TextLines lines, const PlyHeader& header) {
  if (header.encoding != PlyEncoding::kText) return ElementText::Breaks::kAnywhere;
  bool own = true;
  for (const PlyElement& element : header.elements) {
    own = own && has_lines(lines, element.count, [&element](const std::vector<std::string_view>& words) {
            return words_needed(element, words);
          });
  }
  while (own && lines.next()) own = lines.words().empty();
  return own ? ElementText::Breaks::kAfterElements : ElementText::Breaks::kAnywhere;
}

/// The numbers of a PLY body, one after the other, from text or from either byte order.
class PlyBody {
 public:
  PlyBody(TextLines& lines, const PlyHeader& header)
      : lines_(lines),
        encoding_(header.encoding),
        bytes_(lines.rest()),
        text_(lines, breaks_of(lines, header), lines.words().size()) {}

  /// Starts the next element; `what` names it in messages.
  void begin(const std::string& what) {
    what_ = what;
    if (is_text()) text_.begin(what);
  }

  /// The next number; NaN for a word that is none.
  double number(PlyType type) { return is_text() ? text_.number() : binary(type); }

  void end() {
    if (is_text()) text_.end();
  }

  std::int64_t integer(PlyType type, std::int64_t least, std::int64_t most, const char* what) {
    const double value = number(type);
    if (value >= static_cast<double>(least) && value <= static_cast<double>(most) &&
        value == std::floor(value)) {
      return static_cast<std::int64_t>(value);
    }
    fail(formatted("%s out of range (%.9g; allowed are ", what, value) + std::to_string(least) + " to " +
         std::to_string(most) + ")");
  }

  [[noreturn]] void fail(const std::string& what) const { lines_.fail(what + " in " + what_); }

 private:
  [[nodiscard]] bool is_text() const { return encoding_ == PlyEncoding::kText; }

  double binary(PlyType type) {
    if (bytes_.size() < type.bytes) lines_.fail("the file ends before " + what_);
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
  ElementText text_;
  std::string what_;
};

std::size_t property_index(const PlyElement& element, std::string_view name) {
  const auto found =
      std::find_if(element.properties.begin(), element.properties.end(), [name](const PlyProperty& property) {
        return same_letters(property.name, name) && !property.count_type;
      });
  return static_cast<std::size_t>(found - element.properties.begin());
}

/// The properties of an element under the first of these sets of names that it has as a whole.
template <std::size_t N>
std::optional<std::array<std::size_t, N>> properties_of(
    const PlyElement& element, std::initializer_list<std::array<const char*, N>> sets) {
  for (const std::array<const char*, N>& names : sets) {
    std::array<std::size_t, N> at{};
    for (std::size_t i = 0; i < N; ++i) at[i] = property_index(element, names[i]);
    if (std::find(at.begin(), at.end(), element.properties.size()) == at.end()) return at;
  }
  return std::nullopt;
}

/// The colour of an element, if it has one.
class ColourProperties {
 public:
  explicit ColourProperties(const PlyElement& element)
      : element_(element),
        at_(properties_of<3>(
            element,
            {{"red", "green", "blue"}, {"diffuse_red", "diffuse_green", "diffuse_blue"}, {"r", "g", "b"}})),
        alpha_at_(properties_of<1>(element, {{"alpha"}, {"diffuse_alpha"}, {"a"}})) {}

  [[nodiscard]] bool any() const { return at_.has_value(); }
  /// The colour in an element's values: of integers 0...1; floats are as they are in the file.
  [[nodiscard]] std::optional<Vec3> colour(const std::vector<double>& values, LeftOut& left_out) const {
    if (!at_) return std::nullopt;
    if (alpha_at_ && channel(values, (*alpha_at_)[0]) < 1) left_out.add(kOpacityOfVertices);
    const Vec3 c{channel(values, (*at_)[0]), channel(values, (*at_)[1]), channel(values, (*at_)[2])};
    if (finite(c)) return c;
    left_out.add(kWrongColours);
    return std::nullopt;
  }

 private:
  [[nodiscard]] double channel(const std::vector<double>& values, std::size_t i) const {
    const PlyType type = element_.properties[i].type;
    if (type.kind == PlyType::Kind::kFloat) return values[i];
    // Integers of 32 bits hold bytes in the files of all programs.
    if (type.bytes == 4) return std::clamp(values[i] / 255, 0.0, 1.0);
    const int bits = 8 * type.bytes - (type.kind == PlyType::Kind::kSigned ? 1 : 0);
    return std::clamp(values[i] / (std::ldexp(1.0, bits) - 1), 0.0, 1.0);
  }

  const PlyElement& element_;
  std::optional<std::array<std::size_t, 3>> at_;
  std::optional<std::array<std::size_t, 1>> alpha_at_;
};

/// The properties that a picture needs of a vertex.
struct VertexProperties {
  std::optional<std::array<std::size_t, 3>> position{};
  std::optional<std::array<std::size_t, 3>> normal{};
  std::optional<std::array<std::size_t, 2>> texture_point{};  ///< v is up

  VertexProperties() = default;
  explicit VertexProperties(const PlyElement& element)
      : position(properties_of<3>(element, {{"x", "y", "z"}})),
        normal(properties_of<3>(element, {{"nx", "ny", "nz"}})),
        texture_point(properties_of<2>(
            element, {{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}})) {}
};

class PlyReader {
 public:
  PlyReader(TextLines& lines, const PlyHeader& header, std::int64_t vertices, const std::string& subject)
      : body_(lines, header), vertices_(vertices), mesh_(subject) {
    for (const PlyElement& element : header.elements) {
      if (element.name == "vertex") of_vertices_ = VertexProperties(element);
    }
    if (!of_vertices_.position) lines.fail("the vertices have no x, y and z");
  }

  void read(const PlyElement& element) {
    const ColourProperties colours(element);
    values_.resize(element.properties.size());
    for (std::int64_t i = 1; i <= element.count; ++i) {
      body_.begin(element.name + " " + std::to_string(i) + " of " + std::to_string(element.count));
      faces_.clear();
      for (std::size_t p = 0; p < values_.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        if (property.count_type) {
          read_list(element, property);
        } else {
          values_[p] = body_.number(property.type);
        }
      }
      const std::optional<Vec3> colour = colours.colour(values_, mesh_.left_out);
      for (const auto& face : faces_) mesh_.add_face(face, {0, RawMesh::kSmooth, colour});
      if (element.name != "vertex") continue;
      add_vertex();
      if (colours.any()) mesh_.colours.push_back(colour);
    }
  }

  [[nodiscard]] RawModel model() {
    body_.end();
    return mesh_.model();
  }

 private:
  void read_list(const PlyElement& element, const PlyProperty& property) {
    const std::int64_t size = body_.integer(*property.count_type, 0, kMostInList, "length of a list");
    const bool indices = property.name == "vertex_indices" || property.name == "vertex_index";
    if (indices && element.name == "face") {
      read_face(property, size);
    } else if (indices && element.name == "tristrips") {
      read_strips(property, size);
    } else {
      if (property.name == "texcoord") mesh_.left_out.add("texture coordinates of faces");
      for (std::int64_t i = 0; i < size; ++i) (void)body_.number(property.type);
    }
  }

  void read_face(const PlyProperty& property, std::int64_t corners) {
    if (corners > kMostCorners)
      body_.fail("too many corners (" + std::to_string(corners) + "; the limit is 4096)");
    std::vector<std::int64_t> face;
    for (std::int64_t c = 0; c < corners; ++c) {
      face.push_back(body_.integer(property.type, 0, vertices_ - 1, "vertex index"));
    }
    add_face(face);
  }

  // Every vertex from the third one on makes a triangle with the two before it, turned over at every second
  // one. -1 starts a new strip. A vertex that occurs twice in a triangle joins two strips.
  void read_strips(const PlyProperty& property, std::int64_t length) {
    std::int64_t a = -1;
    std::int64_t b = -1;
    bool turned = false;
    for (std::int64_t i = 0; i < length; ++i) {
      const std::int64_t c = body_.integer(property.type, -1, vertices_ - 1, "vertex index");
      if (a >= 0 && c >= 0 && a != b && b != c && c != a) {
        add_face({turned ? b : a, turned ? a : b, c});
      }
      turned = c >= 0 && a >= 0 && !turned;
      a = c < 0 ? -1 : b;
      b = c;
    }
  }

  void add_face(const std::vector<std::int64_t>& indices) {
    std::vector<FileMesh::Corner>& corners = faces_.emplace_back();
    for (const std::int64_t index : indices) {
      const auto i = static_cast<std::uint32_t>(index);
      corners.push_back(
          {i, of_vertices_.normal ? i : FileMesh::kNone, of_vertices_.texture_point ? i : FileMesh::kNone});
    }
  }

  void add_vertex() {
    const auto triple = [this](const auto& at) {
      const Vec3 v{values_[at[0]], values_[at[1]], at.size() > 2 ? values_[at.back()] : 0};
      if (!is_coordinate(v)) body_.fail("a coordinate is not a number up to 1e30");
      return v;
    };
    mesh_.add_position([&] { return triple(*of_vertices_.position); });
    if (const auto& normal = of_vertices_.normal) {
      mesh_.normals.push_back(mesh_.if_right(kWrongNormals, [&] { return triple(*normal); }));
    }
    if (const auto& point = of_vertices_.texture_point) {
      mesh_.texture_points.push_back(mesh_.if_right(kWrongTexturePoints, [&] {
        const Vec3 uv = triple(*point);
        return Uv{uv.x, 1 - uv.y};
      }));
    }
  }

  PlyBody body_;
  std::int64_t vertices_;  ///< announced, because faces may come first
  FileMesh mesh_;
  VertexProperties of_vertices_{};
  // Of the current element:
  std::vector<double> values_{};
  std::vector<std::vector<FileMesh::Corner>> faces_{};
};

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

RawModel read_ply(std::string_view bytes, const std::string& subject) {
  const std::string plain = plain_text(bytes);
  TextLines lines(plain, subject);
  const PlyHeader header = read_ply_header(lines);
  PlyReader reader(lines, header, vertex_count_of(header, subject), subject);
  for (const PlyElement& element : header.elements) {
    // Nothing in the file would stop the count of an element without properties.
    if (element.properties.empty() && element.count > 0)
      lines.fail("element " + in_quotes(element.name) + " is empty");
    reader.read(element);
  }
  return reader.model();
}

}  // namespace arcspan::tools
